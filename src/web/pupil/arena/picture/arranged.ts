import { radOf } from '#core/angle';
import type { OptionValues } from '#core/option';
import { nearestOfFan } from '#robots/lidar-fan';
import { bareState, type RobotState } from '#robots/robot';
import type { Block, Scene } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import { memoOf } from '#core/memo';
import type { ArenaRobot, PlacedBlock } from '../model/arena-model';
import { placedAtStart } from './draw-bodies';

/** The content of the arena at one moment. */
export interface Arranged {
  readonly robot: ArenaRobot | null;
  /** The blocks that can be pushed. */
  readonly blocks: readonly PlacedBlock[];
}

/** Parts that a robot may carry besides its own. */
export type Carried = Partial<Pick<RobotState, 'attachments' | 'bumper'>>;

/** The bumper of a robot that carries one from the start: its option `bumper` is `always`; else `null`. */
export function bumperAtStart(options: OptionValues): RobotState['bumper'] {
  return options['bumper'] === 'always' ? { left: false, right: false } : null;
}

/**
 * The course as it stands before a run, or as a snapshot of a run says.
 *
 * @param carried what the robot carries before a run
 */
export function arranged(
  scene: Scene,
  snapshot: Pick<Snapshot, 'robot' | 'blocks'> | null,
  carried: Carried = {},
): Arranged {
  const placed = blocksOf(scene.objects);
  const blocks =
    snapshot === null
      ? placed
      : placed.map((block) => {
          const pose = snapshot.blocks[block.id];
          return pose === undefined ? block : { ...block, pose };
        });
  return { robot: snapshot === null ? robotAtStart(scene, carried) : snapshot.robot, blocks };
}

/** The blocks that can be pushed, where they start. A course is looked through once, not for every picture of a run. */
const blocksOf = memoOf((objects: Scene['objects']): readonly PlacedBlock[] =>
  objects.filter((object): object is Block => object.type === 'block').map(placedAtStart),
);

/** True if all blocks lie where they lay. */
export function lieStill(before: readonly PlacedBlock[], now: readonly PlacedBlock[]): boolean {
  return (
    before === now ||
    (before.length === now.length &&
      now.every((block, i) => {
        const other = before[i];
        return other !== undefined && liesStill(other, block);
      }))
  );
}

/** True if a block lies where it lay. */
export function liesStill(before: PlacedBlock, now: PlacedBlock): boolean {
  if (before === now) return true;
  const { id, pose, sizeMm } = now;
  return (
    before.id === id &&
    before.sizeMm.x === sizeMm.x &&
    before.sizeMm.y === sizeMm.y &&
    before.round === now.round &&
    before.corners === now.corners &&
    before.pose.xMm === pose.xMm &&
    before.pose.yMm === pose.yMm &&
    before.pose.headingRad === pose.headingRad
  );
}

/** The robot of a course where it starts, with everything off. */
export function robotAtStart(scene: Scene, carried: Carried = {}): ArenaRobot {
  const { at, heading } = scene.robot;
  return {
    pose: { xMm: at[0], yMm: at[1], headingRad: radOf(heading) },
    wheelTurnRad: [0, 0],
    pathMm: 0,
    turnedRad: 0,
    state: { ...bareState, ...carried },
  };
}

/** The facts for a text about the robot, in the units of the classroom. */
export interface ArenaSummary {
  readonly xCm: number;
  readonly yCm: number;
  /** Whole degrees counter-clockwise from +x, −179 … 180. */
  readonly headingDeg: number;
  /** The distance that the ultrasonic sensor measures, else the nearest that a lidar sees; `null`: nothing in range, or neither. */
  readonly distanceCm: number | null;
}

/** The figures of a summary, or `null` without a robot. */
export function summaryOf(robot: ArenaRobot | null): ArenaSummary | null {
  if (robot === null) return null;
  const { ultrasonic, lidar } = robot.state;
  const distanceMm = (ultrasonic ? ultrasonic.distanceMm : lidar && nearestOfFan(lidar)?.depthMm) ?? null;
  return {
    xCm: Math.round(robot.pose.xMm / 10),
    yCm: Math.round(robot.pose.yMm / 10),
    headingDeg: degreesOf(robot.pose.headingRad, 1),
    distanceCm: distanceMm === null ? null : Math.round(distanceMm / 10),
  };
}

/** A heading in degrees, more than −180 up to 180, rounded to one part in `perDegree` of a degree. */
export function degreesOf(headingRad: number, perDegree: number): number {
  const turns = headingRad / (2 * Math.PI);
  const degrees = Math.round((turns - Math.round(turns)) * 360 * perDegree) / perDegree + 0;
  return degrees === -180 ? 180 : degrees;
}
