import type { SceneEdit } from '#scene/edit';
import type { Outline } from '#scene/outline';
import { placeInside } from '#scene/placement';
import type { Scene } from '#scene/scene';
import { changing, combined, startingAt } from '../edits';
import { kindOf } from '../kinds/index';
import { mirroredDeg, mirroredPoint, type Axis } from '../kinds/kind';
import { boundsOfSelection, freeObjects } from '../selection';
import type { Selection } from '../tools/tool';

/** Mirrors what is selected at its middle: `x` swaps left and right, `y` up and down. `null` when nothing is selected. */
export function mirrored(
  scene: Scene,
  selection: Selection,
  axis: Axis,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const around = boundsOfSelection(scene, selection, footprint);
  if (!around) return null;
  const atMm = axis === 'x' ? (around.minX + around.maxX) / 2 : (around.minY + around.maxY) / 2;
  const { robot, size } = scene;
  const turned = { at: mirroredPoint(robot.at, axis, atMm), heading: mirroredDeg(robot.heading, axis) };
  return combined([
    changing(freeObjects(scene, selection).map((object) => kindOf(object).mirrored(object, axis, atMm))),
    selection.robot
      ? startingAt(scene, { ...turned, at: placeInside({ ...robot, ...turned }, size, footprint) })
      : null,
  ]);
}
