import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import type { Point, Scene, Stroke } from '#scene/scene';
import { adding, replacing, roomIn } from '../edits';
import { distanceMm, toVec } from '../plane';

/** How a line looks: only lines that look the same become one by themselves. */
export type Look = Pick<Stroke, 'width' | 'color'>;

const looksLike = (one: Look, other: Look): boolean => one.width === other.width && one.color === other.color;

/** The first and the last point of a line with open ends; `null`: it is a dot or closed. */
export function openEnds({ points }: Pick<Stroke, 'points'>): readonly [Point, Point] | null {
  const [first, last] = [points[0], points[points.length - 1]];
  return !first || !last || points.length < 2 || isSame(first, last) ? null : [first, last];
}

/** The open end of a free line of this look that is nearest to a place and at most so far away, or `null`. */
export function endNear(scene: Scene, look: Look, place: Vec, reachMm: number, without = ''): Point | null {
  let best: Point | null = null;
  let bestMm = reachMm;
  for (const object of scene.objects) {
    if (object.type !== 'stroke' || object.lock || object.id === without || !looksLike(object, look)) continue;
    for (const end of openEnds(object) ?? []) {
      const mm = distanceMm(toVec(end), place);
      if (mm > bestMm) continue;
      best = end;
      bestMm = mm;
    }
  }
  return best;
}

/**
 * Puts a line into the course. With each free line of the same look on whose open end it begins or ends it becomes one, in the
 * place of the first of them; a changed line keeps its own.
 *
 * @param stroke a new line, or one of the course as it is to be
 */
export function puttingJoined(scene: Scene, stroke: Stroke): SceneEdit | null {
  const isNew = !scene.objects.some(({ id }) => id === stroke.id);
  const joined = joinedWithOthers(scene, stroke);
  const [first, second] = joined.ids;
  const points = joined.points;
  if (first === undefined) return isNew ? adding(scene, [stroke]) : replacing([{ id: stroke.id, by: [stroke] }]);
  const id = isNew ? first : stroke.id;
  if (isNew && stroke.points.length > roomIn(scene).points) return null;
  const gone = (isNew ? [second] : [first, second]).filter((one) => one !== undefined);
  // What goes on from a line of a group belongs to it.
  const { group } = (isNew ? scene.objects.find((object) => object.id === first) : null) ?? stroke;
  const line = { ...stroke, id, points, ...(group === undefined ? {} : { group }) };
  return replacing([{ id, by: [line] }, ...gone.map((one) => ({ id: one, by: [] }))]);
}

/** The points of a line with those of the lines on whose ends it lies, and the ids of these. */
function joinedWithOthers(
  scene: Scene,
  stroke: Stroke,
): { readonly points: readonly Point[]; readonly ids: readonly string[] } {
  const ids: string[] = [];
  let points = stroke.points;
  // At its end, then turned round at what was its beginning: twice round, it has its direction again.
  for (let side = 0; side < 2; side += 1) {
    const end = openEnds({ points })?.[1];
    const other = end && otherAt(scene, stroke, end, ids);
    if (other) {
      ids.push(other.id);
      points = [...points, ...startingAt(other.points, end).slice(1)];
    }
    points = reversed(points);
  }
  return { points, ids };
}

function otherAt(scene: Scene, stroke: Stroke, place: Point, without: readonly string[]): Stroke | null {
  for (const object of scene.objects) {
    if (object.type !== 'stroke' || object.lock || object.id === stroke.id || without.includes(object.id)) continue;
    if (looksLike(object, stroke) && openEnds(object)?.some((end) => isSame(end, place)) === true) return object;
  }
  return null;
}

const reversed = (points: readonly Point[]): readonly Point[] => [...points].reverse();

/** The points of a line in the direction in which it begins at `start`, one of its ends. */
const startingAt = (points: readonly Point[], start: Point): readonly Point[] =>
  points[0] && isSame(points[0], start) ? points : reversed(points);

/** Two lines as one with the look of the first: their nearest ends are joined, by a straight piece if need be. */
export function bridged(one: Stroke, other: Stroke): Stroke | null {
  const [ends, otherEnds] = [openEnds(one), openEnds(other)];
  if (!ends || !otherEnds) return null;
  let best: readonly [from: Point, to: Point] | null = null;
  for (const from of ends)
    for (const to of otherEnds)
      if (!best || distanceMm(toVec(from), toVec(to)) < distanceMm(toVec(best[0]), toVec(best[1]))) best = [from, to];
  if (!best) return null;
  const [from, to] = best;
  const head = reversed(startingAt(one.points, from));
  const tail = startingAt(other.points, to);
  return { ...one, points: [...head, ...(isSame(from, to) ? tail.slice(1) : tail)] };
}

/** A line with open ends and at least one bend as a closed one; `null`: it cannot be closed. */
export function closed(stroke: Stroke): Stroke | null {
  const [first] = openEnds(stroke) ?? [];
  return first && stroke.points.length > 2 ? { ...stroke, points: [...stroke.points, first] } : null;
}
