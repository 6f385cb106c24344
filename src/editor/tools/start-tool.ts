import { endOf, isTap, startOf } from '../drag';
import { startingAt } from '../edits';
import { directionDeg, steppedDeg, toPoint } from '../plane';
import { placeInside } from '../robot-place';
import { isInArena, onGrid } from '../snap';
import type { Tool } from './tool';

/** Steps of the robot's heading: what set squares have, and whole degrees when free. */
const STEP_DEG = 15;

/** Sets the robot's start: a tap sets its place, a drag also its direction. The robot stays inside the arena. */
export const startTool: Tool = {
  id: 'start',
  cursor: 'crosshair',
  edit(drag, { scene, footprint }) {
    const place = startOf(drag);
    if (!isInArena(place, scene.size, drag.reachMm)) return null;
    const heading = isTap(drag)
      ? scene.robot.heading
      : steppedDeg(directionDeg(place, endOf(drag)), drag.free ? 1 : STEP_DEG);
    const at = toPoint(drag.free ? place : onGrid(place, drag.reachMm));
    return startingAt(scene, { at: placeInside({ ...scene.robot, at, heading }, scene.size, footprint), heading });
  },
};
