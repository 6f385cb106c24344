import type { Vec } from '#core/geometry';
import { isTap } from '#editor/drag';
import { dragOf, type Gesture } from './gesture';

/** Moves the gesture to a place: the next one of a drag, or the place of a possible next corner. */
export function goTo(gesture: Gesture, at: Vec): void {
  const { path, corners } = gesture;
  const before = path[path.length - 1];
  if (corners > 0) path.splice(corners, Infinity, at);
  else if (before === undefined || before.x !== at.x || before.y !== at.y) path.push(at);
  gesture.isStale = true;
}

/** Drops the place of a possible next corner: only the corners that are set remain. */
export function backToCorners(gesture: Gesture): void {
  gesture.pointer = 'none';
  gesture.path.splice(gesture.corners);
  gesture.isStale = true;
}

/**
 * Sets the place where a gesture was released as a corner, if its tool continues from there.
 *
 * @returns whether it continues
 */
export function setCorner(gesture: Gesture): boolean {
  const { path, corners, tool, context, pointer } = gesture;
  const drag = dragOf(gesture);
  if (tool.goesOn?.(drag, context) !== true) return false;
  const [start, end] = [path[0], path[path.length - 1]];
  if (corners === 0 && start && end) path.splice(0, Infinity, ...(isTap(drag) ? [start] : [start, end]));
  gesture.corners = path.length;
  gesture.isStale = true;
  if (pointer !== null) gesture.pointer = 'none';
  return true;
}

/** Takes the corner that was set last back; returns whether one is left. */
export function takeCornerBack(gesture: Gesture): boolean {
  const at = gesture.path[gesture.path.length - 1];
  const hasPlace = gesture.path.length > gesture.corners;
  gesture.corners -= 1;
  gesture.path.splice(gesture.corners);
  if (hasPlace && at) gesture.path.push(at);
  gesture.isStale = true;
  return gesture.corners > 0;
}
