import type { Vec } from '#core/geometry';
import { singleEdits, type SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import type { Bounds } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';
import { placeOf } from '../kinds/index';
import { stepOfCopy } from '../moves';
import { directionDeg, distanceMm, minus, toVec } from '../plane';
import { endsOf } from './frames';

/** Live measurement of a gesture, in mm and degrees. */
export type Reading =
  /** A line, from the end that stays; or one that is drawn freely, which has no direction. */
  | { readonly type: 'length'; readonly mm: number; readonly deg: number | null; readonly from: Vec }
  /** Along the thing's own x and y; `from`: the corner of a new one from which it was drawn. */
  | { readonly type: 'size'; readonly width: number; readonly height: number; readonly from: Vec | null }
  | { readonly type: 'moved'; readonly by: Vec }
  /** Counter-clockwise about a place. */
  | { readonly type: 'turned'; readonly byDeg: number; readonly about: Vec }
  /** A direction that is drawn. */
  | { readonly type: 'heading'; readonly deg: number; readonly from: Vec }
  /** The place of something without a size of its own. */
  | { readonly type: 'place'; readonly at: Vec };

/**
 * The measurement of an edit; of things that change together the first counts. `null`: none.
 *
 * @param start where something new is drawn from
 */
export function readingOf(scene: Scene, edit: SceneEdit, start: Vec | null = null): Reading | null {
  const [first] = singleEdits(edit);
  if (first?.type === 'add') {
    const [object, second] = first.objects;
    const by = object ? stepOfCopy(object, scene.objects) : null;
    if (by) return { type: 'moved', by };
    return object && !second ? newReading(object, start) : null;
  }
  if (first?.type === 'robot') return robotReading(scene, first.robot);
  if (first?.type !== 'replace') return null;
  const [change] = first.changes;
  const [now] = change?.by ?? [];
  const was = scene.objects.find(({ id }) => id === change?.id);
  return was && now && was.id === now.id ? changeReading(was, now) : null;
}

function newReading(object: SceneObject, start: Vec | null): Reading {
  const ends = endsOf(object);
  if (ends) return lengthOf(...ends);
  return 'size' in object
    ? sizeOf(object.size, start && nearestCorner(boundsOf(object), start))
    : { type: 'place', at: toVec(placeOf(object)) };
}

const lengthOf = (from: Vec, to: Vec): Reading => ({
  type: 'length',
  mm: distanceMm(from, to),
  deg: directionDeg(from, to),
  from,
});

const sizeOf = ([width, height]: readonly [number, number], from: Vec | null = null): Reading => ({
  type: 'size',
  width,
  height,
  from,
});

const nearestCorner = ({ minX, minY, maxX, maxY }: Bounds, { x, y }: Vec): Vec => ({
  x: Math.abs(x - minX) <= Math.abs(x - maxX) ? minX : maxX,
  y: Math.abs(y - minY) <= Math.abs(y - maxY) ? minY : maxY,
});

function robotReading({ robot }: Scene, { at, heading }: Partial<Scene['robot']>): Reading | null {
  if (heading !== undefined && heading !== robot.heading)
    return { type: 'heading', deg: heading, from: toVec(at ?? robot.at) };
  return at === undefined ? null : { type: 'moved', by: minus(toVec(at), toVec(robot.at)) };
}

function changeReading(was: SceneObject, now: SceneObject): Reading | null {
  const [before, after] = [endsOf(was), endsOf(now)];
  const by = minus(toVec(placeOf(now)), toVec(placeOf(was)));
  if (isMoved(was, now, by)) return { type: 'moved', by };
  if (before && after) {
    // The end that stays is the one from which its length is measured.
    return distanceMm(before[1], after[1]) === 0 ? lengthOf(after[1], after[0]) : lengthOf(...after);
  }
  if ('size' in was && 'size' in now) return sizeOf(now.size);
  const { minX, minY, maxX, maxY } = boundsOf(now);
  return sizeOf([maxX - minX, maxY - minY]);
}

/** True if all that is seen of a thing has gone the same way. */
function isMoved(was: SceneObject, now: SceneObject, by: Vec): boolean {
  const [one, two] = [boundsOf(was), boundsOf(now)];
  return (
    two.minX - one.minX === by.x &&
    two.maxX - one.maxX === by.x &&
    two.minY - one.minY === by.y &&
    two.maxY - one.maxY === by.y
  );
}
