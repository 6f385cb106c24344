import type { SceneEdit } from '#scene/edit';
import { boundsMeet, boundsOfOutline, type Outline } from '#scene/outline';
import {
  sceneLimits,
  strokeColors,
  type Mover,
  type Point,
  type Scene,
  type SceneObject,
  type Stroke,
  type StrokeColor,
  type Wall,
  type Zone,
} from '#scene/scene';
import { usualTurningPoint } from './tools/block-tool';
import type { Pasted } from './clipboard';
import { adding, changing, startingAt } from './edits';
import { freeIds } from './ids';
import { oneLine } from './tools/label-tool';
import {
  boxKinds,
  fieldsOf,
  robotFields,
  zoneKinds,
  type Field,
  type FieldName,
  type NumberName,
} from './object-fields';
import { eighths, within, wrappedDeg } from './plane';
import { placeInside } from './robot-place';
import { boundsAround, robotOutlines } from './shape';
import { zoneSizes } from './tools/tool-options';
import type { ToolOptions } from './tools/tool';
import { movedBy } from './transform';
import { nextCheckpoint } from './tools/zone-tool';

/** What a field can be set to. */
export type FieldValue = number | boolean | string;

/**
 * Sets one field of an object, as the list of objects does. Numbers are rounded and kept in their range.
 *
 * @returns `null` when nothing changes, or the value makes no sense there
 */
export function withField(scene: Scene, id: string, name: FieldName, value: FieldValue): SceneEdit | null {
  const object = scene.objects.find((one) => one.id === id);
  const field = object && fieldsOf(object).find((one) => one.name === name);
  const fit = field && fitting(field, value);
  if (!object || fit === undefined || fit === null || field?.value === fit) return null;
  const changed = withValue(object, name, fit, scene);
  return changed && changing([changed, ...swapped(scene, object, changed)]);
}

/** Sets one field of the robot's start; the robot stays inside the arena. `null` when nothing changes. */
export function withRobotField(
  scene: Scene,
  name: FieldName,
  value: number,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const { robot, size } = scene;
  const field = robotFields(robot).find((one) => one.name === name);
  const fit = field && fitting(field, value);
  if (typeof fit !== 'number') return null;
  const at: Point = [name === 'x' ? fit : robot.at[0], name === 'y' ? fit : robot.at[1]];
  const heading = name === 'heading' ? wrappedDeg(fit) : robot.heading;
  const scale = name === 'scale' ? fit : robot.scale;
  const inside = placeInside({ ...robot, at, heading, scale }, size, footprint);
  return startingAt(scene, { at: inside, heading, scale });
}

/** The value as the field takes it, or `null`. */
function fitting(field: Field, value: FieldValue): FieldValue | null {
  switch (field.kind) {
    case 'number': {
      if (typeof value !== 'number' || Number.isNaN(value)) return null;
      const inRange = within(value, field);
      if (field.name === 'turn') return Math.round(inRange / field.step) * field.step;
      return field.unit === 'times' ? Math.round(inRange * 100) / 100 : Math.round(inRange) + 0;
    }
    case 'switch':
      return typeof value === 'boolean' ? value : null;
    case 'choice':
      return field.choices.find((choice) => choice === value) ?? null;
    case 'text':
      return typeof value === 'string' && oneLine(value) !== '' ? oneLine(value) : null;
    default:
      return field satisfies never;
  }
}

function withValue(object: SceneObject, name: FieldName, value: FieldValue, scene: Scene): SceneObject | null {
  if (typeof value === 'number') return withNumber(object, name as NumberName, value);
  if (name === 'round' && 'round' in object) return { ...object, round: value === true };
  if (name === 'spiked' && 'spiked' in object) return { ...object, spiked: value === true };
  if (name === 'color' && object.type === 'stroke') return { ...object, color: colorOf(value) };
  if (name === 'text' && object.type === 'label' && typeof value === 'string') return { ...object, text: value };
  return name === 'type' ? ofKind(object, value, scene) : null;
}

const colorOf = (value: FieldValue): StrokeColor => strokeColors.find((color) => color === value) ?? 'black';

function withNumber(object: SceneObject, name: NumberName, value: number): SceneObject | null {
  if (object.type === 'wall') return wallWithNumber(object, name, value);
  if (object.type === 'stroke') return strokeWithNumber(object, name, value);
  switch (name) {
    case 'x':
      return movedWithin(object, value - object.at[0], 0);
    case 'y':
      return movedWithin(object, 0, value - object.at[1]);
    case 'turn':
      return { ...object, turn: eighths(value / 45) };
    case 'letterHeight':
      return object.type === 'label' ? { ...object, height: value } : null;
    case 'width':
    case 'height':
      return object.type === 'label'
        ? null
        : { ...object, size: withPart(object.size, name === 'width' ? 0 : 1, value) };
    case 'endX':
    case 'endY':
      return object.type === 'mover' ? { ...object, to: withPart(object.to, name === 'endX' ? 0 : 1, value) } : null;
    case 'speed':
      return object.type === 'mover' ? { ...object, speed: value } : null;
    case 'number':
      return object.type === 'checkpoint' ? { ...object, number: value } : null;
    case 'blocks':
      return object.type === 'target' ? { ...object, blocks: value } : null;
    case 'thickness':
    case 'penWidth':
    case 'heading':
    case 'scale':
      return null;
    default:
      return name satisfies never;
  }
}

function wallWithNumber(wall: Wall, name: NumberName, value: number): Wall | null {
  if (name === 'thickness') return { ...wall, thickness: value };
  const from = name === 'x' || name === 'y' ? withPart(wall.from, name === 'x' ? 0 : 1, value) : wall.from;
  const to = name === 'endX' || name === 'endY' ? withPart(wall.to, name === 'endX' ? 0 : 1, value) : wall.to;
  return from[0] === to[0] && from[1] === to[1] ? null : { ...wall, from, to };
}

/** The start of a straight line moves alone, since its end has numbers of its own; a drawn line moves as a whole. */
function strokeWithNumber(stroke: Stroke, name: NumberName, value: number): SceneObject | null {
  const [first, second] = stroke.points;
  if (name === 'penWidth') return { ...stroke, width: value };
  if (!first) return null;
  if (stroke.points.length !== 2 || !second)
    return movedWithin(stroke, name === 'x' ? value - first[0] : 0, name === 'y' ? value - first[1] : 0);
  if (name === 'x' || name === 'y')
    return { ...stroke, points: [withPart(first, name === 'x' ? 0 : 1, value), second] };
  return { ...stroke, points: [first, withPart(second, name === 'endX' ? 0 : 1, value)] };
}

/** Moved as a whole, but not so far that a part of it would be beyond what a course may hold; `null`: not at all. */
function movedWithin(object: SceneObject, dx: number, dy: number): SceneObject | null {
  const { minX, minY, maxX, maxY } = boundsAround(object);
  const { min, max } = sceneLimits.placeMm;
  const step = (by: number, low: number, high: number): number =>
    Math.round(within(by, { min: Math.min(0, Math.ceil(min - low)), max: Math.max(0, Math.floor(max - high)) })) + 0;
  const [x, y] = [step(dx, minX, maxX), step(dy, minY, maxY)];
  return x === 0 && y === 0 ? null : movedBy(object, x, y);
}

const withPart = ([x, y]: Point, part: 0 | 1, value: number): Point => (part === 0 ? [value, y] : [x, value]);

/** The same box or zone as another kind of box or zone. */
function ofKind(object: SceneObject, kind: FieldValue, scene: Scene): SceneObject | null {
  const box = boxKinds.find((one) => one === kind);
  if (box && (object.type === 'block' || object.type === 'fixed-block' || object.type === 'spikes'))
    return { type: box, id: object.id, at: object.at, size: object.size, turn: object.turn };
  const zone = zoneKinds.find((one) => one === kind);
  if (!zone || !('round' in object)) return null;
  const number = zone === 'checkpoint' ? nextCheckpoint(scene) : 0;
  return number === null ? null : { ...object, type: zone, number, blocks: 0 };
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

/** Lengths of lines that are added without a pointer, in mm. Chosen: a cell of a maze and two. */
const NEW_WALL_MM = 200;
const NEW_STROKE_MM = 300;

function newObject(scene: Scene, type: SceneObject['type'], at: Point, options: ToolOptions): SceneObject | null {
  const id = freeIds(scene)(type);
  const [x, y] = at;
  const turn = 0;
  switch (type) {
    case 'wall': {
      const half = NEW_WALL_MM / 2;
      return { type, id, from: [x - half, y], to: [x + half, y], thickness: options.wallThickness };
    }
    case 'stroke': {
      const half = NEW_STROKE_MM / 2;
      return {
        type,
        id,
        points: [
          [x - half, y],
          [x + half, y],
        ],
        width: options.penWidth,
        color: options.penColor,
      };
    }
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return { type, id, at, size: options.blockSize, turn };
    case 'mover':
      return newMover(id, at, scene, options);
    case 'label':
      return { type, id, at, text: oneLine(options.labelText) || 'Text', height: options.labelHeight, turn };
    case 'target':
    case 'checkpoint':
    case 'forbidden': {
      const number = type === 'checkpoint' ? nextCheckpoint(scene) : 0;
      const blocks = type === 'target' ? options.zoneBlocks : 0;
      return number === null
        ? null
        : { type, id, at, size: zoneSizes[type], turn, round: options.zoneRound, number, blocks };
    }
    default:
      return type satisfies never;
  }
}

const newMover = (id: string, at: Point, scene: Scene, options: ToolOptions): Mover => ({
  type: 'mover',
  id,
  at,
  to: usualTurningPoint(at, scene.size),
  size: options.blockSize,
  turn: 0,
  speed: options.moverSpeed,
  spiked: options.moverSpiked,
});

/** Distance of the places that are tried, in mm; the middle itself is the first. */
const TRY_EVERY_MM = 50;

/** An object moved from the middle to the nearest place where it covers nothing else, if there is one. */
function movedToRoom(scene: Scene, object: SceneObject, footprint: readonly Outline[]): SceneObject {
  const taken = [...scene.objects.map(boundsAround), ...robotOutlines(scene.robot, footprint).map(boundsOfOutline)];
  const around = boundsAround(object);
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
