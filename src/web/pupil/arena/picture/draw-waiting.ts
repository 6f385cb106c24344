import type { Vec } from '#core/geometry';
import type { RobotStart } from '#scene/scene';
import { floorPx } from './draw-floor';
import { drawObject } from './draw-object';
import { drawRobotOutline, outlinePath, robotOutlinePx } from './draw-outline';
import type { LiveScene } from './live-scene';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';

/** The parts of a course that a run does not know yet, and the robot's start. */
export interface Waiting {
  readonly live: LiveScene;
  /** The robot's start, if it is elsewhere now. */
  readonly start: RobotStart | null;
  /** Convex parts of the robot at scale 1 in its own frame, mm. */
  readonly footprint: readonly (readonly Vec[])[];
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
}

/** Opacity of the objects that wait for the next start. */
const PALE = 0.42;

/**
 * Draws the changes that wait for the next start: new objects pale in a dashed frame, those that go in a dashed frame,
 * the arena's next size, and the robot's start.
 */
export function drawWaiting(context: CanvasRenderingContext2D, view: View, waiting: Waiting, palette: Palette): void {
  const { live, start, footprint, ratio } = waiting;
  context.save();
  context.globalAlpha = PALE;
  for (const object of live.waiting) drawObject(context, view, object, palette);
  context.globalAlpha = 1;
  context.strokeStyle = palette.hand;
  context.lineWidth = 2;
  context.setLineDash([6, 5]);
  const framed = [...live.waiting, ...live.scene.objects.filter(({ id }) => live.leaving.has(id))];
  for (const object of framed) {
    outlinePath(context, view, object, 3);
    context.stroke();
  }
  if (live.size !== null) {
    const { left, top, width, height } = floorPx(view, live.size);
    context.strokeRect(left, top, width, height);
  }
  context.restore();
  if (start !== null) drawRobotOutline(context, robotOutlinePx(view, start, footprint), ratio, palette.trace);
}
