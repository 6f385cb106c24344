import { wrappedDeg } from '#core/angle';
import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { applyEdit, courseParts, singleEdits, type CourseChanges, type SceneEdit } from '#scene/edit';
import type { PaintColor } from '#scene/paint/paint';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { isHeldAlike } from './arranging/hold';
import { distanceTo, kindOf, middleOf, movedBy, placeOf } from './kinds/index';
import { strokeLengthMm } from './kinds/stroke';
import { directionDeg, distanceMm, toVec } from './plane';

/** The kind of the affected objects; `several` for different kinds. */
export type Kind = SceneObject['type'] | 'several';

/** The effect of an edit, as data from which the page makes a sentence. Lengths in mm, angles in degrees. */
export type EditDescription =
  | { readonly type: 'nothing' }
  | { readonly type: 'drew'; readonly lengthMm: number; readonly widthMm: number; readonly color: PaintColor }
  /** `at`: the middle of the only one. */
  | { readonly type: 'added'; readonly kind: Kind; readonly count: number; readonly at: Point | null }
  | { readonly type: 'removed'; readonly kind: Kind; readonly count: number }
  /** All objects are gone at once. */
  | { readonly type: 'cleared'; readonly count: number }
  /** Strokes were cut or shortened, some perhaps altogether; `lengthMm`: how much of them is gone. */
  | { readonly type: 'erased'; readonly count: number; readonly lengthMm: number }
  /** `at`: where the middle of the only one is now. */
  | {
      readonly type: 'moved';
      readonly kind: Kind;
      readonly count: number;
      readonly byMm: Point;
      readonly at: Point | null;
    }
  /** Counter-clockwise. */
  | { readonly type: 'turned'; readonly kind: Kind; readonly count: number; readonly byDeg: number | null }
  | { readonly type: 'sized'; readonly kind: Kind; readonly size: Point }
  | { readonly type: 'changed'; readonly kind: Kind; readonly count: number }
  | { readonly type: 'locked' | 'unlocked' | 'grouped' | 'ungrouped'; readonly kind: Kind; readonly count: number }
  /** The robot's start. */
  | {
      readonly type: 'robot';
      readonly at: Point | null;
      readonly headingDeg: number | null;
      readonly scale: number | null;
    }
  /** The affected part of the course as a whole. */
  | { readonly type: 'course'; readonly what: readonly (keyof CourseChanges)[] }
  /** Things of different sorts at once. */
  | { readonly type: 'several' };

/** The effect of an edit on a course. */
export function describeEdit(before: Scene, edit: SceneEdit): EditDescription {
  const after = applyEdit(before, edit);
  const parts = [objectsChange(before, after, edit), robotChange(before, after), courseChange(before, after)].filter(
    (part) => part.type !== 'nothing',
  );
  // Name and task may be removed, too: they describe the removed objects.
  const cleared = parts.find(({ type }) => type === 'cleared');
  if (cleared) return cleared;
  return parts.length > 1 ? { type: 'several' } : (parts[0] ?? { type: 'nothing' });
}

function robotChange({ robot: before }: Scene, { robot: after }: Scene): EditDescription {
  if (isSame(before, after)) return { type: 'nothing' };
  return {
    type: 'robot',
    at: isSame(before.at, after.at) ? null : after.at,
    headingDeg: before.heading === after.heading ? null : after.heading,
    scale: before.scale === after.scale ? null : after.scale,
  };
}

function courseChange(before: Scene, after: Scene): EditDescription {
  const what = courseParts.filter(
    (key) => before[key] !== after[key] && (key === 'background' || !isSame(before[key], after[key])),
  );
  return what.length === 0 ? { type: 'nothing' } : { type: 'course', what };
}

interface Changes {
  readonly added: readonly SceneObject[];
  readonly removed: readonly SceneObject[];
  /** Before and after. */
  readonly changed: readonly (readonly [SceneObject, SceneObject])[];
}

/** True if an edit clears the course; removing the last object is no clearing. */
const isClearing = (edit: SceneEdit): boolean => singleEdits(edit).some(({ type }) => type === 'clear');

function objectsChange(before: Scene, after: Scene, edit: SceneEdit): EditDescription {
  if (before.objects === after.objects) return { type: 'nothing' };
  const changes = changesBetween(before, after);
  const { added, removed, changed } = changes;
  if (added.length + removed.length + changed.length === 0) return { type: 'nothing' };
  if (removed.length > 0 && after.objects.length === 0 && isClearing(edit))
    return { type: 'cleared', count: removed.length };
  if (changed.length === 0 && removed.length === 0) return addedChange(added);
  if (changed.length === 0 && added.length === 0)
    return { type: 'removed', kind: commonKind(removed), count: removed.length };
  const erased = erasedChange(changes);
  if (erased) return erased;
  if (removed.length === 0 && added.length === 0) return alteredChange(changed);
  // Walls of a maze that are joined or split.
  const all = [...added, ...removed, ...changed.map(([, now]) => now)];
  return { type: 'changed', kind: commonKind(all), count: all.length };
}

function changesBetween(before: Scene, after: Scene): Changes {
  const old = new Map(before.objects.map((object) => [object.id, object]));
  const now = new Set(after.objects.map(({ id }) => id));
  const added: SceneObject[] = [];
  const changed: (readonly [SceneObject, SceneObject])[] = [];
  for (const object of after.objects) {
    const was = old.get(object.id);
    if (!was) added.push(object);
    else if (!isSame(was, object)) changed.push([was, object]);
  }
  return { added, removed: before.objects.filter(({ id }) => !now.has(id)), changed };
}

function commonKind(objects: readonly SceneObject[]): Kind {
  const kinds = new Set(objects.map(({ type }) => type));
  const [kind] = kinds;
  return kinds.size === 1 && kind ? kind : 'several';
}

function addedChange(added: readonly SceneObject[]): EditDescription {
  const [first] = added;
  if (added.length === 1 && first?.type === 'stroke')
    return { type: 'drew', lengthMm: lengthMm(first), widthMm: first.width, color: first.color };
  return { type: 'added', kind: commonKind(added), count: added.length, at: middleOfOnly(added) };
}

function middleOfOnly(objects: readonly SceneObject[]): Point | null {
  const [first] = objects;
  if (!first || objects.length > 1) return null;
  const { x, y } = middleOf(first);
  return [Math.round(x) + 0, Math.round(y) + 0];
}

const lengthMm = (object: SceneObject): number => (object.type === 'stroke' ? Math.round(strokeLengthMm(object)) : 0);

/** The description of strokes that became shorter or several; `null` if anything else has changed. */
function erasedChange({ added, removed, changed }: Changes): EditDescription | null {
  const all = [...added, ...removed, ...changed.map(([was]) => was)];
  if (all.some(({ type }) => type !== 'stroke')) return null;
  const sum = (objects: readonly SceneObject[]): number => objects.reduce((mm, object) => mm + lengthMm(object), 0);
  const before = sum([...removed, ...changed.map(([was]) => was)]);
  const after = sum([...added, ...changed.map(([, now]) => now)]);
  const isCut = added.length + removed.length > 0 || after < before - 1;
  if (!isCut || changed.some(([was, now]) => lengthMm(now) > lengthMm(was) + 1)) return null;
  if (changed.some(([was, now]) => !endsOn(now, was))) return null;
  return { type: 'erased', count: removed.length + changed.length, lengthMm: Math.max(0, before - after) };
}

/** True if both ends of a line lie on the ink of another: then it is a piece of it. */
function endsOn(piece: SceneObject, whole: SceneObject): boolean {
  if (piece.type !== 'stroke') return false;
  const ends = [piece.points[0], piece.points[piece.points.length - 1]];
  return ends.every((end) => end !== undefined && distanceTo(whole, toVec(end), 0) !== null);
}

/** The description of objects that are still there but have changed. */
function alteredChange(changed: Changes['changed']): EditDescription {
  const now = changed.map(([, object]) => object);
  const kind = commonKind(now);
  const count = now.length;
  const held = changed.every(([was, object]) => isHeldAlike(was, object)) ? holdOf(changed) : null;
  if (held) return { type: held, kind, count };
  const byMm = commonStep(changed);
  if (byMm) return { type: 'moved', kind, count, byMm, at: middleOfOnly(now) };
  if (changed.every(isTurned)) return { type: 'turned', kind, count, byDeg: commonTurn(changed) };
  const [first] = now;
  if (
    count === 1 &&
    first &&
    'size' in first &&
    changed.every(([was]) => 'size' in was && !isSame(was.size, first.size))
  )
    return { type: 'sized', kind, size: first.size };
  return { type: 'changed', kind, count };
}

/** The common change of objects that differ only in lock and group; `null`: it is not the same for all. */
function holdOf(changed: Changes['changed']): 'locked' | 'unlocked' | 'grouped' | 'ungrouped' | null {
  const all = (is: (was: SceneObject, now: SceneObject) => boolean): boolean =>
    changed.every(([was, now]) => is(was, now));
  if (all((was, now) => was.lock !== now.lock && was.group === now.group))
    return all((_, now) => now.lock === true) ? 'locked' : all((_, now) => now.lock === undefined) ? 'unlocked' : null;
  if (!all((was, now) => was.lock === now.lock)) return null;
  return all((_, now) => now.group !== undefined) ? 'grouped' : all((_, now) => now.group === undefined) ? 'ungrouped' : null; // prettier-ignore
}

/** The step by which all were moved, if they were moved and nothing else. */
function commonStep(changed: Changes['changed']): Point | null {
  const [first] = changed;
  if (!first) return null;
  const [was, now] = [placeOf(first[0]), placeOf(first[1])];
  const [dx, dy] = [now[0] - was[0], now[1] - was[1]];
  return changed.every(([one, other]) => isSame(movedBy(one, dx, dy), other)) ? [dx, dy] : null;
}

/** Rounding to whole mm changes lengths by less than this. */
const ROUNDING_MM = 2;

function isTurned([was, now]: readonly [SceneObject, SceneObject]): boolean {
  if ('angle' in was && 'angle' in now)
    return was.angle !== now.angle && (!('size' in was) || !('size' in now) || isSame(was.size, now.size));
  const [one, other] = [spanOf(was), spanOf(now)];
  return (
    one !== null &&
    other !== null &&
    directionDeg(ORIGIN, one) !== directionDeg(ORIGIN, other) &&
    Math.abs(distanceMm(ORIGIN, one) - distanceMm(ORIGIN, other)) <= ROUNDING_MM &&
    Math.abs(lengthMm(was) - lengthMm(now)) <= ROUNDING_MM + lengthMm(was) / 50
  );
}

const ORIGIN: Vec = { x: 0, y: 0 };

/** From one end of a line to the other. */
const spanOf = (object: SceneObject): Vec | null => kindOf(object).span(object);

/** The angle by which all were turned, in whole degrees, or `null` when it is not the same. */
function commonTurn(changed: Changes['changed']): number | null {
  const angles = changed.map(([was, now]) => {
    if ('angle' in was && 'angle' in now) return Math.round(wrappedDeg(now.angle - was.angle));
    const [one, other] = [spanOf(was), spanOf(now)];
    return one && other ? Math.round(wrappedDeg(directionDeg(ORIGIN, other) - directionDeg(ORIGIN, one))) : 0;
  });
  const [first] = angles;
  // A short line turned in whole mm may miss the angle by a few degrees.
  return first !== undefined && angles.every((angle) => Math.abs(wrappedDeg(angle - first)) <= 3) ? first : null;
}
