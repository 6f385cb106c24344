import { join, type Fields, type Reader } from '../../reader';
import { fullTurnDeg } from '#core/angle';
import { areaOf } from '../../shape/polygon';
import { polygonFault, type PolygonFault } from '../../shape/polygon-fault';
import { sceneDefaults, sceneLimits, type Point, type SceneObject, type Shaped } from '../../scene';
import { paintColors, type Painted } from '../../paint/paint';
import type { StandingObject } from '../heights';

/** An object of a course that is yet to be read, and the reader that notes what is wrong with it. */
export interface Unread {
  readonly reader: Reader;
  /** How many points it may have at most. */
  readonly pointsLeft: number;
  /** The value of a property and its place in the file, as the functions of the reader take them. */
  readonly at: (name: string) => readonly [value: unknown, path: string];
}

/** The properties of an object as something to be read. */
export const unread = (fields: Fields, path: string, pointsLeft: number, reader: Reader): Unread => ({
  reader,
  pointsLeft,
  at: (name) => [fields[name], join(path, name)],
});

/** The id of an object: neither empty nor a word with a meaning of its own in JavaScript. */
export function readObjectId(value: unknown, path: string, reader: Reader): string {
  const id = reader.text(value, path, sceneLimits.idCharacters);
  if (value === '') reader.report('missing', path, id, 'must not be empty.');
  if (id === '__proto__') reader.report('unknown-value', path, id, '"__proto__" cannot be an id.');
  return id;
}

/** An object's own id. */
export const readId = ({ reader, at }: Unread): string => readObjectId(...at('id'), reader);

/** A place within what a course may hold. */
export const readPlace = ({ reader, at }: Unread, name: string): Point =>
  reader.point(...at(name), sceneLimits.placeMm);

/** A rotation in degrees. Older files and recordings have `turn` instead, in eighths of a full turn. */
export function readAngle({ reader, at }: Unread): number {
  const [turn, turnPath] = at('turn');
  const [angle, path] = at('angle');
  if (turn === undefined) return fullTurnDeg(reader.number(angle, path, sceneLimits.angleDeg, sceneDefaults.angle));
  if (angle !== undefined)
    reader.report('said-twice', path, angle, '"angle" and "turn" say the same. Leave out one of them.', {
      other: 'turn',
    });
  return 45 * reader.whole(turn, turnPath, { min: 0, max: 7 });
}

/** The properties that every object may have in a file. */
export const commonProperties = ['id', 'type', 'lock', 'group'] as const;

/** Reads the lock and the group of an object; what is left out stays left out. */
export function readCommon({ reader, at }: Unread): Pick<SceneObject, 'lock' | 'group'> {
  const [group, path] = at('group');
  return {
    ...(reader.flag(...at('lock'), false) ? { lock: true } : {}),
    ...(group === undefined ? {} : { group: readObjectId(group, path, reader) }),
  };
}

/** Common properties of all shapes: place, size, rotation and, where they may be, corners. */
export const readShape = (given: Unread): Omit<Shaped, 'round'> & { readonly id: string } => {
  const size = given.reader.point(...given.at('size'), sceneLimits.blockMm);
  return { id: readId(given), at: readPlace(given, 'at'), size, angle: readAngle(given), ...readCorners(given, size) };
};

/** The height of what stands on the floor; what is left out stays left out. */
export function readHeight({ reader, at }: Unread): Pick<StandingObject, 'height'> {
  const [height, path] = at('height');
  return height === undefined ? {} : { height: reader.whole(height, path, sceneLimits.heightMm) };
}

/** Colour and infrared of what may be painted; what is left out stays left out. */
export function readPaint({ reader, at }: Unread): Painted {
  const [color, colorPath] = at('color');
  const [infrared, path] = at('infrared');
  return {
    ...(color === undefined ? {} : { color: reader.word(color, colorPath, paintColors, 'black') }),
    ...(infrared === undefined ? {} : { infrared: reader.number(infrared, path, sceneLimits.infrared) }),
  };
}

/** Reads a shape with `round`, which is left out unless it is true. */
export function readBody(given: Unread): Omit<Shaped, 'round'> & { readonly id: string; readonly round?: true } {
  const isRound = given.reader.flag(...given.at('round'), sceneDefaults.round);
  return { ...readShape(given), ...(isRound ? { round: true } : {}) };
}

function readCorners({ reader, at, pointsLeft }: Unread, size: Point): Pick<Shaped, 'corners'> {
  const [value, path] = at('corners');
  if (value === undefined) return {};
  const { corners: count, placeMm, leastAreaMm2 } = sceneLimits;
  const before = reader.problems.length;
  const list = reader.list(value, path, { min: count.min, max: Math.min(count.max, pointsLeft) });
  const corners = list.map((corner, index) => reader.point(corner, `${path}[${index}]`, placeMm));
  const [round, roundPath] = at('round');
  if (round === true)
    reader.report('said-twice', roundPath, round, 'a polygon is not round. Leave out "round" or "corners".', { other: 'corners' }); // prettier-ignore
  if (reader.problems.length > before) return {};
  const fault = polygonFault(corners);
  if (fault) reportFault(fault, corners, path, reader);
  else if (areaMm2(corners, size) < leastAreaMm2)
    reader.report('polygon-too-small', path, corners, `the polygon encloses less than ${leastAreaMm2} mm². Make it larger.`, { min: leastAreaMm2 }); // prettier-ignore
  return { corners };
}

/** The area of a figure that is stretched to a size. */
function areaMm2(corners: readonly Point[], [width, height]: Point): number {
  const along = (axis: 0 | 1): number => Math.max(...corners.map((c) => c[axis])) - Math.min(...corners.map((c) => c[axis])); // prettier-ignore
  return (areaOf(corners) / along(0) / along(1)) * width * height;
}

function reportFault(fault: PolygonFault, corners: readonly Point[], path: string, reader: Reader): void {
  if (fault.code === 'flat') {
    reader.report('polygon-too-small', path, corners, 'the corners lie in a straight line and enclose nothing. Move one.', { min: sceneLimits.leastAreaMm2 }); // prettier-ignore
    return;
  }
  const { one, other } = fault;
  const what = `the edge from corner ${one} crosses or touches the one from corner ${other}. Move a corner so that no edges meet.`;
  reader.report('polygon-crossing', path, corners, what, { one, other });
}
