/**
 * Opens the level files of this simulator's predecessor, and of similar ones, as far as their shape is clear. It
 * recognises JSON that is a list of things, or an object whose lists hold only things:
 *
 * - **where**: `x` and `y`, by themselves or in `position`, `pos` or `center`: the middle, in pixels of a canvas (y
 *   down, from its upper left corner). A pixel is taken for a millimetre. `width` and `height` beside the lists, by
 *   themselves or in `canvas`, `world` or `arena`, are the arena; otherwise it is as large as needed, at least the
 *   usual 1200 × 900 mm. If something has a negative place, everything is moved so that it lies 50 mm from the edge.
 * - **circles** (`radius`, `r` or `diameter`): dots of the pen. Consecutive dots of one size that touch make one line.
 * - **rectangles** (`width` and `height`, `w` and `h`, or `size` as two numbers): a wall when `type`, `kind`, `name`,
 *   `label`, `key` or `texture` says so, or when it is thin (at most 50) and four times as long; a block that can be
 *   pushed when it says so or has `movable: true`, `isStatic: false` or `static: false`; otherwise a fixed block.
 *   `angle` is in degrees, `rotation` in radians, both clockwise; blocks turn by eighths.
 * - **the robot**: a thing whose word is robot, maqueen or callibot, in a list or by itself beside the lists.
 *
 * A file with anything else in its lists opens nothing.
 */
import { degOf, radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import { parseSceneValue } from '#scene/parse';
import { shown } from '#scene/problem';
import {
  centreStart,
  defaultScene,
  sceneDefaults,
  sceneLimits,
  type Point,
  type Scene,
  type SceneObject,
} from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { simplified } from '#scene/simplify';

/** A level as a course, or why it is not one: a sentence in English that names the place. */
export type EarlierLevel = { readonly scene: Scene } | { readonly problem: string; readonly place: string };

/** Something in a level, in pixels of its canvas, y down, angle clockwise. */
type Thing =
  | { readonly is: 'dot'; readonly x: number; readonly y: number; readonly radius: number }
  | { readonly is: 'robot'; readonly x: number; readonly y: number; readonly angleDeg: number }
  | Box;

interface Box {
  readonly is: 'wall' | 'block' | 'fixed-block';
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly angleDeg: number;
}

type Fields = Readonly<Record<string, unknown>>;

/** Space around things that lay at negative places, in mm. */
const MARGIN_MM = 50;
const THIN_MM = 50;

/** Words for the robot, in small letters. */
const ROBOT = /robot|maqueen|calli/;

/** True if a JSON value may be such a level and is worth `sceneOfEarlierLevel`, which says what is wrong with it. */
export function looksLikeEarlierLevel(value: unknown): boolean {
  const lists = Array.isArray(value) ? [value] : isFields(value) ? Object.values(value).filter(Array.isArray) : [];
  return lists.some((list: readonly unknown[]) => list.some((entry) => placeOf(entry) !== null));
}

/** Reads such a level. Never throws. */
export function sceneOfEarlierLevel(value: unknown): EarlierLevel {
  const lists = listsOf(value);
  if (lists === null) return { problem: 'This is not a level: there is no list of things in it.', place: '' };
  const things: Thing[] = [];
  for (const { name, list } of lists) {
    for (const [index, entry] of list.entries()) {
      const thing = thingOf(entry, name);
      const place = `${name}[${String(index)}]`;
      if (thing === null) return { problem: `${place}: ${shown(entry)} is not a thing that we know.`, place };
      things.push(thing);
      if (things.length > sceneLimits.points)
        return { problem: `There are more than ${String(sceneLimits.points)} things.`, place };
    }
  }
  if (things.every(({ is }) => is === 'robot'))
    return { problem: 'There is nothing in this level but a robot.', place: '' };
  const scene = sceneOf(things, canvasOf(value));
  const parsed = parseSceneValue(JSON.parse(serializeScene(scene)));
  return 'scene' in parsed ? parsed : { problem: parsed.problem, place: '' };
}

/** The lists of a level with their names. */
function listsOf(value: unknown): readonly { readonly name: string; readonly list: readonly unknown[] }[] | null {
  if (Array.isArray(value)) return [{ name: '', list: value }];
  if (!isFields(value)) return null;
  const lists = Object.entries(value).flatMap(([name, list]) => (Array.isArray(list) ? [{ name, list }] : []));
  if (lists.length === 0) return null;
  const robots = Object.entries(value).filter(([name, it]) => ROBOT.test(name.toLowerCase()) && placeOf(it) !== null);
  return [...lists, ...robots.map(([name, robot]) => ({ name, list: [robot] }))];
}

const isFields = (value: unknown): value is Fields =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const isLength = (value: unknown): value is number =>
  typeof value === 'number' && value > 0 && value <= sceneLimits.placeMm.max;

const isPlace = (value: unknown): value is number =>
  typeof value === 'number' && Math.abs(value) <= sceneLimits.placeMm.max / 2;

/** The first of the names that has a value. */
const first = (fields: Fields, names: readonly string[]): unknown => names.map((name) => fields[name]).find((it) => it !== undefined); // prettier-ignore

/** The middle of an entry. */
function placeOf(entry: unknown): { readonly x: number; readonly y: number } | null {
  if (!isFields(entry)) return null;
  const inside = first(entry, ['position', 'pos', 'center']);
  const { x, y } = isFields(inside) ? inside : entry;
  return isPlace(x) && isPlace(y) ? { x, y } : null;
}

function thingOf(entry: unknown, list: string): Thing | null {
  const place = placeOf(entry);
  if (place === null || !isFields(entry)) return null;
  const words = [list, ...['type', 'kind', 'name', 'label', 'key', 'texture'].map((name) => entry[name])]
    .filter((word) => typeof word === 'string')
    .join(' ')
    .toLowerCase();
  const angleDeg = angleOf(entry);
  if (angleDeg === null) return null;
  if (ROBOT.test(words)) return { is: 'robot', ...place, angleDeg };
  const radius = radiusOf(entry);
  if (radius !== null) return { is: 'dot', ...place, radius };
  const size = extentOf(entry);
  return size === null ? null : { is: boxKind(entry, words, size), ...place, ...size, angleDeg };
}

/** Degrees clockwise: `angle` gives them, `rotation` is in radians. */
function angleOf(entry: Fields): number | null {
  const { angle, rotation } = entry;
  if (angle === undefined && rotation === undefined) return 0;
  const degrees = typeof angle === 'number' ? angle : typeof rotation === 'number' ? degOf(rotation) : NaN;
  return Number.isFinite(degrees) && Math.abs(degrees) < 1e6 ? degrees : null;
}

function radiusOf(entry: Fields): number | null {
  const { diameter } = entry;
  const radius = first(entry, ['radius', 'r']) ?? (isLength(diameter) ? diameter / 2 : undefined);
  return isLength(radius) ? radius : null;
}

function extentOf(entry: Fields): { readonly width: number; readonly height: number } | null {
  const { size } = entry;
  const [one, other]: readonly unknown[] = Array.isArray(size)
    ? (size as readonly unknown[])
    : isFields(size)
      ? [first(size, ['width', 'w', 'x']), first(size, ['height', 'h', 'y'])]
      : [first(entry, ['width', 'w']), first(entry, ['height', 'h'])];
  return isLength(one) && isLength(other) ? { width: one, height: other } : null;
}

function boxKind(entry: Fields, words: string, size: { width: number; height: number }): Box['is'] {
  const [thin, long] = [Math.min(size.width, size.height), Math.max(size.width, size.height)];
  const stands = first(entry, ['isStatic', 'static']);
  if (/wall|wand|mauer|brick/.test(words)) return 'wall';
  if (/\b(immovable|fixed|static|fest)/.test(words)) return 'fixed-block';
  if (entry['movable'] === true || stands === false || /mov|push|beweg|schieb/.test(words)) return 'block';
  return thin <= THIN_MM && long >= 4 * thin ? 'wall' : 'fixed-block';
}

/** The level's canvas, in px. */
function canvasOf(value: unknown): Point | null {
  if (!isFields(value)) return null;
  const inside = first(value, ['canvas', 'world', 'arena']);
  const { width, height } = isFields(inside) ? inside : value;
  const { min, max } = sceneLimits.sizeMm;
  const fits = (size: unknown): size is number => typeof size === 'number' && size >= min && size <= max;
  return fits(width) && fits(height) ? [Math.round(width), Math.round(height)] : null;
}

/** The things in our frame: millimetres, y up. */
function sceneOf(things: readonly Thing[], canvas: Point | null): Scene {
  const [left, top] = [leastOf(things, 'x'), leastOf(things, 'y')];
  const [moveX, moveY] = [left < 0 ? MARGIN_MM - left : 0, top < 0 ? MARGIN_MM - top : 0];
  const moved = things.map((thing): Thing => ({ ...thing, x: thing.x + moveX, y: thing.y + moveY }));
  const size = canvas ?? sizeFor(moved);
  const robot = moved.find((thing) => thing.is === 'robot');
  const start = centreStart(size);
  return {
    ...defaultScene(),
    size,
    robot: robot === undefined ? start : { ...start, at: placeIn(size, robot), heading: headingOf(robot.angleDeg) },
    objects: objectsOf(moved, size),
  };
}

const leastOf = (things: readonly Thing[], axis: 'x' | 'y'): number =>
  things.reduce((least, thing) => Math.min(least, thing[axis] - reachOf(thing)), Infinity);

/** Maximum distance of a thing's parts from its middle. */
function reachOf(thing: Thing): number {
  if (thing.is === 'robot') return 0;
  return thing.is === 'dot' ? thing.radius : Math.max(thing.width, thing.height) / 2;
}

/** Large enough for everything, in whole decimetres. */
function sizeFor(things: readonly Thing[]): Point {
  const extent = (axis: 'x' | 'y', least: number): number => {
    const most = things.reduce((sum, thing) => Math.max(sum, thing[axis] + reachOf(thing)), least);
    return Math.min(sceneLimits.sizeMm.max, Math.ceil(most / 100) * 100);
  };
  return [extent('x', sceneDefaults.size[0]), extent('y', sceneDefaults.size[1])];
}

const placeIn = (size: Point, { x, y }: { x: number; y: number }): Point => [Math.round(x), Math.round(size[1] - y)];

/** Degrees counter-clockwise, 0 … 359, of degrees clockwise. */
const headingOf = (angleDeg: number): number => ((Math.round(-angleDeg) % 360) + 360) % 360;

function objectsOf(things: readonly Thing[], size: Point): readonly SceneObject[] {
  const objects: SceneObject[] = [];
  const counts = new Map<string, number>();
  const idOf = (type: string): string => {
    const number = (counts.get(type) ?? 0) + 1;
    counts.set(type, number);
    return `${type}-${String(number)}`;
  };
  for (const line of linesOf(things)) {
    const points = simplified(line.map(({ x, y }) => ({ x, y: size[1] - y })));
    const width = clamped(2 * (line[0]?.radius ?? 0), sceneLimits.widthMm);
    objects.push({ type: 'stroke', id: idOf('stroke'), points, width, color: sceneDefaults.color });
  }
  for (const thing of things)
    if (thing.is !== 'dot' && thing.is !== 'robot') objects.push(boxObject(thing, idOf(thing.is), size));
  return objects;
}

type Dot = Extract<Thing, { readonly is: 'dot' }>;

/** Dots of one size, each of which touches the previous one. */
function linesOf(things: readonly Thing[]): readonly (readonly Dot[])[] {
  const lines: Dot[][] = [];
  for (const dot of things) {
    if (dot.is !== 'dot') continue;
    const line = lines.at(-1);
    const last = line?.at(-1);
    if (line !== undefined && last !== undefined && isTouching(last, dot)) line.push(dot);
    else lines.push([dot]);
  }
  return lines;
}

function isTouching(one: Dot, other: Dot): boolean {
  const [dx, dy] = [one.x - other.x, one.y - other.y];
  return one.radius === other.radius && dx * dx + dy * dy <= 4 * one.radius * one.radius;
}

function boxObject({ is, x, y, width, height, angleDeg }: Box, id: string, size: Point): SceneObject {
  const at = placeIn(size, { x, y });
  if (is !== 'wall') {
    const { blockMm } = sceneLimits;
    const angle = (Math.round(headingOf(angleDeg) / 45) % 8) * 45;
    return { type: is, id, at, size: [clamped(width, blockMm), clamped(height, blockMm)], angle };
  }
  const along = radOf(angleDeg + (width >= height ? 0 : 90));
  const half = Math.max(width, height) / 2;
  const [dx, dy] = [half * exactCos(along), half * exactSin(along)];
  const from = placeIn(size, { x: x - dx, y: y - dy });
  const to = placeIn(size, { x: x + dx, y: y + dy });
  return { type: 'wall', id, from, to, thickness: clamped(Math.min(width, height), sceneLimits.thicknessMm) };
}

const clamped = (value: number, { min, max }: { readonly min: number; readonly max: number }): number =>
  Math.min(max, Math.max(min, Math.round(value)));
