import { join, type Fields, type Range, type Reader } from './reader';
import {
  sceneDefaults,
  sceneLimits,
  strokeColors,
  type Block,
  type Label,
  type Mover,
  type Point,
  type SceneObject,
  type Spikes,
  type Stroke,
  type Wall,
  type Zone,
} from './scene';

const objectTypes: readonly SceneObject['type'][] = [
  'wall',
  'block',
  'fixed-block',
  'stroke',
  'target',
  'checkpoint',
  'forbidden',
  'spikes',
  'mover',
  'label',
];

/**
 * Reads an unchecked object of a course; what is wrong with it is noted in the reader.
 *
 * @param pointsLeft how many points a stroke may have at most
 * @returns `null` when not even its type can be told
 */
export function readObject(value: unknown, path: string, pointsLeft: number, reader: Reader): SceneObject | null {
  const type: unknown = typeof value === 'object' && value !== null && 'type' in value ? value.type : undefined;
  switch (type) {
    case 'wall':
      return readWall(value, path, reader);
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return readBlock(type, value, path, reader);
    case 'stroke':
      return readStroke(value, path, pointsLeft, reader);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return readZone(type, value, path, reader);
    case 'mover':
      return readMover(value, path, reader);
    case 'label':
      return readLabel(value, path, reader);
    default:
      if (typeof value !== 'object' || value === null) reader.wrongType(value, path, 'an object { … }');
      else if (type === undefined) reader.wrongType(type, `${path}.type`, objectTypes.join(', '));
      else reader.word(type, `${path}.type`, objectTypes, 'wall');
      return null;
  }
}

/** The id of an object: neither empty nor a word with a meaning of its own in JavaScript. */
export function readObjectId(value: unknown, path: string, reader: Reader): string {
  const id = reader.text(value, path, sceneLimits.idCharacters);
  if (value === '') reader.report('missing', path, id, 'must not be empty.');
  if (id === '__proto__') reader.report('unknown-value', path, id, '"__proto__" cannot be an id.');
  return id;
}

function objectFields(value: unknown, path: string, known: readonly string[], reader: Reader): Fields {
  return reader.fields(value, path, ['id', 'type', ...known]);
}

const idOf = (fields: Fields, path: string, reader: Reader): string =>
  readObjectId(fields.id, join(path, 'id'), reader);

function readWall(value: unknown, path: string, reader: Reader): Wall {
  const fields = objectFields(value, path, ['from', 'to', 'thickness'], reader);
  const before = reader.problems.length;
  const wall: Wall = {
    type: 'wall',
    id: idOf(fields, path, reader),
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

/** What every box has: where, how large and how turned. */
function readBox(fields: Fields, path: string, reader: Reader): { id: string; at: Point; size: Point; turn: number } {
  return {
    id: idOf(fields, path, reader),
    at: reader.point(fields.at, `${path}.at`, sceneLimits.placeMm),
    size: reader.point(fields.size, `${path}.size`, sceneLimits.blockMm),
    turn: readTurn(fields, path, reader),
  };
}

const readTurn = (fields: Fields, path: string, reader: Reader): number =>
  reader.whole(fields.turn, `${path}.turn`, { min: 0, max: 7 }, sceneDefaults.turn);

function readBlock(type: (Block | Spikes)['type'], value: unknown, path: string, reader: Reader): Block | Spikes {
  const fields = objectFields(value, path, ['at', 'size', 'turn'], reader);
  return { type, ...readBox(fields, path, reader) };
}

function readStroke(value: unknown, path: string, pointsLeft: number, reader: Reader): Stroke {
  const fields = objectFields(value, path, ['points', 'width', 'color'], reader);
  const points = reader.list(fields.points, `${path}.points`, { min: 1, max: pointsLeft });
  return {
    type: 'stroke',
    id: idOf(fields, path, reader),
    points: points.map((point, index) => reader.point(point, `${path}.points[${index}]`, sceneLimits.placeMm)),
    width: reader.whole(fields.width, `${path}.width`, sceneLimits.widthMm, sceneDefaults.width),
    color: reader.word(fields.color, `${path}.color`, strokeColors, sceneDefaults.color),
  };
}

const NONE: Range = { min: 0, max: 0 };

function readZone(type: Zone['type'], value: unknown, path: string, reader: Reader): Zone {
  const fields = objectFields(value, path, ['at', 'size', 'turn', 'round', 'number', 'blocks'], reader);
  const isNumbered = type === 'checkpoint';
  const numbers = isNumbered ? sceneLimits.checkpoint : NONE;
  const blocks = type === 'target' ? sceneLimits.blocks : NONE;
  return {
    type,
    ...readBox(fields, path, reader),
    round: reader.flag(fields.round, `${path}.round`, sceneDefaults.round),
    number: reader.whole(fields.number, `${path}.number`, numbers, isNumbered ? undefined : 0),
    blocks: reader.whole(fields.blocks, `${path}.blocks`, blocks, sceneDefaults.blocks),
  };
}

function readMover(value: unknown, path: string, reader: Reader): Mover {
  const fields = objectFields(value, path, ['at', 'to', 'size', 'turn', 'speed', 'spiked'], reader);
  return {
    type: 'mover',
    ...readBox(fields, path, reader),
    to: reader.point(fields.to, `${path}.to`, sceneLimits.placeMm),
    speed: reader.whole(fields.speed, `${path}.speed`, sceneLimits.speedMmS, sceneDefaults.speed),
    spiked: reader.flag(fields.spiked, `${path}.spiked`, sceneDefaults.spiked),
  };
}

function readLabel(value: unknown, path: string, reader: Reader): Label {
  const fields = objectFields(value, path, ['at', 'text', 'height', 'turn'], reader);
  const text = reader.text(fields.text, `${path}.text`, sceneLimits.labelCharacters);
  if (fields.text === '') reader.report('missing', `${path}.text`, text, 'must not be empty.');
  if (LINE_BREAK.test(text)) reader.report('not-one-line', `${path}.text`, text, 'must be a single line.');
  return {
    type: 'label',
    id: idOf(fields, path, reader),
    at: reader.point(fields.at, `${path}.at`, sceneLimits.placeMm),
    text,
    height: reader.whole(fields.height, `${path}.height`, sceneLimits.labelMm, sceneDefaults.labelHeight),
    turn: readTurn(fields, path, reader),
  };
}

const LINE_BREAK = /[\n\r\u2028\u2029]/;
