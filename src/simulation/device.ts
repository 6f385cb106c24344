import { Board } from '#board/board';
import { Clock } from '#core/clock';
import { attachGamepad, type Gamepad } from '#devices/gamepad';
import type { Vec } from '#core/geometry';
import { watchLedChains, type LedChains } from '#devices/led-chains';
import { NecRemote } from '#devices/nec-remote';
import { holdsGamepad } from '#robots/in-hand';
import { readPosition } from '#vm/debug/frames';
import type { Inspected } from '#vm/debug/inspected';
import type { Hold } from '#vm/run/engine';
import { createVm, type Vm, type VmEnd } from '#vm/run/vm';
import { STEP_US } from '#world/step';
import type { World } from '#world/world';
import { OutputWatch } from './causes/output-watch';
import type { FittedDevice } from './fit-devices';
import { Hearing } from './several/hearing';
import { poseOf, type InputAction } from './input';
import { mountRobot, type Mounted } from './mount-robot';
import { tellEvents, type DeviceOutlets } from './outlets';
import { robotLibraries } from './robot-libraries';
import type { RunSetup } from './run-setup';
import type { DeviceSnapshot, Lights } from './snapshot';
import { boardSnapshot, robotSnapshot } from './take-snapshot';
import { createLampSense, lampLevel } from './switching/light-sense';
import { createTrailSender } from './trail';

/** How and when a program ended. */
export interface Ended extends VmEnd {
  /** Simulated time. */
  readonly timeUs: number;
}

/** The run around a device. */
export interface Around {
  readonly firmware: WebAssembly.Module;
  readonly world: World;
  readonly setup: Pick<RunSetup, 'reality' | 'repl'>;
  /** Whole number from which this device's random numbers are drawn. */
  readonly seed: number;
  readonly outlets: DeviceOutlets;
  /** The place where a board without a robot is held, in mm. */
  readonly heldAt: Vec;
  /** How loud the other devices are where this one is, 0 … 255. */
  readonly heard: () => number;
  /** Moves the world on, every `STEP_US` of this device's clock; left out: another device does. */
  readonly step?: () => void;
}

/** An action on one device from outside. */
export type DeviceAction = Exclude<
  InputAction,
  { readonly type: 'edit' | 'place-block' | 'switch' | 'radio' | 'no-progress' }
>;

/** One microcomputer of a run: program, board and, if it has one, its robot, on a clock of its own. */
export class Device {
  readonly name: string;
  readonly clock = new Clock();
  readonly board: Board;
  readonly mounted: Mounted | null;
  /** Reports the robot's path; call it after each step of the world. */
  readonly sendTrail: () => void;
  private readonly remote: NecRemote;
  private readonly gamepad: Gamepad | null;
  /** Lets the board see the lamps; call it when the course has changed. */
  readonly seeLamps: () => void;
  private readonly scale: number;
  private readonly ownAlarms: number;
  private readonly lights: LedChains;
  private readonly hearing: Hearing;
  private readonly vm: Vm;
  private output: string[] = [];
  private end: Ended | null = null;
  private isStopped = false;

  /** Puts the robot into the world and loads the program, which begins with the first `resume`. */
  constructor({ setup, hardware, start }: FittedDevice, around: Around) {
    this.name = setup.name;
    this.scale = start.scale;
    // The step is registered before everything with a rhythm of its own (the robot's sensors): then the world moves
    // first.
    if (around.step) this.clock.every(STEP_US, around.step);
    this.ownAlarms = this.clock.alarms;
    this.board = new Board(hardware.board, this.clock, hardware.firmware);
    const { outlets, world, seed } = around;
    tellEvents(this.board, this.clock, outlets);
    const watch = outlets.set ? this.watchOutputs(outlets.set) : null;
    const { reality } = around.setup;
    const own = { clock: this.clock, board: this.board, onSet: watch?.onSet };
    this.remote = new NecRemote(this.clock);
    const isInGamepad = hardware.robot === null && holdsGamepad(hardware.options);
    this.gamepad = isInGamepad ? attachGamepad((wire) => this.board.wire(wire)) : null;
    const place = { ...own, infrared: this.remote, world, start, seed, reality, traits: setup.traits };
    this.mounted = mountRobot(hardware, place);
    const level = this.mounted?.boardLevel ?? (() => lampLevel(world, around.heldAt));
    this.seeLamps = createLampSense(this.board.sensors, level);
    this.seeLamps();
    this.hearing = new Hearing(this.board.sensors, around.heard);
    this.sendTrail =
      this.mounted && outlets.trail ? createTrailSender(this.mounted.chassis, outlets.trail) : () => undefined;
    this.lights = watchLedChains(hardware.board.pins.map(({ wire }) => this.board.wire(wire)));
    this.vm = createVm({
      firmware: around.firmware,
      board: this.board,
      clock: this.clock,
      files: setup.files,
      libraries: robotLibraries(hardware.robot?.id ?? null),
      seed,
      repl: around.setup.repl ?? 'when-typed',
      write: outlets.print ?? ((text) => this.output.push(text)),
      observer: watch ?? undefined,
    });
  }

  private watchOutputs(tell: NonNullable<DeviceOutlets['set']>): OutputWatch {
    return new OutputWatch({
      ...{ board: this.board, clock: this.clock, tell },
      wires: () => this.mounted?.robot.wires ?? {},
      chains: () => this.lights.chains(),
      inspect: () => this.vm.inspected,
    });
  }

  /** How the program ended, or `null` while it runs; `null` again when it runs again after Ctrl-D at the REPL. */
  get ended(): Ended | null {
    return this.end;
  }

  /** True once the program has switched the board off and does not run any more. */
  get isOff(): boolean {
    return this.board.power.state === 'off';
  }

  /** True if the program has ended and nothing is set for later: no callback, tone, moving picture. */
  get isIdle(): boolean {
    return this.end !== null && this.clock.alarms <= this.ownAlarms;
  }

  /** The state of its MicroPython that a debugger reads while it is paused. */
  get inspected(): Inspected {
    return this.vm.inspected;
  }

  /** The condition on which its program is paused before its time is over. */
  get hold(): Hold {
    return this.vm.hold;
  }

  /** Free bytes on the program's heap now, or when it ended. */
  heapFree(): number {
    return this.vm.heapFree();
  }

  /** Updates the sensors that depend on the arena; call it after each step of the world. */
  sense(): void {
    this.mounted?.step();
    this.hearing.step();
  }

  /** Lets the VM go on until `us` of its clock, until its program ends, or until its program starts again. */
  resume(us: number): void {
    this.vm.resume(us);
    const { ended } = this.vm;
    if (ended === null) this.end = null;
    else this.end ??= { ...ended, timeUs: this.clock.nowUs };
  }

  /** Lets the VM go on until `us`, also over the end of its program. */
  resumeUntil(us: number): void {
    while (this.clock.nowUs < us) this.resume(us);
  }

  /** Makes the next interrupt a stop, whose traceback is not printed. */
  expectStop(): void {
    this.isStopped = true;
  }

  act(action: DeviceAction): void {
    switch (action.type) {
      case 'button':
        return this.board.sensors.set(action.button === 'a' ? 'buttonA' : 'buttonB', action.down ? 1 : 0);
      case 'touch':
        return this.board.sensors.set(action.pad, action.down ? 1 : 0);
      case 'remote':
        return this.remote.set(action.key, action.down);
      case 'stick':
        return this.gamepad?.move(action.x, action.y);
      case 'gamepad':
        return this.gamepad?.set(action.key, action.down);
      case 'serial':
        return this.vm.feed(action.text);
      case 'sensor':
        this.mounted?.senses.setByHand(action.id);
        // Beyond the range that the program has set, the sensor reports its limit.
        return this.board.sensors.set(action.id, this.board.sensors.nearest(action.id, action.value));
      case 'place':
        return this.mounted?.chassis.place(poseOf(action.pose));
      case 'arena-senses':
        this.mounted?.senses.switch(action.on);
        return this.hearing.switch(action.on);
      case 'interrupt':
        return this.isStopped ? this.vm.stop() : this.vm.interrupt();
      default:
        action satisfies never;
    }
  }

  /** Its lights now: a small part of a snapshot. */
  shine(): Lights {
    return { rgb: this.board.rgb, lights: this.lights.chains(), robot: this.mounted?.robot.lights() ?? null };
  }

  snapshot(): DeviceSnapshot {
    return {
      ...boardSnapshot(this.board),
      name: this.name,
      running: this.end === null ? 'program' : 'world',
      awaitsInput: this.vm.awaitsInput,
      repl: this.vm.isInRepl,
      position: readPosition(this.vm.inspected),
      robot: this.mounted && robotSnapshot(this.mounted, this.scale),
      lights: this.lights.chains(),
      arenaSenses: this.hearing.isOn,
      ...(this.remote.sent && { infrared: this.remote.sent }),
      ...(this.gamepad && { gamepad: this.gamepad.state() }),
    };
  }

  /** The output since the last call. */
  takeConsole(): string {
    const text = this.output.join('');
    this.output = [];
    return text;
  }

  /** Takes the robot off the board, and gives its MicroPython's memory back. Call nothing else afterwards. */
  dispose(): void {
    this.mounted?.robot.detach();
    this.vm.dispose();
  }
}
