import type { Pose } from '#core/geometry';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import type { Inspected } from '#vm/debug/inspected';
import { watchLines, type StopRule } from '#vm/debug/line-watch';
import { STEP_US } from '#world/step';
import type { World } from '#world/world';
import { Air, packetOf } from './several/air';
import { CourseWorld } from './course/course-world';
import { Device, type DeviceAction, type Ended } from './device';
import { poseOf, type InputAction, type InputEvent } from './input';
import { judgeOf } from './task/judge-of';
import type { FittedDevice } from './fit-devices';
import { isSounding, levelAt } from './several/hearing';
import { outletsOf, type RunOutlets } from './outlets';
import { RunInputs } from './run-inputs';
import { fitRun, createInputCheck } from './run-problem';
import type { RunSetup } from './run-setup';
import { seedOfDevice } from './several/seed-of-device';
import { heldIn, whereIs } from './several/where';
import type { Lights, Snapshot } from './snapshot';
import { switchingBoards, Switches } from './switching/switches';
import { TRACE_PERIOD_US, type TraceRow } from './trace';
import { TraceRecorder } from './trace-recorder';
import type { Verdict } from './task/verdict';

export type { Ended } from './device';

/** Before each step of the world, the other devices run up to this short a time before it. */
const JUST_BEFORE_US = 1;

/** True if a debugger has stopped the device's program. */
const isHeld = ({ hold }: Device): boolean => hold.isHeld;

/**
 * One run: one world, and one or several devices in it. The first device's clock moves the world, every 4 ms of
 * simulated time. Before each step the others run on, in their order, up to that step; so what one does reaches another
 * through the world or the radio, at a step. The same set-up gives the same run, whatever the pieces in which `advanceTo`
 * is called. Running again from the start means creating it anew.
 */
export class Simulation {
  private readonly devices: readonly Device[];
  private readonly first: Device;
  private readonly followers: readonly Device[];
  private readonly courseWorld: CourseWorld;
  private readonly world: World;
  private readonly air: Air;
  private readonly switches: Switches;
  private readonly judge: ReturnType<typeof judgeOf>;
  private readonly recorder: TraceRecorder;
  private readonly inputs: RunInputs;
  private isFresh = true;

  /**
   * Builds a run and loads its programs, which begin with the first `advanceTo`.
   *
   * @param outlets receive the run's events the moment they happen
   * @throws RangeError (as a rejection) for a set-up that cannot run, with the words of `checkRun`
   */
  static create(setup: RunSetup, firmware: WebAssembly.Module, outlets: RunOutlets = {}): Promise<Simulation> {
    return new Promise((resolve) => {
      const checked = fitRun(setup);
      if ('problem' in checked) throw new RangeError(checked.problem);
      resolve(new Simulation(setup, firmware, checked.devices, outlets));
    });
  }

  private constructor(
    private readonly setup: RunSetup,
    firmware: WebAssembly.Module,
    fitted: readonly FittedDevice[],
    private readonly outlets: RunOutlets,
  ) {
    this.courseWorld = new CourseWorld(setup.scene);
    this.world = this.courseWorld.world;
    const heldAt = heldIn(setup.scene);
    this.devices = fitted.map((device, place) => {
      const heard = (): number => this.heardBy(place);
      const around = { firmware, world: this.world, setup, seed: seedOfDevice(setup.seed, place), heldAt, heard };
      const own = { ...around, outlets: outletsOf(outlets, place) };
      return new Device(device, place === 0 ? { ...own, step: () => this.step() } : own);
    });
    const [first, ...followers] = this.devices;
    if (first === undefined) throw new RangeError('A run needs at least one device.');
    this.first = first;
    this.followers = followers;
    this.recorder = new TraceRecorder(robotsOf(this.devices), setup.keepTrace === true);
    this.judge = judgeOf(setup.scene, this.devices, fitted, this.courseWorld);
    this.air = new Air(this.devices, (device) => whereIs(device, this.scene), setup.seed, setup.reality);
    this.switches = new Switches(() => this.courseWorld.switched, switchingBoards(this.devices));
    const checks = fitted.map(({ hardware }) => createInputCheck(hardware, setup.scene));
    const names = this.devices.map(({ name }) => name);
    this.inputs = new RunInputs(setup.inputs ?? [], { names, checks }, this.courseWorld, this.first.clock);
  }

  /** Simulated time since the start. */
  get nowUs(): number {
    return this.first.clock.nowUs;
  }

  /**
   * How the first device's program ended, or `null` while it runs; `null` again when it runs again after Ctrl-D at the
   * REPL. The world goes on in either case.
   */
  get ended(): Ended | null {
    return this.first.ended;
  }

  /** True once every program has ended. */
  get hasEnded(): boolean {
    return this.devices.every(({ ended }) => ended !== null);
  }

  /** How each device's program ended, in their order. */
  get endings(): readonly (Ended | null)[] {
    return this.devices.map(({ ended }) => ended);
  }

  /** True once the programs have switched all boards off and do not run any more. */
  get isOff(): boolean {
    return this.devices.every(({ isOff }) => isOff);
  }

  /**
   * True if all programs have ended and nothing is set for later: no callback, tone, moving picture, time limit or lamp
   * that is switched by time.
   * While the world does not move either, nothing happens until the next input.
   */
  get isIdle(): boolean {
    const isQuiet = this.inputs.isEmpty && this.air.isQuiet && this.judge?.awaitsTime !== true;
    return isQuiet && !this.switches.awaitsTime && this.devices.every(({ isIdle }) => isIdle);
  }

  /**
   * Every action so far with the time at which it took effect: as `inputs` of an equal set-up, they repeat this run.
   */
  get inputLog(): readonly InputEvent[] {
    return this.inputs.log;
  }

  /** The rows since the last call: one per 20 ms and robot, if the set-up asks to keep them. */
  takeTrace(): readonly TraceRow[] {
    return this.recorder.take();
  }

  /** Fingerprint of the trajectories so far, 64 hexadecimal digits; see `createTraceHash`. */
  get traceHash(): string {
    return this.recorder.fingerprint();
  }

  /** The course with which this run began. */
  get scene(): Scene {
    return this.setup.scene;
  }

  /** How well the task is done, or `null` if the course has no task, and without a robot. */
  get verdict(): Verdict | null {
    return this.judge?.verdict() ?? null;
  }

  /** Number of touches up to now of all robots that count for the task, also after its verdict; 0 without a robot. */
  get touches(): number {
    return this.judge?.touches ?? 0;
  }

  /** Pose of the first device's robot, or `null` if it has none. */
  get pose(): Pose | null {
    return this.first.mounted?.chassis.pose() ?? null;
  }

  /** Convex outlines of the first robot now, with all that is fixed to it or held, in world mm; none without a robot. */
  get body(): readonly Outline[] {
    return this.judge?.body() ?? [];
  }

  /** The outline of a movable block where it lies, in world mm; `null`: a robot holds it, or there is none of this id. */
  blockLying(id: string): Outline | null {
    return this.courseWorld.lying(id);
  }

  /** The first device's display: 25 levels 0 … 9, row by row. */
  get display(): ArrayLike<number> {
    return this.first.board.display.pixels;
  }

  /** The lights of the first device and its robot. */
  get lights(): Lights {
    return this.first.shine();
  }

  /** True once the judge has decided. */
  get isJudged(): boolean {
    return this.judge?.isFinal === true;
  }

  /** Free bytes on a program's heap now, or when it ended. */
  heapFree(device = 0): number {
    return this.devices[device]?.heapFree() ?? 0;
  }

  /** The state of a device's program for a debugger, see `#vm/debug`; `null`: there is no such device. */
  inspect(device = 0): Inspected | null {
    return this.devices[device]?.inspected ?? null;
  }

  /** The time on a device's clock: while a debugger steps, it may be some ms ahead of or behind that of the first. */
  timeOf(device: number): number {
    return this.devices[device]?.clock.nowUs ?? this.nowUs;
  }

  /**
   * Stops the run at the lines of a device's program that the rule names; `null`: not any more. `heldBy` then names the
   * device, and the next `advanceTo` goes on. Time, output, memory and trajectory are the same as without a rule.
   */
  watch(rule: StopRule | null, device = 0): void {
    const watched = this.devices[device];
    if (watched) watched.hold.watch = rule && watchLines(() => watched.inspected, rule);
  }

  /** The place of the device whose rule has stopped the run, or `null`. */
  get heldBy(): number | null {
    const place = this.devices.findIndex(isHeld);
    return place < 0 ? null : place;
  }

  /**
   * Lets programs and world run until simulated time `us`; after a program's end the world goes on, and the REPL waits. A
   * call of the device that is not finished by then is finished first, so the clock may be a little later. Time is whole µs:
   * of a limit between two, the earlier one counts.
   */
  advanceTo(us: number): void {
    this.advanceProgramTo(us);
    if (this.heldBy === null) this.first.resumeUntil(Math.floor(us));
  }

  /** Like `advanceTo`, but stops when the program ends: at once, or of several at the step at which all have ended. */
  advanceProgramTo(limitUs: number): void {
    const us = Math.floor(limitUs);
    if (this.isFresh) this.begin();
    for (const { hold } of this.devices) hold.isHeld = false;
    const isWatched = this.devices.some(({ hold }) => hold.watch !== null);
    while (!this.hasEnded && us > this.nowUs) {
      const isAlone = this.followers.length === 0;
      const nextStepUs = (Math.floor(this.nowUs / STEP_US) + 1) * STEP_US;
      if (isWatched && !this.bringFollowersTo(nextStepUs - JUST_BEFORE_US)) return;
      this.first.resume(isAlone ? us : Math.min(us, nextStepUs));
      if (isHeld(this.first)) return;
    }
  }

  /**
   * While a debugger steps, the devices after the first run before it: inside the step of the world none could stop.
   * They meet only there, so the order makes no difference.
   *
   * @returns false if one was stopped
   */
  private bringFollowersTo(us: number): boolean {
    for (const device of this.followers)
      while (device.clock.nowUs < us) {
        device.resume(us);
        if (isHeld(device)) return false;
      }
    return true;
  }

  /**
   * Performs an action from outside. It takes effect at the next step of the world, is stamped with that time and
   * logged. A button or pad waits until the board has noticed its last change, see `InputQueue`.
   *
   * @param device name of the device that it is for; left out: the first
   * @throws RangeError for an unknown device, sensor, pad, block or object, and for a value out of range; then nothing is
   *   done
   */
  input(action: InputAction, device?: string): void {
    this.inputs.add(action, device);
  }

  /** KeyboardInterrupt in all programs, at the next step of the world. */
  interrupt(): void {
    for (const { name } of this.devices) this.input({ type: 'interrupt' }, name);
  }

  /** Ends all programs by an interrupt whose traceback is not printed. The output of their `finally` is. */
  stop(): void {
    for (const device of this.devices) device.expectStop();
    this.interrupt();
  }

  /** The whole run now. */
  snapshot(): Snapshot {
    const switched = this.switches.states;
    return {
      ...this.first.snapshot(),
      timeUs: this.nowUs,
      others: this.followers.map((device) => device.snapshot()),
      blocks: this.courseWorld.blockPoses(),
      movers: this.courseWorld.moverPoses(),
      ...(switched && { switched }),
      verdict: this.verdict,
    };
  }

  /** The output of a device since the last call. */
  takeConsole(device = 0): string {
    return this.devices[device]?.takeConsole() ?? '';
  }

  /** Takes the robots off their boards, and gives their memory to the next run. Call nothing else afterwards. */
  dispose(): void {
    for (const device of this.devices) device.dispose();
  }

  /** The events at time 0, before the programs' first bytecode. */
  private begin(): void {
    this.isFresh = false;
    this.takeInputs();
    this.observe();
  }

  private step(): void {
    for (const device of this.followers) {
      device.resumeUntil(this.nowUs - JUST_BEFORE_US);
      device.hold.isHeld = false; // the first device was in one long call: here no other can be stopped
    }
    this.takeInputs();
    this.switches.step(this.nowUs);
    this.world.step();
    for (const device of this.devices) device.sense();
    this.air.step(this.nowUs);
    this.observe();
  }

  /** Lets the judge look at the present state, and reports and records it. */
  private observe(): void {
    this.judge?.step(this.nowUs);
    for (const device of this.devices) device.sendTrail();
    this.recorder.step(this.nowUs);
    const { step, moment, isMomentWanted } = this.outlets;
    step?.();
    if (moment && this.nowUs % TRACE_PERIOD_US === 0 && isMomentWanted?.(this.nowUs) !== false) moment(this.snapshot());
  }

  private takeInputs(): void {
    for (let due = this.inputs.takeDue(); due; due = this.inputs.takeDue()) this.act(due.action, due.device);
  }

  private edit(edit: SceneEdit): void {
    const course = applyEdit(this.courseWorld.course, edit);
    this.courseWorld.take(course);
    this.judge?.take(course);
    for (const device of this.devices) device.seeLamps();
  }

  /** @param device its place, or `null` if the action names none */
  private act(action: InputAction, device: number | null): void {
    switch (action.type) {
      case 'edit':
        return this.edit(action.edit);
      case 'place-block':
        this.judge?.takeHand();
        return this.courseWorld.block(action.id)?.place(poseOf(action.pose));
      case 'switch':
        return this.switches.byHand(action.id, action.on);
      case 'radio':
        this.switches.hear(packetOf(action));
        for (const { board } of this.named(device)) board.radio.receive(packetOf(action));
        return;
      case 'remote':
        for (const heard of this.named(device)) heard.act(action);
        return;
      case 'no-progress':
        return this.judge?.callLack();
      case 'place':
        this.judge?.takeHand();
        return this.devices[device ?? 0]?.act(action);
      default:
        return this.devices[device ?? 0]?.act(action satisfies DeviceAction);
    }
  }

  /** The device at this place; without one all of them. */
  private named(device: number | null): readonly Device[] {
    return device === null ? this.devices : this.devices.slice(device, device + 1);
  }

  /** How loud the others are where the device at this place is. */
  private heardBy(place: number): number {
    const device = this.devices[place];
    if (device === undefined) return 0;
    const sounding = this.devices.filter((other) => other !== device && isSounding(other.board));
    if (sounding.length === 0) return 0; // asked in each step of the world, and boards are mostly silent
    const speakers = sounding.map((other) => ({ board: other.board, at: whereIs(other, this.scene) }));
    return levelAt(whereIs(device, this.scene), speakers);
  }
}

const robotsOf = (devices: readonly Device[]) =>
  devices.flatMap(({ name, mounted }) => (mounted === null ? [] : [{ device: name, mounted }]));
