import type { InputAction } from '#simulation/input';
import type { Speed } from '#simulation/pace';
import type { RunSetup } from '#simulation/run-setup';
import type { RunOutlets } from '#simulation/outlets';
import type { Ended } from '#simulation/simulation';

import type { Snapshot } from '#simulation/snapshot';
import { createEventBox } from './event-box';
import { createOutbox } from './outbox';
import { createSpeedMeter, dueUs, nextPieceUs, withoutBacklog, type Anchor } from './pacing';
import { STEP_PRESS_US, type FromWorker, type ToWorker } from './protocol';
import { createStillness } from './stillness';
import { FAREWELL_MS } from './stop-limits';

/** What the runner needs of a `Simulation`. */
export interface Run {
  readonly nowUs: number;
  readonly ended: Ended | null;
  /** Nothing is set for later; while nothing moves either, nothing happens until the next input. */
  readonly isIdle: boolean;
  advanceTo(us: number): void;
  /** Like `advanceTo`, but stops at once when the program ends. */
  advanceProgramTo(us: number): void;
  input(action: InputAction): void;
  /** Ends the program as Stop does: its `finally` runs, and the traceback is not shown. */
  stop(): void;
  snapshot(): Snapshot;
  takeConsole(): string;
  dispose(): void;
}

/** The runner's surroundings, so that a test can stand in for the worker. */
export interface Surroundings {
  post(message: FromWorker): void;
  /** Wall clock in ms. */
  nowMs(): number;
  /** Calls `task` after `delayMs`, letting messages in first; 0 means as soon as they are in. */
  later(task: () => void, delayMs: number): void;
  create(setup: RunSetup, firmware: WebAssembly.Module, outlets: RunOutlets): Promise<Run>;
}

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
  private paused = false;
  private speed: Speed = 1;
  private stepUntilUs = 0;
  private pieceUs = 4000;
  private anchor: Anchor = { wallMs: 0, simulatedUs: 0, speed: 1 };
  private frameWanted = false;
  private changed = true;
  /** How the program ended, as far as the page has been told. */
  private toldEnd: Ended | null = null;
  private ticking = false;
  private resting = false;
  private aliveAtMs = 0;
  /** What was done while the run was being created. */
  private readonly early: InputAction[] = [];
  private readonly events = createEventBox();
  private readonly stillness = createStillness();
  private readonly meter = createSpeedMeter();
  private readonly outbox = createOutbox((text) => this.at.post({ type: 'console', text }));

  constructor(private readonly at: Surroundings) {}

  /** Does what a message of the page says. */
  receive(message: ToWorker): void {
    switch (message.type) {
      case 'prepare':
        this.firmware = message.firmware;
        this.at.post({ type: 'prepared' });
        break;
      case 'run':
        this.paused = message.paused;
        this.speed = message.speed;
        this.start(message.setup);
        break;
      case 'stop':
        this.stop();
        break;
      case 'frame':
        this.frameWanted = true;
        if (this.paused) this.schedule(0);
        break;
      case 'console-taken':
        this.outbox.taken();
        this.schedule(0);
        break;
      case 'input':
        this.input(message.action);
        break;
      default:
        this.changePace(message);
    }
  }

  private changePace(message: Extract<ToWorker, { type: 'pause' | 'resume' | 'step' | 'speed' }>): void {
    switch (message.type) {
      case 'pause':
        this.paused = true;
        this.stepUntilUs = this.run?.nowUs ?? 0;
        break;
      case 'resume':
        this.paused = false;
        break;
      case 'step':
        this.paused = true;
        this.stepUntilUs = Math.max(this.stepUntilUs, this.run?.nowUs ?? 0) + STEP_PRESS_US;
        break;
      case 'speed':
        this.speed = message.speed;
        break;
      default:
        message satisfies never;
    }
    this.anchorHere();
    this.schedule(0);
  }

  private start(setup: RunSetup): void {
    if (this.firmware === null) {
      this.fail(new Error('run before prepare'));
      return;
    }
    this.at.create(setup, this.firmware, this.events.outlets).then(
      (created) => {
        this.run = created;
        this.anchorHere();
        this.at.post({ type: 'started' });
        for (const action of this.early.splice(0)) this.input(action);
        if (this.stopped) this.stop();
        else this.schedule(0);
      },
      (error: unknown) => this.fail(error),
    );
  }

  private input(action: InputAction): void {
    if (this.stopped) return;
    const { run } = this;
    if (run === null) {
      this.early.push(action);
      return;
    }
    this.guarded(() => {
      try {
        run.input(action);
      } catch (error) {
        if (!(error instanceof RangeError)) throw error;
        // Refused: none of it was done, and the run goes on as if it had not come.
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
    if (run === null) return; // still being created: start() comes back here
    this.guarded(() => {
      if (run.ended === null) {
        run.stop();
        const untilMs = this.at.nowMs() + FAREWELL_MS;
        while (run.ended === null && this.at.nowMs() < untilMs) run.advanceProgramTo(run.nowUs + 4000);
        this.outbox.put(run.takeConsole());
      }
      this.outbox.flush();
      this.tellEvents();
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
      this.advance(run, this.at.nowMs() + SLICE_MS);
      const nowMs = this.at.nowMs();
      this.meter.note(nowMs, run.nowUs);
      this.anchor = withoutBacklog(this.anchor, nowMs, run.nowUs);
      this.tell(run, nowMs);
      const behind = run.nowUs < this.limitUs(run);
      if (behind) this.schedule(0);
      else if (this.mayRest(run)) this.rest(run);
      else if (!this.paused) this.schedule(REST_MS);
    });
  }

  /** The program has ended, and nothing happens any more: then time need not pass, and the machine can rest. */
  private mayRest(run: Run): boolean {
    const isIdle = !this.paused && this.toldEnd !== null && run.isIdle && this.outbox.isEmpty;
    return isIdle ? this.stillness.look(run.snapshot()) : this.stillness.forget();
  }

  private rest(run: Run): void {
    this.resting = true;
    this.tellPicture(run);
    this.at.post({ type: 'resting' });
  }

  /** Time goes on from here, not from what the wall clock says by now. */
  private wake(): void {
    this.resting = false;
    this.stillness.forget();
    this.anchorHere();
  }

  private advance(run: Run, untilMs: number): void {
    const limitUs = this.limitUs(run);
    // When the program has ended, the page hears of it before the REPL says its first word.
    while (run.nowUs < limitUs && !this.outbox.isFull && run.ended === this.toldEnd) {
      const startMs = this.at.nowMs();
      if (startMs >= untilMs) return;
      const nextUs = Math.min(limitUs, run.nowUs + this.pieceUs);
      if (run.ended === null) run.advanceProgramTo(nextUs);
      else run.advanceTo(nextUs);
      this.changed = true;
      this.pieceUs = nextPieceUs(this.pieceUs, this.at.nowMs() - startMs);
      this.outbox.put(run.takeConsole());
    }
  }

  /** Simulated time the run may reach now. */
  private limitUs(run: Run): number {
    if (this.outbox.isFull) return run.nowUs;
    return this.paused ? this.stepUntilUs : dueUs(this.anchor, this.at.nowMs());
  }

  /** Tells the page what it is waiting for. */
  private tell(run: Run, nowMs: number): void {
    if (this.frameWanted && this.changed) {
      this.frameWanted = this.changed = false;
      this.tellPicture(run);
    }
    this.tellEvents();
    this.tellEnd(run);
    if (nowMs - this.aliveAtMs >= HEARTBEAT_MS) {
      this.aliveAtMs = nowMs;
      this.at.post({ type: 'alive', nowUs: run.nowUs, achieved: this.paused ? null : this.meter.factor() });
    }
  }

  private tellPicture(run: Run): void {
    this.at.post({ type: 'snapshot', snapshot: run.snapshot(), trail: this.events.takeTrail() });
  }

  private tellEvents(): void {
    const events = this.events.take();
    if (events) this.at.post({ type: 'events', events });
  }

  private tellEnd(run: Run): void {
    if (run.ended === this.toldEnd || !this.outbox.isEmpty) return;
    this.toldEnd = run.ended;
    if (this.speed === 'max') this.anchorHere();
    // A listener of the end must see the robot as the program left it, not the picture before.
    this.tellPicture(run);
    this.at.post(run.ended ? { type: 'program-ended', ended: run.ended } : { type: 'program-restarted' });
  }

  private schedule(delayMs: number): void {
    if (this.ticking) return;
    this.ticking = true;
    this.at.later(() => this.tick(), delayMs);
  }

  /** The chosen speed; at full speed a world whose program has ended would run hours ahead, so it goes on as outside. */
  private pace(): Speed {
    return this.speed === 'max' && this.toldEnd !== null ? 1 : this.speed;
  }

  private anchorHere(): void {
    this.anchor = { wallMs: this.at.nowMs(), simulatedUs: this.run?.nowUs ?? 0, speed: this.pace() };
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
