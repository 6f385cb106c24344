import { distanceToOutline, type Outline } from '#scene/outline';
import type { Vec } from '#core/geometry';
import { memoOf } from '#core/memo';
import { isSame } from '#core/same';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { solidParts } from '#scene/kinds/index';
import { carriersOf, STUCK_MM } from '#scene/kinds/stuck-tags';
import type { Point, Scene, SceneObject, Shaped, Tag, Wall } from '#scene/scene';
import { toOwnFrame } from '#scene/shape/shape';
import { changing, combined, removing } from './edits';
import { movedBy } from './kinds/index';
import { directionDeg, distanceMm, middleBetween, plus, rotationDeg, toPoint, toVec, turned } from './plane';

/** The things that a standing tag may be stuck to while a course is built: those that have sides. */
type Holder = Extract<SceneObject, { type: 'block' | 'fixed-block' | 'mover' | 'wall' }>;

const isHolder = ({ type }: SceneObject): boolean =>
  type === 'block' || type === 'fixed-block' || type === 'mover' || type === 'wall';

/** The things that hold the tags of a course, by the tags' ids: those that carry them in a run, else the nearest in reach. */
const holdersOf = memoOf((objects: readonly SceneObject[]): ReadonlyMap<string, string> => {
  const tags = objects.filter((object): object is Tag => object.type === 'tag' && object.flat !== true);
  if (tags.length === 0) return new Map();
  const carriers = carriersOf(objects);
  const fixed = objects.filter(({ type }) => type === 'fixed-block' || type === 'wall');
  return new Map(
    tags.flatMap((tag) => {
      const id = carriers.get(tag.id)?.id ?? nearest(fixed, toVec(tag.at));
      return id === null ? [] : [[tag.id, id] as const];
    }),
  );
});

function nearest(things: readonly SceneObject[], at: Vec): string | null {
  let [id, bestMm]: [string | null, number] = [null, STUCK_MM];
  for (const thing of things) {
    const mm = distanceTo(solidParts(thing), at);
    if (mm > bestMm || (mm === bestMm && id !== null)) continue;
    [id, bestMm] = [thing.id, mm];
  }
  return id;
}

const distanceTo = (parts: readonly Outline[], at: Vec): number =>
  Math.min(Infinity, ...parts.map((part) => distanceToOutline(part, at)));

/** The tags that are stuck to some things of a course and can be changed, in the order of painting. */
export function tagsStuckTo({ objects }: Pick<Scene, 'objects'>, ids: readonly string[]): readonly Tag[] {
  const holders = holdersOf(objects);
  if (holders.size === 0) return [];
  const held = new Set(ids);
  return objects.filter(
    (object): object is Tag =>
      object.type === 'tag' && object.lock === undefined && held.has(holders.get(object.id) ?? ''),
  );
}

/**
 * An edit that also moves, turns or takes away the tags that are stuck to what it moves, turns or takes away. Tags that it
 * changes itself, that are locked, or that stand at something else afterwards, are left alone.
 */
export function withStuck(scene: Scene, edit: SceneEdit): SceneEdit {
  if (holdersOf(scene.objects).size === 0) return edit;
  const { objects } = applyEdit(scene, edit);
  if (objects === scene.objects) return edit;
  const now = new Map(objects.map((object) => [object.id, object]));
  const [changed, gone]: [SceneObject[], string[]] = [[], []];
  for (const holder of scene.objects) {
    const after = now.get(holder.id);
    if (after === holder || !isHolder(holder)) continue;
    for (const tag of tagsStuckTo(scene, [holder.id])) {
      if (now.get(tag.id) !== tag) continue;
      if (after !== undefined && isHolder(after)) changed.push(...goneAlong(tag, holder as Holder, after as Holder));
      else if (!holdersOf(objects).has(tag.id)) gone.push(tag.id);
    }
  }
  return joined(edit, changed, gone);
}

/** An edit and further ones of the same course as one, in the shortest form. */
function joined(edit: SceneEdit, changed: readonly SceneObject[], gone: readonly string[]): SceneEdit {
  if (edit.type === 'replace' && gone.length === 0)
    return { ...edit, changes: [...edit.changes, ...changed.map((object) => ({ id: object.id, by: [object] }))] };
  if (edit.type === 'remove' && changed.length === 0) return { ...edit, ids: [...edit.ids, ...gone] };
  return combined([edit, changing(changed), removing(gone)]) ?? edit;
}

/** A tag where it has gone with its thing; none if it is where it was. */
function goneAlong(tag: Tag, before: Holder, after: Holder): readonly SceneObject[] {
  const [from, to] = [frameOf(before), frameOf(after)];
  if (isSame(from, to)) return [];
  if (from.angle === to.angle && isSame(from.size, to.size))
    return [movedBy(tag, Math.round(to.at[0] - from.at[0]), Math.round(to.at[1] - from.at[1]))];
  const own = toOwnFrame(from, toVec(tag.at));
  const place = { x: along(own.x, from.size[0], to.size[0]), y: along(own.y, from.size[1], to.size[1]) };
  const at = toPoint(plus(toVec(to.at), turned(place, to.angle)));
  const placed: Tag = { ...tag, at, angle: rotationDeg(tag.angle + to.angle - from.angle) };
  return isSame(placed, tag) ? [] : [placed];
}

/** A place along a side that has another length: within the side in proportion, beyond it as far from its end as before. */
function along(mm: number, before: number, after: number): number {
  const beyond = Math.max(0, Math.abs(mm) - before / 2);
  return beyond === 0 ? (mm * after) / before : Math.sign(mm) * (after / 2 + beyond);
}

/** The frame in which a tag has its place: middle, direction and sides of its thing. */
const frameOf = (holder: Holder): Pick<Shaped, 'at' | 'angle' | 'size'> =>
  holder.type === 'wall' ? wallFrame(holder) : { at: holder.at, angle: holder.angle, size: holder.size };

function wallFrame({ from, to, thickness }: Wall): Pick<Shaped, 'at' | 'angle' | 'size'> {
  const [start, end] = [toVec(from), toVec(to)];
  const { x, y } = middleBetween(start, end);
  const size: Point = [Math.max(1, distanceMm(start, end)), thickness];
  return { at: [x, y], angle: directionDeg(start, end), size };
}
