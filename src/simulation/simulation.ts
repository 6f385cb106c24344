import { Board } from '#board/board';
import { packetOfText } from '#board/radio-text';
import { radOf } from '#core/angle';
import { Clock } from '#core/clock';
import type { Pose } from '#core/geometry';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { watchLedChains, type LedChains } from '#devices/led-chains';
import { createVm, type Vm, type VmEnd } from '#vm/run/vm';
import { STEP_US } from '#world/step';
import type { World } from '#world/world';
import { CourseWorld } from './course-world';
import type { Hardware } from './hardware';
import type { InputAction, InputEvent, PlacedPose } from './input';
import { Judge } from './judge';
import { mountRobot, type Mounted } from './mount-robot';
import { tellEvents, type RunOutlets } from './outlets';
import { robotLibraries } from './robot-libraries';
import { RunInputs } from './run-inputs';
import { checkRun, createInputCheck } from './run-problem';
import type { RunSetup } from './run-setup';
import { scaledBody } from './scaled-body';
import type { Snapshot } from './snapshot';
import { boardSnapshot, robotSnapshot } from './take-snapshot';
import type { TraceRow } from './trace';
import { TraceRecorder } from './trace-recorder';
import { spikedIds } from './task-brief';
import type { Verdict } from './verdict';
import { createTrailSender } from './trail';

/** How and when the program ended. */
export interface Ended extends VmEnd {
  /** Simulated time. */
  readonly timeUs: number;
}

/**
 * One run: program, board, robot and world under one clock. The same set-up gives the same run, whatever the pieces in
 * which `advanceTo` is called. Running again from the start means creating it anew.
 */
export class Simulation {
  private readonly clock = new Clock();
  private readonly board: Board;
  private readonly courseWorld: CourseWorld;
  private readonly world: World;
  private readonly mounted: Mounted | null;
  private readonly judge: Judge | null;
  private readonly lights: LedChains;
  private readonly sendTrail: () => void;
  private readonly vm: Vm;
  private readonly recorder: TraceRecorder;
  private readonly inputs: RunInputs;
  private output: string[] = [];
  private end: Ended | null = null;
  private isFresh = true;
  private isStopped = false;

  /**
   * Builds a run and loads its program, which begins with the first `advanceTo`.
   *
   * @param outlets receive the run's events the moment they happen
   * @throws RangeError (as a rejection) for a set-up that cannot run, with the words of `checkRun`
   */
  static create(setup: RunSetup, firmware: WebAssembly.Module, outlets: RunOutlets = {}): Promise<Simulation> {
    return new Promise((resolve) => {
      const hardware = checkRun(setup);
      if ('problem' in hardware) throw new RangeError(hardware.problem);
      resolve(new Simulation(setup, firmware, hardware, outlets));
    });
  }

  private constructor(
    private readonly setup: RunSetup,
    firmware: WebAssembly.Module,
    hardware: Hardware,
    outlets: RunOutlets,
  ) {
    this.courseWorld = new CourseWorld(setup.scene);
    this.world = this.courseWorld.world;
    // The step is registered before everything with a rhythm of its own (the robot's sensors): then the world moves
    // first.
    this.clock.every(STEP_US, () => this.step());
    this.board = new Board(hardware.board, this.clock, hardware.firmware);
    tellEvents(this.board, this.clock, outlets);
    this.mounted = mountRobot(hardware, {
      clock: this.clock,
      board: this.board,
      world: this.world,
      start: setup.scene.robot,
      seed: setup.seed,
      reality: setup.reality,
      traits: setup.traits,
    });
    this.recorder = new TraceRecorder(this.mounted, setup.keepTrace === true);
    this.judge = this.mounted && judgeOf(setup.scene, this.mounted, this.courseWorld);
    this.sendTrail =
      this.mounted && outlets.trail ? createTrailSender(this.mounted.chassis, outlets.trail) : () => undefined;
    this.lights = watchLedChains(hardware.board.pins.map(({ wire }) => this.board.wire(wire)));
    this.vm = createVm({
      firmware,
      board: this.board,
      clock: this.clock,
      files: setup.files,
      libraries: robotLibraries(hardware.robot?.id ?? null),
      seed: setup.seed,
      repl: setup.repl ?? 'when-typed',
      write: outlets.print ?? ((text) => this.output.push(text)),
    });
    const check = createInputCheck(hardware.board, setup.scene, hardware.robot !== null);
    this.inputs = new RunInputs(setup.inputs ?? [], check, this.courseWorld, this.clock);
  }

  /** Simulated time since the start. */
  get nowUs(): number {
    return this.clock.nowUs;
  }

  /**
   * How the program ended, or `null` while it runs; `null` again when it runs again after Ctrl-D at the REPL. The world
   * goes on in either case.
   */
  get ended(): Ended | null {
    return this.end;
  }

  /** The program has switched the board off and does not run any more. */
  get isOff(): boolean {
    return this.board.power.state === 'off';
  }

  /**
   * The program has ended, and nothing is set for later: no callback, tone, moving picture or time limit. While the
   * world does not move either, nothing happens until the next input.
   */
  get isIdle(): boolean {
    return this.end !== null && this.clock.alarms <= 1 && this.inputs.isEmpty && this.judge?.awaitsTime !== true;
  }

  /**
   * Every action so far with the time at which it took effect: as `inputs` of an equal set-up, they repeat this run.
   */
  get inputLog(): readonly InputEvent[] {
    return this.inputs.log;
  }

  /** The rows since the last call: one per 20 ms, if the set-up asks to keep them; without a robot none. */
  takeTrace(): readonly TraceRow[] {
    return this.recorder.take();
  }

  /** Fingerprint of the trajectory so far, 64 hexadecimal digits; see `createTraceHash`. */
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

  /** Free bytes on the program's heap now, or when it ended. */
  heapFree(): number {
    return this.vm.heapFree();
  }

  /**
   * Lets program and world run until simulated time `us`; after the program's end the world goes on, and the REPL
   * waits. A call of the device that is not finished by then is finished first, so the clock may be a little later.
   */
  advanceTo(us: number): void {
    this.advanceProgramTo(us);
    while (us > this.nowUs) this.resume(us);
  }

  /** Like `advanceTo`, but stops at once when the program ends. */
  advanceProgramTo(us: number): void {
    if (this.isFresh) this.begin();
    if (this.end === null && us > this.nowUs) this.resume(us);
  }

  /**
   * Performs an action from outside. It takes effect at the next step of the world, is stamped with that time and
   * logged. A button or pad waits until the board has noticed its last change, see `InputQueue`.
   *
   * @throws RangeError for an unknown sensor, pad, block or object, and for a value out of range; then nothing is done
   */
  input(action: InputAction): void {
    this.inputs.add(action);
  }

  /** KeyboardInterrupt in the program, at the next step of the world. */
  interrupt(): void {
    this.input({ type: 'interrupt' });
  }

  /** Ends the program by an interrupt whose traceback is not printed. The output of its `finally` is. */
  stop(): void {
    this.isStopped = true;
    this.interrupt();
  }

  /** The whole run now. */
  snapshot(): Snapshot {
    return {
      ...boardSnapshot(this.board),
      timeUs: this.nowUs,
      running: this.end === null ? 'program' : 'world',
      awaitsInput: this.vm.awaitsInput,
      repl: this.vm.isInRepl,
      robot: this.mounted && robotSnapshot(this.mounted, this.scene.robot.scale),
      blocks: this.courseWorld.blockPoses(),
      movers: this.courseWorld.moverPoses(),
      verdict: this.verdict,
      lights: this.lights.chains(),
      arenaSenses: this.mounted?.senses.isOn ?? false,
    };
  }

  /** The output since the last call. */
  takeConsole(): string {
    const text = this.output.join('');
    this.output = [];
    return text;
  }

  /** Takes the robot off the board. The memory is freed with the last reference. Call nothing else afterwards. */
  dispose(): void {
    this.mounted?.robot.detach();
  }

  /** Lets the VM go on until `us`, until its program ends, or until its program starts again. */
  private resume(us: number): void {
    this.vm.resume(us);
    const { ended } = this.vm;
    if (ended === null) this.end = null;
    else this.end ??= { ...ended, timeUs: this.nowUs };
  }

  /** The events at time 0, before the program's first bytecode. */
  private begin(): void {
    this.isFresh = false;
    this.takeInputs();
    this.judge?.step(this.nowUs);
    this.recorder.step(this.nowUs);
    this.sendTrail();
  }

  private step(): void {
    this.takeInputs();
    this.world.step();
    this.mounted?.step();
    this.judge?.step(this.nowUs);
    this.sendTrail();
    this.recorder.step(this.nowUs);
  }

  private takeInputs(): void {
    for (let action = this.inputs.takeDue(); action; action = this.inputs.takeDue()) this.act(action);
  }

  private edit(edit: SceneEdit): void {
    const course = applyEdit(this.courseWorld.course, edit);
    this.courseWorld.take(course);
    this.judge?.take(course);
  }

  private act(action: InputAction): void {
    switch (action.type) {
      case 'button':
        return this.board.sensors.set(action.button === 'a' ? 'buttonA' : 'buttonB', action.down ? 1 : 0);
      case 'touch':
        return this.board.sensors.set(action.pad, action.down ? 1 : 0);
      case 'serial':
        return this.vm.feed(action.text);
      case 'sensor':
        // Beyond the range that the program has set, the sensor reports its limit.
        return this.board.sensors.set(action.id, this.board.sensors.nearest(action.id, action.value));
      case 'place':
        this.judge?.takeHand();
        return this.mounted?.chassis.place(poseOf(action.pose));
      case 'place-block':
        this.judge?.takeHand();
        return this.courseWorld.block(action.id)?.place(poseOf(action.pose));
      case 'edit':
        return this.edit(action.edit);
      case 'radio':
        return this.board.radio.receive(packetOf(action));
      case 'arena-senses':
        return this.mounted?.senses.switch(action.on);
      case 'interrupt':
        return this.isStopped ? this.vm.stop() : this.vm.interrupt();
      default:
        action satisfies never;
    }
  }
}

function judgeOf(course: Scene, { type, chassis }: Mounted, world: CourseWorld): Judge {
  return new Judge(course, {
    chassis,
    body: scaledBody(type.body, course.robot.scale).outlineMm,
    block: (id) => world.block(id),
    spiked: spikedIds(course),
  });
}

const poseOf = ({ xMm, yMm, headingDeg }: PlacedPose): Pose => ({ xMm, yMm, headingRad: radOf(headingDeg) });

function packetOf(action: Extract<InputAction, { type: 'radio' }>): Uint8Array {
  return 'bytes' in action ? Uint8Array.from(action.bytes) : packetOfText(action.text);
}
