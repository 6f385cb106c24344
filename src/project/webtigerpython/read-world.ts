/** Reads a world of WebTigerPython as a course: see `world.ts`. */
import { directionOf, type Outline } from '#scene/outline';
import { placementProblems, placeInside } from '#scene/placement';
import { shown } from '#scene/problem';
import {
  centreStart,
  defaultScene,
  sceneLimits,
  type Block,
  type Point,
  type RobotStart,
  type Scene,
  type Wall,
} from '#scene/scene';

import { namesTogether, note, type Note, type NoteCode } from './note';
import {
  BLOCK_MM,
  degOfEighths,
  EIGHTHS,
  headingOfStart,
  looksLikeWorld,
  UNIT_MM,
  USUAL_SIZE,
  WALL_MM,
  worldKeys,
  type WorldKey,
} from './world';

/** A world as a course, and what of it could not be taken over. */
export interface World {
  readonly scene: Scene;
  readonly notes: readonly Note[];
}

/**
 * Reads a world as far as it can be read: an entry that makes no sense is left out and told. Never throws.
 *
 * @returns `null` if no key of a world is there
 */
export function readWorld(value: unknown): World | null {
  if (!looksLikeWorld(value)) return null;
  const notes = new Notes();
  const size = sizeIn(value, notes);
  const robot = startIn(value, size, notes);
  const most = sceneLimits.objects;
  const lists = (['Wallobjects', 'Blockobjects'] as const).map((key) => listIn(value, key, notes));
  const count = lists.reduce((sum, list) => sum + list.count, 0);
  const counts = new Map<string, number>();
  const idOf = (type: string): string => {
    const number = (counts.get(type) ?? 0) + 1;
    counts.set(type, number);
    return `${type}-${String(number)}`;
  };
  const entries = lists.flatMap((list) => list.entries).slice(0, most);
  const objects = entries.flatMap((entry): readonly (Wall | Block)[] => {
    const object = entry.key === 'Wallobjects' ? wallOf(entry, size, notes) : blockOf(entry, size, notes);
    return object === null ? [] : [{ ...object, id: idOf(object.type) }];
  });
  if (count > most) notes.add('tooMany', { count, most });
  const unknown = Object.keys(value).filter((key) => !(worldKeys as readonly string[]).includes(key));
  if (unknown.length > 0) notes.add('keys', { keys: namesTogether(unknown) });
  return { scene: { ...defaultScene(), size, robot, objects }, notes: notes.all() };
}

/** A course whose robot does not lie over the arena's edge, and a note if it did. @param footprint as of `placeInside` */
export function withStartInside(scene: Scene, footprint: readonly Outline[]): World {
  const { robot, size } = scene;
  if (placementProblems({ ...scene, objects: [] }, footprint).length === 0) return { scene, notes: [] };
  const at = placeInside(robot, size, footprint);
  const [[x, y], [toX, toY]] = [robot.at, at];
  return { scene: { ...scene, robot: { ...robot, at } }, notes: [note('startMoved', { x, y, toX, toY })] };
}

/** Gathers notes: of those of one code about one key only the first, with their number as `count`. */
class Notes {
  private readonly found = new Map<string, { readonly first: Note; count: number }>();

  add(code: NoteCode, params: Note['params'] = {}): void {
    const name = `${code} ${String(params['key'] ?? '')}`;
    const known = this.found.get(name);
    if (known === undefined) this.found.set(name, { first: note(code, params), count: 1 });
    else known.count += 1;
  }

  all(): readonly Note[] {
    return Array.from(this.found.values(), ({ first: { code, params }, count }) =>
      note(code, 'place' in params ? { ...params, count } : params),
    );
  }
}

/** An entry of a list in a world. */
interface Entry {
  readonly key: WorldKey;
  /** Such as `Wallobjects[2]`. */
  readonly place: string;
  readonly value: readonly unknown[] | null;
  /** The value as it stands there, shortened. */
  readonly said: () => string;
}

const entryOf = (key: WorldKey, place: string, value: unknown): Entry => ({
  ...{ key, place, value: Array.isArray(value) ? value : null },
  said: () => shown(value),
});

/** The number of entries in a list, and as many of them as a course may hold. */
interface List {
  readonly count: number;
  readonly entries: readonly Entry[];
}

function listIn(world: Readonly<Record<string, unknown>>, key: WorldKey, notes: Notes): List {
  const list = Object.hasOwn(world, key) ? world[key] : [];
  if (Array.isArray(list)) {
    const first: readonly unknown[] = list.slice(0, sceneLimits.objects);
    const entries = first.map((value, index) => entryOf(key, `${key}[${String(index)}]`, value));
    return { count: list.length, entries };
  }
  notes.add('keyUnread', { key, value: shown(list) });
  return { count: 0, entries: [] };
}

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
const isEighth = (value: unknown): value is number =>
  isNumber(value) && Number.isInteger(value) && value >= 0 && value < EIGHTHS;
const inMm = (units: number): number => Math.round(units * UNIT_MM) + 0;

/** Tells of what stands behind the values that are understood. */
function tellMore({ key, place, value }: Entry, known: number, notes: Notes): void {
  if (value !== null && value.length > known) notes.add('moreValues', { key, place, value: shown(value.slice(known)) });
}

function sizeIn(world: Readonly<Record<string, unknown>>, notes: Notes): Point {
  const key = 'playgroundSize';
  const usual: Point = [inMm(USUAL_SIZE[0]), inMm(USUAL_SIZE[1])];
  const [width, height] = usual;
  if (!Object.hasOwn(world, key)) notes.add('sizeMissing', { width, height });
  else {
    const entry = entryOf(key, key, world[key]);
    const [x, y] = entry.value ?? [];
    if (isNumber(x) && isNumber(y) && x > 0 && y > 0) return limited([inMm(x), inMm(y)], entry, notes);
    notes.add('sizeUnread', { value: entry.said(), width, height });
  }
  return usual;
}

function limited([x, y]: Point, entry: Entry, notes: Notes): Point {
  tellMore(entry, 2, notes);
  const { min, max } = sceneLimits.sizeMm;
  const [width, height] = [x, y].map((mm) => Math.min(max, Math.max(min, mm))) as [number, number];
  if (width !== x || height !== y) notes.add('sizeLimited', { value: entry.said(), width, height });
  return [width, height];
}

/** A place in our frame; `null`: it is farther away than a course may hold. */
function placeIn(x: unknown, y: unknown, size: Point): { readonly x: number; readonly y: number } | 'unread' | 'far' {
  if (!isNumber(x) || !isNumber(y)) return 'unread';
  const place = { x: x * UNIT_MM, y: size[1] - y * UNIT_MM };
  return isNear(place) ? place : 'far';
}

function isNear({ x, y }: { readonly x: number; readonly y: number }): boolean {
  const { min, max } = sceneLimits.placeMm;
  return x >= min && x <= max && y >= min && y <= max;
}

function startIn(world: Readonly<Record<string, unknown>>, size: Point, notes: Notes): RobotStart {
  const key = 'StartBox';
  const centre: RobotStart = { ...centreStart(size), heading: headingOfStart(0) };
  if (!Object.hasOwn(world, key)) {
    notes.add('startMissing');
    return centre;
  }
  const entry = entryOf(key, key, world[key]);
  const [x, y, k] = entry.value ?? [];
  const place = placeIn(x, y, size);
  if (typeof place === 'string') {
    notes.add('startUnread', { value: entry.said() });
    return centre;
  }
  tellMore(entry, 3, notes);
  if (!isEighth(k)) notes.add('startAngle', { value: k === undefined ? '–' : shown(k) });
  return { ...centre, at: [inWhole(place.x), inWhole(place.y)], heading: headingOfStart(isEighth(k) ? k : 0) };
}

const inWhole = (mm: number): number => Math.round(mm) + 0;

function wallOf(entry: Entry, size: Point, notes: Notes): Omit<Wall, 'id'> | null {
  const [x, y, length, k] = entry.value ?? [];
  const { key, place } = entry;
  const middle = placeIn(x, y, size);
  if (middle === 'far') return far(entry, notes);
  if (middle === 'unread' || !isNumber(length) || length < 0 || !isEighth(k)) {
    notes.add('wallsUnread', { key, place, value: entry.said() });
    return null;
  }
  tellMore(entry, 4, notes);
  const direction = directionOf(degOfEighths(k));
  const half = (length * UNIT_MM) / 2;
  const ends = [-half, half].map((along) => ({ x: middle.x + along * direction.x, y: middle.y + along * direction.y }));
  if (!ends.every(isNear)) return far(entry, notes);
  const [from, to] = ends.map((end): Point => [inWhole(end.x), inWhole(end.y)]) as [Point, Point];
  if (from[0] === to[0] && from[1] === to[1]) {
    notes.add('wallsWithoutLength', { key, place, value: entry.said() });
    return null;
  }
  return { type: 'wall', from, to, thickness: WALL_MM };
}

function blockOf(entry: Entry, size: Point, notes: Notes): Omit<Block, 'id'> | null {
  const [x, y, isMovable, k] = entry.value ?? [];
  const { key, place } = entry;
  const value = entry.said();
  const middle = placeIn(x, y, size);
  if (middle === 'far') return far(entry, notes);
  if (middle === 'unread') {
    notes.add('blocksUnread', { key, place, value });
    return null;
  }
  tellMore(entry, 4, notes);
  if (typeof isMovable !== 'boolean') notes.add('blocksMovable', { key, place, value });
  if (!isEighth(k)) notes.add('blocksAngle', { key, place, value });
  return {
    type: isMovable === true ? 'block' : 'fixed-block',
    at: [inWhole(middle.x), inWhole(middle.y)],
    size: [BLOCK_MM, BLOCK_MM],
    angle: degOfEighths(isEighth(k) ? k : 0),
  };
}

function far({ key, place, said }: Entry, notes: Notes): null {
  notes.add('far', { key, place, value: said(), most: sceneLimits.placeMm.max });
  return null;
}
