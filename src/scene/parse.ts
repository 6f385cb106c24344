import { findJsonError } from './json-position';
import { placementProblems } from './placement';
import type { SceneProblem } from './problem';
import { join, Reader, type Fields } from './reader';
import {
  centreStart,
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneDefaults,
  sceneLimits,
  strokeColors,
  type Block,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Stroke,
  type Wall,
} from './scene';

/** A scene, or everything that is wrong with the file; `problem` is the first one's message and how many follow. */
export type ParsedScene =
  { readonly scene: Scene } | { readonly problem: string; readonly problems: readonly SceneProblem[] };

/** Reads a course file. Never throws; a file with a problem loads nothing. */
export function parseScene(text: string): ParsedScene {
  const reader = new Reader();
  const { textCharacters } = sceneLimits;
  if (text.length > textCharacters) {
    const what = `The course file has ${text.length} characters; the limit is ${textCharacters}. Is it the right file?`;
    reader.report('too-long', '', undefined, what, { length: text.length, max: textCharacters });
    return failed(reader.problems);
  }
  const json = text.startsWith('\ufeff') ? text.slice(1) : text;
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch {
    const { line, column } = findJsonError(json) ?? { line: 1, column: 1 };
    const near = json.split('\n', line)[line - 1]?.slice(column - 1, column + 19) ?? '';
    const what = `The course file is not JSON: line ${line}, column ${column}${near === '' ? ', where it ends' : `, at ${JSON.stringify(near)}`}.`;
    reader.report('not-json', '', undefined, what, { line, column, near });
    return failed(reader.problems);
  }
  return parseSceneValue(value);
}

/** Reads a course that is already a JavaScript value, for instance out of a message. Never throws. */
export function parseSceneValue(value: unknown): ParsedScene {
  const reader = new Reader();
  if (!isOurs(value, reader)) return failed(reader.problems);
  const scene = readScene(value, reader);
  if (reader.problems.length > 0) return failed(reader.problems);
  const misplaced = placementProblems(scene);
  return misplaced.length > 0 ? failed(misplaced) : { scene };
}

function failed(problems: readonly SceneProblem[]): ParsedScene {
  const more = problems.length - 1;
  const first = problems[0]?.message ?? '';
  return { problem: more > 0 ? `${first} (and ${more} more)` : first, problems };
}

/** Format and version come first: a newer file must not be judged by older rules. */
function isOurs(value: unknown, reader: Reader): value is Fields {
  if (
    typeof value !== 'object' ||
    value === null ||
    Array.isArray(value) ||
    !('format' in value) ||
    value.format !== SCENE_FORMAT
  ) {
    const format = typeof value === 'object' && value !== null && 'format' in value ? value.format : undefined;
    reader.report('not-a-scene', 'format', format, `This is not a course file: "format" must be "${SCENE_FORMAT}".`);
    return false;
  }
  const version = 'version' in value ? value.version : undefined;
  if (version === SCENE_VERSION) return true;
  const params = {
    version: typeof version === 'number' ? version : String(version).slice(0, 20),
    known: SCENE_VERSION,
  };
  if (typeof version === 'number' && version > SCENE_VERSION && Number.isInteger(version)) {
    const what = `Scene version ${version} is newer than this app (${SCENE_VERSION}). Reload the page to update.`;
    reader.report('newer-version', 'version', version, what, params);
  } else {
    const what = `Scene version ${params.version} is unknown; this app reads version ${SCENE_VERSION}.`;
    reader.report('unknown-version', 'version', version, what, params);
  }
  return false;
}

const SCENE_KEYS = ['format', 'version', 'name', 'description', 'size', 'board', 'robot', 'objects'];

function readScene(value: Fields, reader: Reader): Scene {
  const fields = reader.fields(value, '', SCENE_KEYS);
  const size = reader.point(fields.size, 'size', sceneLimits.sizeMm, sceneDefaults.size);
  return {
    name: reader.text(fields.name, 'name', sceneLimits.nameCharacters, ''),
    description: reader.text(fields.description, 'description', sceneLimits.descriptionCharacters, ''),
    size,
    board: readId(fields.board, 'board', reader),
    robot: readRobot(fields.robot, size, reader),
    objects: readObjects(fields.objects, reader),
  };
}

/** The id of a board or robot type; `null` or left out: chosen by the program. */
function readId(value: unknown, path: string, reader: Reader): string | null {
  return value === undefined || value === null ? null : reader.text(value, path, sceneLimits.idCharacters);
}

function readRobot(value: unknown, size: Point, reader: Reader): RobotStart {
  const centre = centreStart(size);
  if (value === undefined) return centre;
  const fields = reader.fields(value, 'robot', ['type', 'at', 'heading', 'scale', 'options']);
  return {
    type: readId(fields.type, 'robot.type', reader),
    at: reader.point(fields.at, 'robot.at', sceneLimits.placeMm, centre.at),
    heading: reader.number(fields.heading, 'robot.heading', sceneLimits.headingDeg, centre.heading),
    scale: reader.number(fields.scale, 'robot.scale', sceneLimits.scale, centre.scale),
    options: readOptions(fields.options, reader),
  };
}

function readOptions(value: unknown, reader: Reader): RobotStart['options'] {
  if (value === undefined) return {};
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    reader.wrongType(value, 'robot.options', 'an object { "option": "choice" }');
    return {};
  }
  const entries = reader.list(Object.entries(value), 'robot.options', { min: 0, max: sceneLimits.options });
  const options = new Map<string, string>();
  for (const [id, choice] of entries as readonly (readonly [string, unknown])[])
    options.set(id, reader.text(choice, `robot.options.${id.slice(0, 40)}`, sceneLimits.idCharacters));
  return Object.fromEntries(options);
}

function readObjects(value: unknown, reader: Reader): SceneObject[] {
  if (value === undefined) return [];
  const entries = reader.list(value, 'objects', { min: 0, max: sceneLimits.objects });
  const places = new Map<string, string>();
  const objects: SceneObject[] = [];
  let pointsLeft: number = sceneLimits.points;
  for (const [index, entry] of entries.entries()) {
    if (reader.isFull) break;
    const path = `objects[${index}]`;
    const object = readObject(entry, path, pointsLeft, reader);
    if (!object) continue;
    if (object.type === 'stroke') pointsLeft -= object.points.length;
    noteId(object.id, path, places, reader);
    objects.push(object);
  }
  return objects;
}

function noteId(id: string, path: string, places: Map<string, string>, reader: Reader): void {
  const other = places.get(id);
  if (other === undefined) places.set(id, path);
  else
    reader.report(
      'duplicate-id',
      `${path}.id`,
      id,
      `"${id}" is already the id of ${other}. Give each object its own.`,
      { other },
    );
}

const objectTypes = ['wall', 'block', 'fixed-block', 'stroke'] as const;

function readObject(value: unknown, path: string, pointsLeft: number, reader: Reader): SceneObject | null {
  const type: unknown = typeof value === 'object' && value !== null && 'type' in value ? value.type : undefined;
  switch (type) {
    case 'wall':
      return readWall(value, path, reader);
    case 'block':
    case 'fixed-block':
      return readBlock(type, value, path, reader);
    case 'stroke':
      return readStroke(value, path, pointsLeft, reader);
    default:
      if (typeof value !== 'object' || value === null) reader.wrongType(value, path, 'an object { … }');
      else if (type === undefined) reader.wrongType(type, `${path}.type`, objectTypes.join(', '));
      else reader.word(type, `${path}.type`, objectTypes, 'wall');
      return null;
  }
}

function readObjectId(fields: Fields, path: string, reader: Reader): string {
  const id = reader.text(fields.id, join(path, 'id'), sceneLimits.idCharacters);
  if (id === '' && fields.id === '') reader.report('missing', join(path, 'id'), id, 'must not be empty.');
  return id;
}

function readWall(value: unknown, path: string, reader: Reader): Wall {
  const fields = reader.fields(value, path, ['id', 'type', 'from', 'to', 'thickness']);
  const before = reader.problems.length;
  const wall: Wall = {
    type: 'wall',
    id: readObjectId(fields, path, reader),
    from: reader.point(fields.from, `${path}.from`, sceneLimits.placeMm),
    to: reader.point(fields.to, `${path}.to`, sceneLimits.placeMm),
    thickness: reader.whole(fields.thickness, `${path}.thickness`, sceneLimits.thicknessMm, sceneDefaults.thickness),
  };
  const isPoint = wall.from[0] === wall.to[0] && wall.from[1] === wall.to[1];
  if (isPoint && reader.problems.length === before) {
    const what = `the wall has length 0: it starts and ends at [${wall.to.join(', ')}]. Move one end or remove the wall.`;
    reader.report('wall-without-length', `${path}.to`, wall.to, what, { x: wall.to[0], y: wall.to[1] });
  }
  return wall;
}

function readBlock(type: Block['type'], value: unknown, path: string, reader: Reader): Block {
  const fields = reader.fields(value, path, ['id', 'type', 'at', 'size', 'turn']);
  return {
    type,
    id: readObjectId(fields, path, reader),
    at: reader.point(fields.at, `${path}.at`, sceneLimits.placeMm),
    size: reader.point(fields.size, `${path}.size`, sceneLimits.blockMm),
    turn: reader.whole(fields.turn, `${path}.turn`, { min: 0, max: 7 }, sceneDefaults.turn),
  };
}

function readStroke(value: unknown, path: string, pointsLeft: number, reader: Reader): Stroke {
  const fields = reader.fields(value, path, ['id', 'type', 'points', 'width', 'color']);
  const points = reader.list(fields.points, `${path}.points`, { min: 1, max: pointsLeft });
  return {
    type: 'stroke',
    id: readObjectId(fields, path, reader),
    points: points.map((point, index) => reader.point(point, `${path}.points[${index}]`, sceneLimits.placeMm)),
    width: reader.whole(fields.width, `${path}.width`, sceneLimits.widthMm, sceneDefaults.width),
    color: reader.word(fields.color, `${path}.color`, strokeColors, sceneDefaults.color),
  };
}
