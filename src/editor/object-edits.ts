import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, type Outline } from '#scene/outline';
import { placeInside, robotOutlines } from '#scene/placement';
import type { Point, Scene, SceneObject, Zone } from '#scene/scene';
import type { Pasted } from './clipboard';
import { adding, changing, startingAt } from './edits';
import { fieldsOf, movedBy, newObject } from './kinds/index';
import { oneLine } from './kinds/label';
import { robotFields, type Field, type FieldName, type FieldValue } from './object-fields';
import { rotationDeg, within } from './plane';
import type { ToolOptions } from './tools/tool';

/**
 * Sets one field of an object, as the list of objects does. Numbers are rounded and kept in their range.
 *
 * @returns `null` when nothing changes, it is locked, or the value makes no sense there
 */
export function withField(scene: Scene, id: string, name: FieldName, value: FieldValue): SceneEdit | null {
  const object = scene.objects.find((one) => one.id === id);
  const field = object && fieldsOf(object).find((one) => one.name === name);
  const fit = field ? fitting(field, value) : null;
  if (!object || object.lock || !field || fit === null || field.value === fit) return null;
  const changed = field.with(fit, scene);
  if (!changed || isSame(changed, object)) return null; // −180° is 180°
  const all = [changed, ...swapped(scene, object, changed)];
  return all.some(({ lock }) => lock) ? null : changing(all);
}

/** Sets one field of the robot's start; the robot stays inside the arena. `null` when nothing changes. */
export function withRobotField(
  scene: Scene,
  name: FieldName,
  value: FieldValue,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const { robot, size } = scene;
  const field = robotFields(scene).find((one) => one.name === name);
  const fit = field ? fitting(field, value) : null;
  if (!field || fit === null) return null;
  const changes = field.with(fit, scene) ?? {};
  return startingAt(scene, { ...changes, at: placeInside({ ...robot, ...changes }, size, footprint) });
}

/** The decimals of units that have any: parts of one. */
const PARTS: Readonly<Record<string, number>> = { s: 10, cd: 10, times: 100, ratio: 100 };

/** The value as the field takes it, or `null`. */
export function fitting(field: Field, value: FieldValue): FieldValue | null {
  switch (field.kind) {
    case 'number': {
      if (typeof value !== 'number' || Number.isNaN(value)) return null;
      const inRange = within(value, field);
      if (field.name === 'turn') return rotationDeg(inRange);
      const parts = PARTS[field.unit] ?? 1;
      return Math.round(inRange * parts) / parts + 0;
    }
    case 'switch':
      return typeof value === 'boolean' ? value : null;
    case 'choice':
      return field.choices.find((choice) => choice === value) ?? null;
    case 'text':
      // A label needs words; a robot without a name is called as its device.
      return typeof value === 'string' && (oneLine(value) !== '' || field.name === 'name') ? oneLine(value) : null;
    default:
      return field satisfies never;
  }
}

/** A checkpoint that takes the number of another gives it its own in return. */
function swapped(scene: Scene, before: SceneObject, after: SceneObject): readonly SceneObject[] {
  if (before.type !== 'checkpoint' || after.type !== 'checkpoint' || before.number === after.number) return [];
  const other = scene.objects.find(
    (object): object is Zone =>
      object.type === 'checkpoint' && object.id !== after.id && object.number === after.number,
  );
  return other ? [{ ...other, number: before.number }] : [];
}

/**
 * Puts a new object of a kind into the arena without a pointer: in the middle, or where there is room nearest to it. Its
 * size and looks are those of the tools.
 *
 * @returns `null` when the course is full
 */
export function added(
  scene: Scene,
  kind: SceneObject['type'],
  options: ToolOptions,
  footprint: readonly Outline[] = [],
): Pasted | null {
  const middle: Point = [Math.round(scene.size[0] / 2), Math.round(scene.size[1] / 2)];
  const object = newObject(scene, kind, middle, options);
  const placed = object && movedToRoom(scene, object, footprint);
  const edit = placed && adding(scene, [placed]);
  return edit && { edit, selection: { ids: [placed.id], robot: false } };
}

/** Distance of the places that are tried, in mm; the middle itself is the first. */
const TRY_EVERY_MM = 50;

/** An object moved from the middle to the nearest place where it covers nothing else, if there is one. */
function movedToRoom(scene: Scene, object: SceneObject, footprint: readonly Outline[]): SceneObject {
  const taken = [...scene.objects.map(boundsOf), ...robotOutlines(scene.robot, footprint).map(boundsOfOutline)];
  const around = boundsOf(object);
  const [width, height] = scene.size;
  for (const [dx, dy] of placesAround(Math.max(width, height) / 2)) {
    const there = { minX: around.minX + dx, minY: around.minY + dy, maxX: around.maxX + dx, maxY: around.maxY + dy };
    const isInside = there.minX >= 0 && there.minY >= 0 && there.maxX <= width && there.maxY <= height;
    if (isInside && !taken.some((other) => boundsMeet(other, there))) return movedBy(object, dx, dy);
  }
  return object;
}

/** Most rings that are tried around the middle: 40 of them are 2 m. */
const MOST_RINGS = 40;

/** Steps away from the middle, ring by ring. */
function* placesAround(farthestMm: number): Generator<Point> {
  yield [0, 0];
  const rings = Math.min(MOST_RINGS, Math.floor(farthestMm / TRY_EVERY_MM));
  for (let ring = 1; ring <= rings; ring += 1)
    for (let column = -ring; column <= ring; column += 1)
      for (let row = -ring; row <= ring; row += Math.abs(column) === ring ? 1 : 2 * ring)
        yield [column * TRY_EVERY_MM, row * TRY_EVERY_MM];
}
