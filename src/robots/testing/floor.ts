import { Board } from '#board/board';
import { findBoard } from '#board/boards/index';
import { Clock } from '#core/clock';
import type { Vec } from '#core/geometry';
import { completeOptions, type OptionValues } from '#core/option';
import { MOST_STEPS_BACK } from '#devices/line-sensor';
import { NecRemote, noInfrared } from '#devices/nec-remote';
import { createVm } from '#vm/run/vm';
import type { Chassis } from '#world/chassis';
import { LastSteps } from '#world/last-steps';
import { STEP_US } from '#world/step';
import { createWorld, type World } from '#world/world';
import { bodyOf, type OnSet, type Robot, type RobotBuild, type RobotContext } from '../robot';

/** Surroundings without anything: a bare floor without end under an ideal robot of its usual size and options. */
export const nothingAround = {
  ground: () => 1,
  beforePaint: () => () => undefined,
  distance: () => ({ distanceMm: Infinity, hitMm: null }),
  depths: () => [],
  light: () => [0.85, 0.85, 0.82],
  lightAhead: () => null,
  camera: () => ({ picture: () => [], tags: () => [], floorEnds: (slopes, toMm) => slopes.map(() => toMm) }),
  seen: (results) => results,
  colourNumber: () => 0,
  lightLevel: () => 127,
  miss: () => 0,
  supplyMv: () => 4800,
  infrared: noInfrared,
  options: {},
  scale: 1,
  lineReadings: {},
} satisfies Partial<RobotContext>;

/** A robot in an arena of 3 m × 3 m, its board controlled by a test. */
export interface Floor {
  readonly clock: Clock;
  readonly world: World;
  readonly board: Board;
  readonly chassis: Chassis;
  readonly robot: Robot;
  /** A remote control that points at the robot. */
  readonly remote: NecRemote;
  /** Lets simulated time pass. */
  readonly passMs: (ms: number) => void;
  /** Writes to a chip on the bus; false if no chip answers. */
  readonly send: (address: number, ...bytes: readonly number[]) => boolean;
  /** Selects a register of a chip and reads from there. */
  readonly readFrom: (address: number, register: number, count: number) => readonly number[];
  /** Output and end of a program that runs with the robot's libraries. */
  readonly run: (firmware: WebAssembly.Module, program: string, forMs?: number) => ProgramRun;
}

/** A program that has run. */
export interface ProgramRun {
  readonly lines: readonly string[];
  /** `Type: message` of the exception that ended it, or `null`. */
  readonly exception: string | null;
  readonly hasEnded: boolean;
}

/** The floor for a test. */
export interface FloorSetup {
  /** Paints lines and puts up walls. */
  readonly prepare?: (world: World) => void;
  /** Left out: (1000, 1000). */
  readonly startMm?: Vec;
  readonly options?: OptionValues;
  readonly scale?: number;
  /** Voltage of the battery. */
  readonly supplyMv?: number;
  /** How far measured moves miss their end, in standard deviations. */
  readonly miss?: number;
  /** Called when the program sets an output. */
  readonly onSet?: OnSet;
  /** Strength of the left and the right motor. */
  readonly strength?: readonly [number, number];
}

/** Puts a robot on the floor, heading along +x, with its board. */
export function putOnFloor(build: RobotBuild, setup: FloorSetup = {}): Floor {
  const { prepare = () => undefined, options = {}, scale = 1, supplyMv = 4800, miss = 0, strength = [1, 1] } = setup;
  const { startMm = { x: 1000, y: 1000 } } = setup;
  const boardType = findBoard(build.type.board);
  if (!boardType) throw new Error(`There is no board "${build.type.board}".`);
  const clock = new Clock();
  const board = new Board(boardType, clock);
  const world = createWorld({ widthMm: 3000, heightMm: 3000 });
  prepare(world);
  const pose = { xMm: startMm.x, yMm: startMm.y, headingRad: 0 };
  const all = completeOptions(build.type.options, options);
  const chassis = world.addChassis({ ...bodyOf(build.type, all), strength }, pose, () => clock.nowUs);
  const steps = new LastSteps(chassis, () => clock.nowUs, MOST_STEPS_BACK);
  const remote = new NecRemote(clock);
  const robot = build.attach({
    clock,
    board,
    chassis,
    ground: (spot, radiusMm, ago) =>
      world.reflectanceAt(chassis.toWorld(spot, ago === undefined ? undefined : steps.ago(ago).stance), radiusMm),
    beforePaint: (act) => world.beforePaint(act),
    distance: (from, headingRad, cone) =>
      world.distanceCone(chassis.toWorld(from), chassis.pose().headingRad + headingRad, cone, chassis),
    depths: (from, view) => world.depthGrid(chassis.toWorld(from), chassis.pose().headingRad, view, chassis),
    light: (spot, radiusMm) => world.sharesAt(chassis.toWorld(spot), radiusMm),
    lightAhead: () => null,
    camera: nothingAround.camera,
    seen: nothingAround.seen,
    colourNumber: nothingAround.colourNumber,
    lightLevel: () => board.sensors.get('lightLevel'),
    miss: () => miss,
    supplyMv: () => supplyMv,
    infrared: remote,
    options: all,
    scale,
    lineReadings: {},
    ...(setup.onSet && { onSet: setup.onSet }),
  });
  clock.every(STEP_US, () => {
    world.step();
    steps.note();
    robot.step();
  });
  const send = (address: number, ...bytes: readonly number[]): boolean =>
    board.i2c.write(address, Uint8Array.from(bytes)).acknowledged;
  return {
    clock,
    world,
    board,
    chassis,
    robot,
    remote,
    passMs: (ms) => clock.advanceTo(clock.nowUs + ms * 1000),
    send,
    readFrom: (address, register, count) => {
      send(address, register);
      return [...board.i2c.read(address, count).bytes];
    },
    run: (firmware, program, forMs = 5000) => runProgram({ board, clock, build, firmware, program, forMs }),
  };
}

interface ProgramSetup {
  readonly board: Board;
  readonly clock: Clock;
  readonly build: RobotBuild;
  readonly firmware: WebAssembly.Module;
  readonly program: string;
  readonly forMs: number;
}

function runProgram({ board, clock, build, firmware, program, forMs }: ProgramSetup): ProgramRun {
  let output = '';
  const write = (text: string): void => void (output += text);
  const files = { 'main.py': program };
  const vm = createVm({ firmware, board, clock, files, libraries: build.libraries, seed: 1, write });
  const untilUs = clock.nowUs + forMs * 1000;
  while (clock.nowUs < untilUs) vm.resume(untilUs);
  const exception = vm.ended?.exception ?? null;
  return {
    lines: output.split(/\r?\n/).filter((line) => line !== ''),
    exception: exception && `${exception.type}: ${exception.message}`,
    hasEnded: vm.ended !== null,
  };
}
