import { courseParts, type Replacement, type SceneEdit } from './edit';
import type { SceneProblem } from './problem';
import { readCourseChanges, readRobotChanges } from './read-course';
import { readObjectId } from './kinds/reading/unread';
import { readObject } from './read-object';
import { Reader } from './reader';
import { countPoints, sceneLimits, type Scene, type SceneObject } from './scene';

/** An edit, or everything that is wrong with it; `problem` is the first one's message. */
export type ParsedEdit =
  { readonly edit: SceneEdit } | { readonly problem: string; readonly problems: readonly SceneProblem[] };

/**
 * Reads an edit that comes from outside, for instance out of a message or a file of inputs. Never throws. What comes out
 * holds nothing but what an edit may hold, each figure within its limits; `editProblem` says whether it suits a course.
 */
export function parseEdit(value: unknown): ParsedEdit {
  const reader = new Reader();
  const edit = readEdit(value, '', wholeRoom(), 0, reader);
  const [first] = reader.problems;
  return first ? { problem: first.message, problems: reader.problems } : { edit };
}

/** The first problem of doing an edit: too much of something, a value out of range, a wrong id. `null`: none. */
export function editProblem(scene: Scene, edit: SceneEdit): SceneProblem | null {
  const reader = new Reader();
  readEdit(edit, '', wholeRoom(), 0, reader);
  if (reader.problems.length === 0) new Stock(scene, reader).take(edit, '');
  return reader.problems[0] ?? null;
}

/** Maximum number of edits within one. Chosen: one for every object. */
const MAX_EDITS = sceneLimits.objects;
/** How deep edits may lie within edits. Chosen: deeper than the app ever makes them. */
const MAX_DEPTH = 4;

/** The remaining budget of an edit. */
interface Room {
  edits: number;
  objects: number;
  ids: number;
  points: number;
}

const wholeRoom = (): Room => ({
  edits: MAX_EDITS,
  objects: 2 * sceneLimits.objects, // an object may be added and then changed
  ids: 2 * sceneLimits.objects,
  points: sceneLimits.points,
});

const NOTHING: SceneEdit = { type: 'all', edits: [] };
const editTypes: readonly SceneEdit['type'][] = ['add', 'remove', 'replace', 'robot', 'course', 'clear', 'all'];

function readEdit(value: unknown, path: string, room: Room, depth: number, reader: Reader): SceneEdit {
  const place = path === '' ? '' : `${path}.`;
  const isObject = typeof value === 'object' && value !== null && !Array.isArray(value);
  const type = isObject && 'type' in value ? editTypes.find((known) => known === value.type) : undefined;
  const known = type === undefined ? [] : ['type', ...partsOf[type]];
  if (type === undefined) {
    if (!isObject) reader.wrongType(value, path, 'an object { … }');
    else if (!('type' in value)) reader.wrongType(undefined, `${place}type`, editTypes.join(', '));
    else reader.word(value.type, `${place}type`, editTypes, 'clear');
    return NOTHING;
  }
  const fields = reader.fields(value, path, known);
  switch (type) {
    case 'add': {
      const objects = readObjects(fields.objects, `${place}objects`, room, reader);
      return fields.at === undefined
        ? { type, objects }
        : { type, objects, at: readPlaces(fields.at, `${place}at`, objects.length, reader) };
    }
    case 'remove':
      return { type, ids: readIds(fields.ids, `${place}ids`, room, reader) };
    case 'replace':
      return { type, changes: readReplacements(fields.changes, `${place}changes`, room, reader) };
    case 'robot':
      return { type, robot: readRobotChanges(fields.robot, `${place}robot`, reader) };
    case 'course': {
      const changes = reader.fields(fields.changes, `${place}changes`, courseParts);
      return { type, changes: readCourseChanges(changes, `${place}changes.`, reader) };
    }
    case 'clear':
      return { type };
    case 'all':
      return { type, edits: readEdits(fields.edits, `${place}edits`, room, depth, reader) };
    default:
      return type satisfies never;
  }
}

/** The fields of each edit besides its type. */
const partsOf: Readonly<Record<SceneEdit['type'], readonly string[]>> = {
  add: ['objects', 'at'],
  remove: ['ids'],
  replace: ['changes'],
  robot: ['robot'],
  course: ['changes'],
  clear: [],
  all: ['edits'],
};

function readEdits(value: unknown, path: string, room: Room, depth: number, reader: Reader): readonly SceneEdit[] {
  if (depth >= MAX_DEPTH) {
    reader.report('too-many', path, undefined, `edits within edits, more than ${MAX_DEPTH} deep.`, { max: MAX_DEPTH });
    return [];
  }
  const entries = reader.list(value, path, { min: 0, max: room.edits });
  room.edits -= entries.length;
  return whileRoom(entries, reader, (entry, index) => readEdit(entry, `${path}[${index}]`, room, depth + 1, reader));
}

function readObjects(value: unknown, path: string, room: Room, reader: Reader): readonly SceneObject[] {
  const entries = reader.list(value, path, { min: 0, max: room.objects });
  room.objects -= entries.length;
  const objects = whileRoom(entries, reader, (entry, index) => {
    const object = readObject(entry, `${path}[${index}]`, room.points, reader);
    if (object) room.points -= countPoints(object);
    return object;
  });
  return objects.filter((object) => object !== null);
}

/** Places in the order of painting, one for each of so many objects. */
function readPlaces(value: unknown, path: string, count: number, reader: Reader): readonly number[] {
  const places = { min: 0, max: sceneLimits.objects - 1 };
  const entries = reader.list(value, path, { min: count, max: count });
  return whileRoom(entries, reader, (entry, index) => reader.whole(entry, `${path}[${index}]`, places));
}

function readIds(value: unknown, path: string, room: Room, reader: Reader): readonly string[] {
  const entries = reader.list(value, path, { min: 0, max: room.ids });
  room.ids -= entries.length;
  return whileRoom(entries, reader, (entry, index) => readObjectId(entry, `${path}[${index}]`, reader));
}

function readReplacements(value: unknown, path: string, room: Room, reader: Reader): readonly Replacement[] {
  const entries = reader.list(value, path, { min: 0, max: room.ids });
  room.ids -= entries.length;
  return whileRoom(entries, reader, (entry, index) => {
    const place = `${path}[${index}]`;
    const fields = reader.fields(entry, place, ['id', 'by']);
    return {
      id: readObjectId(fields.id, `${place}.id`, reader),
      by: readObjects(fields.by, `${place}.by`, room, reader),
    };
  });
}

/** Reads the entries in order, until no further problem would be listed: hostile data must not cost more. */
function whileRoom<T>(
  entries: readonly unknown[],
  reader: Reader,
  read: (entry: unknown, index: number) => T,
): readonly T[] {
  const all: T[] = [];
  for (const [index, entry] of entries.entries()) {
    if (reader.isFull) break;
    all.push(read(entry, index));
  }
  return all;
}

/** The ids of a course and the points of their objects, while an edit is done to it step by step. */
class Stock {
  private readonly pointsOf: Map<string, number>;
  private points = 0;

  constructor(
    scene: Scene,
    private readonly reader: Reader,
  ) {
    this.pointsOf = new Map(scene.objects.map((object) => [object.id, countPoints(object)]));
    for (const points of this.pointsOf.values()) this.points += points;
  }

  /** Follows what an edit removes and adds; problems are noted in the reader. */
  take(edit: SceneEdit, path: string): void {
    const place = path === '' ? '' : `${path}.`;
    switch (edit.type) {
      case 'add':
        this.add(edit.objects, `${place}objects`);
        break;
      case 'remove':
        for (const [index, id] of edit.ids.entries()) this.remove(id, `${place}ids[${index}]`);
        break;
      case 'replace':
        for (const [index, { id }] of edit.changes.entries()) this.remove(id, `${place}changes[${index}].id`);
        for (const [index, { by }] of edit.changes.entries()) this.add(by, `${place}changes[${index}].by`);
        break;
      case 'clear':
        this.pointsOf.clear();
        this.points = 0;
        break;
      case 'all':
        for (const [index, inner] of edit.edits.entries()) this.take(inner, `${place}edits[${index}]`);
        break;
      case 'robot':
      case 'course':
        break;
      default:
        edit satisfies never;
    }
  }

  private remove(id: string, path: string): void {
    const points = this.pointsOf.get(id);
    if (points === undefined) this.reader.report('unknown-id', path, id, `there is no object "${id}".`, { id });
    this.pointsOf.delete(id);
    this.points -= points ?? 0;
  }

  private add(objects: readonly SceneObject[], path: string): void {
    for (const [index, object] of objects.entries()) {
      const place = `${path}[${index}]`;
      if (this.pointsOf.has(object.id)) {
        const what = `"${object.id}" is already the id of another object. Give each object its own.`;
        this.reader.report('duplicate-id', `${place}.id`, object.id, what, { other: object.id });
      }
      this.pointsOf.set(object.id, countPoints(object));
      this.points += countPoints(object);
      this.checkLimit('objects', this.pointsOf.size, sceneLimits.objects, place);
      this.checkLimit('points', this.points, sceneLimits.points, place);
    }
  }

  private checkLimit(what: string, count: number, max: number, path: string): void {
    if (count <= max || this.reader.isFull) return;
    const message = `with it there would be ${count} ${what}; there may be ${max}.`;
    this.reader.report('too-many', path, undefined, message, { count, min: 0, max });
  }
}
