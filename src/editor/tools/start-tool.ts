import { placeInside } from '#scene/placement';
import { endOf, isTap, startOf } from '../drag';
import { startingAt } from '../edits';
import { handleAt } from '../handles';
import { directionDeg, steppedDeg, toPoint } from '../plane';
import { thingsAt } from '../selection';
import { isInArena, onGrid } from '../snap';
import { selectTool } from './select-tool';
import type { Drag, Selection, Tool, ToolContext } from './tool';

/** Steps of the robot's heading: what set squares have, and whole degrees when free. */
const STEP_DEG = 15;

/** The selection of the robot alone. */
const ROBOT: Selection = { ids: [], robot: true };

/**
 * Sets the robot's start. Dragging the robot moves it, and dragging its knob turns it. Elsewhere a tap sets its place, a
 * drag also its direction. The robot stays inside the arena.
 */
export const startTool: Tool = {
  id: 'start',
  cursor: 'crosshair',
  edit(drag, context) {
    const { scene, footprint } = context;
    const place = startOf(drag);
    if (!isInArena(place, scene.size, drag.reachMm)) return null;
    if (!isTap(drag) && isOnRobot(drag, context)) return selectTool.edit(drag, { ...context, selection: ROBOT });
    const heading = isTap(drag)
      ? scene.robot.heading
      : steppedDeg(directionDeg(place, endOf(drag)), drag.free ? 1 : STEP_DEG);
    const at = toPoint(drag.free ? place : onGrid(place, drag.reachMm));
    return startingAt(scene, { at: placeInside({ ...scene.robot, at, heading }, scene.size, footprint), heading });
  },
  turns: (drag, context) =>
    isTap(drag) || !isOnRobot(drag, context)
      ? null
      : (selectTool.turns?.(drag, { ...context, selection: ROBOT }) ?? null),
};

/** True if a drag began on the robot or on the knob by which it is turned. */
function isOnRobot(drag: Drag, { scene, footprint }: ToolContext): boolean {
  const start = startOf(drag);
  if (handleAt(scene, ROBOT, footprint, start, drag.reachMm) !== null) return true;
  return thingsAt(scene, start, drag.reachMm, footprint).includes(null);
}
