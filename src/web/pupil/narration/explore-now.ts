import { radOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import type { RobotType } from '#robots/robot';
import { movedTags, shiftedTags } from '#scene/kinds/stuck-tags';
import type { Scene } from '#scene/scene';

import type { RunParts } from '../../session/run/parts';
import { createExplorer, tellAround, type Asked, type Told } from './explore';

/** The course to explore, with everything that the run and the hand have moved. */
export interface Explored extends Pick<RunParts, 'run' | 'hand'> {
  readonly scene: () => Scene;
  readonly robot: () => RobotType | null;
  /** Place of the keyboard's crosshair, world mm, while it is visible. */
  readonly crosshair: () => Vec | null;
}

/** Explores the arena as it is at that moment. */
export interface ExplorerNow {
  /** Describes the next thing, or the one before. */
  step(back: boolean): Told;
  /** Describes the surroundings of the robot, or of the crosshair. */
  around(): Told;
}

export function createExplorerOf(explored: Explored): ExplorerNow {
  const explorer = createExplorer();
  return {
    step: (back) => explorer.step(askedOf(explored), back),
    around: () => tellAround(askedOf(explored)),
  };
}

/** The course as it is now. */
function askedOf({ run, hand, scene, robot, crosshair }: Explored): Asked {
  const course = scene();
  const type = robot();
  const { at, heading, scale } = course.robot;
  const snapshot = run.shown.value;
  const start: Pose = { xMm: at[0], yMm: at[1], headingRad: radOf(heading) };
  const inRun: Readonly<Record<string, Pose>> = { ...snapshot?.blocks, ...snapshot?.movers };
  const inHand = Object.entries(hand.blocks.value).map(([id, { xMm, yMm, headingDeg }]): [string, Pose] => [
    id,
    { xMm, yMm, headingRad: radOf(headingDeg) },
  ]);
  return {
    scene: course,
    moved:
      snapshot === null
        ? { ...Object.fromEntries(inHand), ...shiftedTags(course.objects) }
        : { ...inRun, ...movedTags(course.objects, inRun) },
    robot: type === null ? null : (snapshot?.robot?.pose ?? start),
    body: (type?.body.outlineMm ?? []).map((part) => part.map(({ x, y }) => ({ x: x * scale, y: y * scale }))),
    crosshair: crosshair(),
  };
}
