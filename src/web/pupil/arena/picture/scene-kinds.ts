/**
 * The drawing of what only some courses have: obstacles, words, a background, and what waits for the next start. Loaded when
 * any of it is first to be seen.
 */
import type { Pose } from '#core/geometry';
import { kindOf } from '#picture/kinds/index';
import { spikes } from '#picture/kinds/spikes';
import type { Background, Mover, SceneObject } from '#scene/scene';
import { createBackgroundShelf, drawBackground } from './draw-background';
import { drawStanding } from './draw-bodies';
import { drawMover } from './draw-object';
import { drawShapes, lookOf } from './draw-shapes';
import { drawWaiting, type Waiting } from './draw-waiting';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';

/** Draws the kinds of objects that are loaded on demand, in CSS px. */
export interface SceneKinds {
  background(context: CanvasRenderingContext2D, view: View, background: Background): void;
  /** Words and the ways of moving obstacles, over zones and lines. */
  signs(context: CanvasRenderingContext2D, view: View, objects: readonly SceneObject[], palette: Palette): void;
  /** Spikes, which stand like walls. */
  spikes(context: CanvasRenderingContext2D, view: View, objects: readonly SceneObject[], palette: Palette): void;
  mover(context: CanvasRenderingContext2D, view: View, mover: Mover, pose: Pose | null, palette: Palette): void;
  /** Draws the changes that wait for the next start, over all the rest. */
  waiting(context: CanvasRenderingContext2D, view: View, waiting: Waiting, palette: Palette): void;
}

/**
 * Makes the drawing of one arena.
 *
 * @param ready called when a requested picture can be drawn
 */
export function createSceneKinds(ready: () => void): SceneKinds {
  const shelf = createBackgroundShelf(ready);
  return {
    background: (context, view, background) => drawBackground(context, view, background, shelf),
    signs(context, view, objects, palette) {
      const look = lookOf(view, palette);
      for (const object of objects) drawShapes(context, view, kindOf(object).mark?.(object, look, objects) ?? []);
    },
    spikes(context, view, objects, palette) {
      for (const object of objects) if (object.type === 'spikes') drawStanding(context, view, spikes, object, palette);
    },
    mover: drawMover,
    waiting: drawWaiting,
  };
}
