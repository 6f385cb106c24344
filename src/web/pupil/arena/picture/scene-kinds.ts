/**
 * The drawing of what only some courses have: obstacles, words, a background, and what waits for the next start. Loaded when
 * any of it is first to be seen.
 */
import type { Pose } from '#core/geometry';
import { kindOf } from '#picture/kinds/index';
import { carriedTags, tagAt, type CarriedTag } from '#scene/kinds/stuck-tags';
import type { Background, Mover, Scene, SceneObject } from '#scene/scene';
import { createBackgroundShelf, drawBackground } from './draw-background';
import { drawStanding } from './draw-bodies';
import { createStillScene, type StillState } from './switched';
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
  /** The course with its lamps and barriers as a run has them, without tags on what moves; the same one as long as it stays so. */
  inRun(scene: Scene, state: StillState | null): Scene;
  /** Spikes and barriers, which stand like walls, tags and lamps. */
  spikes(context: CanvasRenderingContext2D, view: View, objects: readonly SceneObject[], palette: Palette): void;
  /** The tags on blocks and moving obstacles, which `inRun` leaves out. */
  carried(objects: readonly SceneObject[]): readonly CarriedTag[];
  /** Draws one of them; `pose`: where its thing is now, `null`: before a run. */
  carriedTag(context: CanvasRenderingContext2D, view: View, one: CarriedTag, pose: Pose | null, palette: Palette): void;
  mover(context: CanvasRenderingContext2D, view: View, mover: Mover, pose: Pose | null, palette: Palette): void;
  /** Draws the changes that wait for the next start, over all the rest. */
  waiting(context: CanvasRenderingContext2D, view: View, waiting: Waiting, palette: Palette): void;
}

/** The kinds that stand, or hang, where they are; lamps last, above the others. */
const STANDING: readonly SceneObject['type'][] = ['spikes', 'barrier', 'tag', 'lamp'];

/**
 * Makes the drawing of one arena.
 *
 * @param ready called when a requested picture can be drawn
 */
export function createSceneKinds(ready: () => void): SceneKinds {
  const shelf = createBackgroundShelf(ready);
  const inRun = createStillScene();
  return {
    background: (context, view, background) => drawBackground(context, view, background, shelf),
    signs(context, view, objects, palette) {
      const look = { ...lookOf(view, palette), isLit: true };
      for (const object of objects) drawShapes(context, view, kindOf(object).mark?.(object, look, objects) ?? []);
    },
    spikes(context, view, objects, palette) {
      for (const object of objects)
        if (STANDING.includes(object.type)) drawStanding(context, view, kindOf(object), object, palette);
    },
    inRun,
    carried: carriedTags,
    carriedTag: (context, view, one, pose, palette) =>
      drawStanding(context, view, kindOf(one.tag), tagAt(one, pose), palette),
    mover: drawMover,
    waiting: drawWaiting,
  };
}
