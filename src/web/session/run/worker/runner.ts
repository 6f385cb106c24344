import type { InputAction, InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';
import type { RunOutlets } from '#simulation/outlets';
import type { Ended } from '#simulation/simulation';

import type { Snapshot } from '#simulation/snapshot';
import { readVariables } from '#vm/debug/variables';
import { createEventBoxes } from './event-box';
import { append, createOutbox, type Output } from './outbox';
import { Pace, type PaceMessage } from './pace';
import { createSpeedMeter, nextPieceUs } from './pacing';
import type { FromWorker, ToWorker } from './protocol';
import { createStillness } from './stillness';
import { FAREWELL_MS } from './stop-limits';
import { Stops, type Debugged } from './stops';
import { TapeBox } from './tape-box';

/** The used part of a `Simulation`. */
export interface Run extends Debugged {
  readonly nowUs: number;
  /** End of each device's program, in their order. */
  readonly endings: readonly (Ended | null)[];
  /** Every program has ended. */
  readonly hasEnded: boolean;
  /** Nothing is set for later; while nothing moves either, nothing happens until the next input. */
  readonly isIdle: boolean;
  readonly inputLog: readonly InputEvent[];
  advanceTo(us: number): void;
  /** Like `advanceTo`, but stops when the program ends, or the last of several. */
  advanceProgramTo(us: number): void;
  input(action: InputAction, device?: string): void;
  /** Ends the programs as Stop does: their `finally` runs, and the traceback is not shown. */
  stop(): void;
  snapshot(): Snapshot;
  dispose(): void;
}

/** The runner's surroundings, so that a test can replace the worker. */
export interface Surroundings {
  post(message: FromWorker): void;
  /** Wall clock in ms. */
  nowMs(): number;
  /** Calls `task` after `delayMs`, letting messages in first; 0 means as soon as they are in. */
  later(task: () => void, delayMs: number): void;
  create(setup: RunSetup, firmware: WebAssembly.Module, outlets: RunOutlets): Promise<Run>;
}

type InputMessage = Extract<ToWorker, { type: 'input' }>;

/** Longest stretch without looking at messages, in ms of wall time: half a frame. */
const SLICE_MS = 8;
/** Rest between two slices when the run is on time, in ms. */
const REST_MS = 8;
/** Time between two heartbeats, in ms. */
const HEARTBEAT_MS = 100;

/** Drives one run by the page's messages: lets simulated time pass in slices, at the pace of the wall clock times the speed. */
export class Runner {
  private firmware: WebAssembly.Module | null = null;
  private run: Run | null = null;
  private stopped = false;
  private pieceUs = 4000;
  private frameWanted = false;
  private changed = true;
  /** End of each program, as reported to the page. */
  private toldEnds: readonly (Ended | null)[] = [];
  private ticking = false;
  private resting = false;
  private aliveAtMs = 0;
  /** Inputs received while the run was being created. */
  private readonly early: InputMessage[] = [];
  private events = createEventBoxes(1);
  private readonly stillness = createStillness();
  private readonly meter = createSpeedMeter();
  private readonly pace = new Pace();
  /** Output of the current piece of simulated time: it is sent to the page as one. */
  private readonly printed: Output[] = [];
  private readonly outbox = createOutbox((output) => this.at.post({ type: 'console', output }));

  private readonly tape = new TapeBox((message) => this.at.post(message));
  private readonly stops = new Stops();

  constructor(private readonly at: Surroundings) {}

  /** Handles a message of the page. */
  receive(message: ToWorker): void {
    switch (message.type) {
      case 'prepare':
        this.firmware = message.firmware;
        this.at.post({ type: 'prepared' });
        break;
      case 'run':
        this.pace.begin(message);
        this.start(message.setup);
        break;
      case 'stop':
        this.stop();
        break;
      case 'frame':
        this.frameWanted = true;
        if (this.pace.paused) this.schedule(0);
        break;
      case 'console-taken':
        this.outbox.taken();
        this.schedule(0);
        break;
      case 'input':
        this.input(message);
        break;
      case 'tape':
        if (this.run !== null) this.tape.tellAll(this.run);
        break;
      case 'break-points':
        this.stops.setPoints(message.points, this.pace.isCatchingUp ? null : this.run);
        break;
      case 'inspect':
        this.tellVariables(message.device);
        break;
      default:
        this.changePace(message);
    }
  }

  private changePace(message: PaceMessage): void {
    const { run } = this;
    if (message.type === 'step-line') {
      if (run === null || run.hasEnded) return;
      this.stops.begin(message.step, message.device, run);
    } else if (message.type === 'pause') this.stops.end(run);
    this.pace.change(message, run?.nowUs ?? 0);
    this.anchorHere();
    this.schedule(0);
  }

  private start(setup: RunSetup): void {
    if (this.firmware === null) return this.fail(new Error('run before prepare'));
    this.events = createEventBoxes(setup.devices.length);
    const print = (text: string, device: number): void =>
      append(this.printed, { device, text, timeUs: this.run?.nowUs ?? 0 });
    const { moment, isMomentWanted } = this.tape;
    this.at.create(setup, this.firmware, { ...this.events.outlets, print, moment, isMomentWanted }).then(
      (created) => {
        this.run = created;
        this.toldEnds = created.endings;
        if (!this.pace.isCatchingUp) this.stops.applyAll(created);
        this.anchorHere();
        this.at.post({ type: 'started' });
        for (const message of this.early.splice(0)) this.input(message);
        if (this.stopped) this.stop();
        else this.schedule(0);
      },
      (error: unknown) => this.fail(error),
    );
  }

  private input(message: InputMessage): void {
    if (this.stopped) return;
    const { run } = this;
    if (run === null) {
      this.early.push(message);
      return;
    }
    this.guarded(() => {
      try {
        run.input(message.action, message.device);
      } catch (error) {
        if (!(error instanceof RangeError)) throw error;
        // Rejected: none of it took effect, and the run continues as if it had not been sent.
        this.at.post({ type: 'refused', message: error.message });
      }
    });
    this.changed = true;
    this.schedule(0);
  }

  /**
   * Ends the run: the program is interrupted, gets a moment for its `finally`, and all of its output and the last picture
   * are sent.
   */
  private stop(): void {
    this.stopped = true;
    const run = this.run;
    if (run === null) return; // still being created: start() returns here
    this.guarded(() => {
      if (!run.hasEnded) {
        this.stops.end(run);
        this.stops.setPoints([], run);
        run.stop();
        const untilMs = this.at.nowMs() + FAREWELL_MS;
        while (!run.hasEnded && this.at.nowMs() < untilMs) run.advanceProgramTo(run.nowUs + 4000);
        this.outbox.put(this.printed.splice(0));
      }
      this.outbox.flush();
      this.tellEvents();
      this.tape.tellAll(run);
      this.tellPicture(run);
      run.dispose();
      this.run = null;
      this.at.post({ type: 'stopped' });
    });
  }

  private tick(): void {
    this.ticking = false;
    const run = this.run;
    if (run === null || this.stopped) return;
    this.guarded(() => {
      if (this.resting) this.wake();
      this.tape.setThin(this.pace.isUnbound);
      this.advance(run, this.at.nowMs() + SLICE_MS);
      this.endCatchingUp(run);
      const nowMs = this.at.nowMs();
      this.meter.note(nowMs, run.nowUs);
      this.pace.forgetBacklog(nowMs, run.nowUs);
      this.tell(run, nowMs);
      const behind = run.nowUs < this.limitUs(run);
      if (behind) this.schedule(0);
      else if (this.mayRest(run)) this.rest(run);
      else if (!this.pace.paused) this.schedule(REST_MS);
    });
  }

  /**
   * True if all programs have ended, and nothing happens any more: then time need not pass, and the machine can rest.
   */
  private mayRest(run: Run): boolean {
    const isIdle = !this.pace.paused && this.hasToldEnd && run.isIdle && this.outbox.isEmpty;
    return isIdle ? this.stillness.look(run.snapshot()) : this.stillness.forget();
  }

  private rest(run: Run): void {
    this.resting = true;
    this.tellPicture(run);
    this.at.post({ type: 'resting' });
  }

  /** Time continues from here, not from the current wall clock. */
  private wake(): void {
    this.resting = false;
    this.stillness.forget();
    this.anchorHere();
  }

  private advance(run: Run, untilMs: number): void {
    const limitUs = this.limitUs(run);
    // When the program has ended, the page is notified before the REPL's first output.
    while (run.nowUs < limitUs && !this.outbox.isFull && !this.hasNewEnd(run)) {
      const startMs = this.at.nowMs();
      if (startMs >= untilMs) return;
      const nextUs = Math.min(limitUs, run.nowUs + this.pieceUs);
      if (run.hasEnded) run.advanceTo(nextUs);
      else run.advanceProgramTo(nextUs);
      this.changed = true;
      this.pieceUs = nextPieceUs(this.pieceUs, this.at.nowMs() - startMs);
      this.outbox.put(this.printed.splice(0));
      if (run.heldBy !== null) return this.hold(run, run.heldBy);
    }
  }

  /** A breakpoint or a step has stopped the run: simulated time is paused. */
  private hold(run: Run, device: number): void {
    this.changePace({ type: 'pause' });
    this.tellPicture(run);
    this.at.post({ type: 'held', device, timeUs: run.timeOf(device) });
  }

  private tellVariables(device: number): void {
    const vm = this.run?.inspect(device) ?? null;
    if (this.run === null || vm === null) return;
    this.at.post({ type: 'variables', device, timeUs: this.run.timeOf(device), variables: readVariables(vm) });
  }

  /** Simulated time the run may reach now. */
  private limitUs(run: Run): number {
    return this.outbox.isFull ? run.nowUs : this.pace.limitUs(run.nowUs, this.at.nowMs());
  }

  /** Sends the page everything it is waiting for. */
  private tell(run: Run, nowMs: number): void {
    if (this.frameWanted && this.changed) {
      this.frameWanted = this.changed = false;
      this.tellPicture(run);
    }
    this.tellEvents();
    this.tellEnd(run);
    if (nowMs - this.aliveAtMs >= HEARTBEAT_MS) {
      this.aliveAtMs = nowMs;
      this.at.post({ type: 'alive', nowUs: run.nowUs, achieved: this.pace.paused ? null : this.meter.factor() });
    }
  }

  private tellPicture(run: Run): void {
    this.at.post({ type: 'snapshot', snapshot: run.snapshot(), trails: this.events.takeTrails() });
  }

  /** The run has reached its target: from here on it goes at its pace. */
  private endCatchingUp(run: Run): void {
    if (!this.pace.endCatchingUp(run.nowUs)) return;
    this.stops.applyAll(run);
    this.anchorHere();
  }

  private tellEvents(): void {
    this.tape.tell();
    for (const news of this.events.take()) this.at.post({ type: 'events', ...news });
  }

  private tellEnd(run: Run): void {
    if (!this.hasNewEnd(run) || !this.outbox.isEmpty) return;
    const before = this.toldEnds;
    this.toldEnds = run.endings;
    if (this.pace.speed === 'max') this.anchorHere();
    // A listener of the end must see the robot as the program left it, not the picture before.
    this.tellPicture(run);
    for (const [device, ended] of this.toldEnds.entries())
      if (ended !== (before[device] ?? null))
        this.at.post(ended ? { type: 'program-ended', ended, device } : { type: 'program-restarted', device });
    this.tape.setOver(this.hasToldEnd, run);
  }

  /** A program has ended or restarted since the last report to the page. */
  private hasNewEnd({ endings }: Run): boolean {
    return endings.some((ended, device) => ended !== this.toldEnds[device]);
  }

  /** The page knows that all programs have ended. */
  private get hasToldEnd(): boolean {
    return this.toldEnds.length > 0 && !this.toldEnds.includes(null);
  }

  private schedule(delayMs: number): void {
    if (this.ticking) return;
    this.ticking = true;
    this.at.later(() => this.tick(), delayMs);
  }

  private anchorHere(): void {
    this.pace.anchorAt(this.at.nowMs(), this.run?.nowUs ?? 0, this.hasToldEnd);
    this.meter.reset();
  }

  /** Runs `task`. An error in it is our mistake: it ends the run and is reported to the page. */
  private guarded(task: () => void): void {
    try {
      task();
    } catch (error) {
      this.fail(error);
    }
  }

  private fail(error: unknown): void {
    this.stopped = true;
    this.at.post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}
