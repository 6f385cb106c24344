import type { Box } from '../outline';
import { join, type Fields, type Reader } from '../reader';
import { sceneDefaults, sceneLimits, type Point } from '../scene';

/** An object of a course that is yet to be read, and the reader that notes what is wrong with it. */
export interface Unread {
  readonly reader: Reader;
  /** How many points a stroke may have at most. */
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

/** A rotation in eighths of a full turn. */
export const readTurn = ({ reader, at }: Unread): number =>
  reader.whole(...at('turn'), { min: 0, max: 7 }, sceneDefaults.turn);

/** Common properties of all boxes: place, size and rotation. */
export const readBox = (given: Unread): Box & { readonly id: string } => ({
  id: readId(given),
  at: readPlace(given, 'at'),
  size: given.reader.point(...given.at('size'), sceneLimits.blockMm),
  turn: readTurn(given),
});
