import { Board } from '#board/board';
import { findBoard } from '#board/boards/index';
import { radOf } from '#core/angle';
import { Clock } from '#core/clock';
import type { Pose } from '#core/geometry';
import { MOST_STEPS_BACK } from '#devices/line-sensor';
import type { InfraredLight } from '#devices/nec-remote';
import { heardCone } from '#robots/incidence';
import { withCamera } from '#robots/camera';
import { withColourSensors } from '#robots/colour-sensor';
import { bodyOf, type OnSet, type Robot, type RobotContext, type RobotType } from '#robots/robot';
import type { Traits } from '#robots/traits';
import { floorRgb } from '#scene/paint/reflectance';
import type { RobotStart } from '#scene/scene';
import type { Chassis } from '#world/chassis';
import { LastSteps } from '#world/last-steps';
import type { Shares } from '#world/shapes';
import type { World } from '#world/world';
import { createArenaSenses, type ArenaSenses } from './arena-senses';
import type { Hardware } from './hardware';
import { colourNumber } from './colour-number';
import { lampLevel, robotLight } from './switching/light-sense';
import { isMisplugged } from './robot-fit';
import { createReality, FULL_MV, type Reality } from './reality';
import { findBuild } from './robot-libraries';
import { scaledBody } from './scaled-body';

/** The robot of a run: its electronics on the board and its body in the world. */
export interface Mounted {
  readonly type: RobotType;
  readonly robot: Robot;
  readonly chassis: Chassis;
  readonly senses: ArenaSenses;
  /** The light level of the board, see `lampLevel`. */
  readonly boardLevel: () => number | null;
  /** Call it after each step of the world. */
  step(): void;
}

/** The surroundings of a robot. */
export interface Place {
  readonly clock: Clock;
  readonly board: Board;
  readonly world: World;
  readonly start: RobotStart;
  readonly seed: number;
  readonly reality: number;
  /** The light of a remote control on the robot. */
  readonly infrared: InfraredLight;
  readonly traits?: Traits | undefined;
  /** Called when the program sets an output of the robot; left out: nothing is reported. */
  readonly onSet?: OnSet | undefined;
}

/** Puts the robot of a run into the world and plugs the board into it; `null` for the bare board. */
export function mountRobot(hardware: Hardware, place: Place): Mounted | null {
  const type = hardware.robot;
  const build = type && findBuild(type.id);
  if (type === null || build === null) return null;
  const { clock, world, start } = place;
  const { at, heading, scale } = start;
  const pose: Pose = { xMm: at[0], yMm: at[1], headingRad: radOf(heading) };
  const reality = createReality(place.reality, place.seed, () => clock.nowUs, place.traits);
  const body = reality.body(scaledBody(bodyOf(type, hardware.options), scale));
  const chassis = world.addChassis(body, pose, () => clock.nowUs);
  chassis.setBattery((left, right) => reality.supply({ left, right }));
  const steps = new LastSteps(chassis, () => clock.nowUs, MOST_STEPS_BACK);
  const context: RobotContext = {
    clock,
    board: isMisplugged(hardware) ? spareBoard(type) : place.board,
    chassis,
    ...floorBelow(steps, chassis, world, reality),
    distance: (from, headingRad, cone) => {
      const direction = chassis.pose().headingRad + headingRad;
      const heard = heardCone(cone, hardware.options);
      return reality.echo(world.distanceCone(chassis.toWorld(from), direction, heard, chassis));
    },
    depths: (from, view) => {
      const { headingRad } = chassis.pose();
      return reality.depths(world.depthGrid(chassis.toWorld(from), headingRad, view, chassis));
    },
    light: (spot, radiusMm) => reality.light(litBy(world.sharesAt(chassis.toWorld(spot), radiusMm))),
    lightAhead: (from, cone) => {
      const { headingRad } = chassis.pose();
      const hit = world.colorAhead(chassis.toWorld(from), headingRad, cone, chassis);
      return hit && { distanceMm: hit.distanceMm, light: reality.light(litBy(hit.shares)) };
    },
    camera: (from, view) => world.camera(chassis.toWorld(from), chassis.pose().headingRad, view, chassis),
    seen: (results) => reality.seen(results),
    colourNumber,
    lightLevel: robotLight(world, { chassis, sensors: place.board.sensors, nowUs: () => clock.nowUs }),
    miss: () => reality.miss(),
    supplyMv: () => Math.round(FULL_MV * reality.supply({ left: chassis.duty(0), right: chassis.duty(1) })),
    infrared: place.infrared,
    options: hardware.options,
    scale,
    lineReadings: place.traits?.line ?? {},
    ...(place.onSet && { onSet: place.onSet }),
  };
  const robot = withCamera(withColourSensors(build.attach(context), type, context), type, context);
  const boardLevel = () => lampLevel(world, chassis.toWorld({ x: 0, y: 0 }), chassis);
  const senses = createArenaSenses(place.board.sensors, {
    chassis,
    ground: (spot, radiusMm) => world.reflectanceAt(chassis.toWorld(spot), radiusMm),
    light: boardLevel,
  });
  const step = (): void => {
    steps.note();
    robot.step();
    senses.step();
  };
  return { type, robot, chassis, senses, step, boardLevel };
}

/** The floor as the line sensors of a robot see it, now and after its last steps. */
function floorBelow(
  steps: LastSteps,
  chassis: Chassis,
  world: World,
  reality: Reality,
): Pick<RobotContext, 'ground' | 'beforePaint'> {
  return {
    ground: (spot, radiusMm, ago) => {
      const past = ago === undefined ? null : steps.ago(ago);
      const seen = world.reflectanceAt(chassis.toWorld(spot, past?.stance), radiusMm);
      return reality.reflectance(seen, spot, past?.us);
    },
    beforePaint: (act) => world.beforePaint(act),
  };
}

/** The light that something returns, from its shares compared with bare floor. */
const litBy = ([red, green, blue]: Shares): Shares => [red * floorRgb[0], green * floorRgb[1], blue * floorRgb[2]];

/** The board for a robot that does not fit the run's board: without a program, so that the robot receives nothing. */
function spareBoard(type: RobotType): Board {
  const board = findBoard(type.board);
  if (board === undefined) throw new Error(`${type.id} names a board that does not exist: ${type.board}`);
  return new Board(board, new Clock());
}
