import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import type { Point, Scene, Stroke } from '#scene/scene';
import { FINGER_TOLERANCE_MM, simplified } from '#scene/simplify';
import { changing, replacing } from '../edits';
import { toVec } from '../plane';
import { freeObjects } from '../selection';
import { smooth } from '../tools/smooth';
import type { Selection } from '../tools/tool';
import { bridged, closed, type Look } from './join-lines';

/** The selected lines, in the order of painting. */
export const selectedLines = (scene: Scene, selection: Selection): readonly Stroke[] =>
  freeObjects(scene, selection).filter((object) => object.type === 'stroke');

/** Gives all selected lines a width, a colour, or both; `null` when they have them already. */
export const restyled = (scene: Scene, selection: Selection, look: Partial<Look>): SceneEdit | null =>
  changed(scene, selection, (stroke) => ({ ...stroke, ...look }));

/** How far a smoothed line may be from the smooth curve, in mm. Chosen: half of what a drawn line may. */
const SMOOTH_MM = 0.5;

/** Makes the selected lines a step smoother; their ends stay. `null` when nothing changes. */
export const smoothed = (scene: Scene, selection: Selection): SceneEdit | null =>
  changed(scene, selection, (stroke) =>
    withPoints(stroke, simplified(smooth(stroke.points.map(toVec)), SMOOTH_MM), stroke.points.length > 2),
  );

/** Tolerances for simplifying a line, in mm: the first that takes away a tenth of its points counts. */
const TOLERANCES_MM = [FINGER_TOLERANCE_MM, 4, 8, 16];

/** Leaves points of the selected lines out, as many as one step coarser allows. `null` when nothing changes. */
export const coarsened = (scene: Scene, selection: Selection): SceneEdit | null =>
  changed(scene, selection, (stroke) => {
    const path = stroke.points.map(toVec);
    for (const toleranceMm of TOLERANCES_MM) {
      const points = simplified(path, toleranceMm);
      // A step is felt: at least a tenth of the points goes.
      if (points.length <= 0.9 * stroke.points.length) return withPoints(stroke, points, true);
    }
    return stroke;
  });

/** Makes two selected lines one: `null` unless just two with open ends are selected. */
export function joinedLines(scene: Scene, selection: Selection): SceneEdit | null {
  const [one, other, ...more] = selectedLines(scene, selection);
  const line = one && other && more.length === 0 ? bridged(one, other) : null;
  if (!line || !other) return null;
  return replacing([
    { id: line.id, by: [line] },
    { id: other.id, by: [] },
  ]);
}

/** Closes all selected lines that are open and have a bend; `null` for none. */
export const closedLines = (scene: Scene, selection: Selection): SceneEdit | null =>
  changed(scene, selection, (stroke) => closed(stroke) ?? stroke);

function withPoints(stroke: Stroke, points: readonly Point[], may: boolean): Stroke {
  return may && points.length > 1 ? { ...stroke, points } : stroke;
}

function changed(scene: Scene, selection: Selection, change: (stroke: Stroke) => Stroke): SceneEdit | null {
  const lines = selectedLines(scene, selection);
  return changing(lines.map(change).filter((stroke, index) => !isSame(stroke, lines[index])));
}
