import type { CourseChanges } from './edit';
import { PICTURE, readBase64 } from './read-base64';
import { readLeague } from './league/read-league';
import { readTask } from './read-task';
import type { Fields, Reader } from './reader';
import { readOptions, readRobotColor, readRobotName, readTypeId } from './kinds/reading/robot-values';
import { sceneLimits, type Background, type RobotStart } from './scene';

/** Reads the properties of a course as a whole; what is left out stays left out. */
export function readCourseChanges(fields: Fields, path: string, reader: Reader): CourseChanges {
  const { nameCharacters, descriptionCharacters, sizeMm } = sceneLimits;
  return {
    ...given(fields, 'name', (value) => reader.text(value, `${path}name`, nameCharacters)),
    ...given(fields, 'description', (value) => reader.text(value, `${path}description`, descriptionCharacters)),
    ...given(fields, 'size', (value) => reader.point(value, `${path}size`, sizeMm)),
    ...given(fields, 'task', (value) => readTask(value, `${path}task`, reader)),
    ...given(fields, 'background', (value) => readBackground(value, `${path}background`, reader)),
    ...given(fields, 'league', (value) => readLeague(value, `${path}league`, reader)),
    ...given(fields, 'ambient', (value) => reader.number(value, `${path}ambient`, sceneLimits.ambientLx)),
  };
}

/** Reads the properties of the robot's start; what is left out stays left out. */
export function readRobotChanges(value: unknown, path: string, reader: Reader): Partial<RobotStart> {
  const fields = reader.fields(value, path, ['type', 'at', 'heading', 'scale', 'options', 'name', 'color']);
  return {
    ...given(fields, 'type', (type) => readTypeId(type, `${path}.type`, reader)),
    ...given(fields, 'at', (at) => reader.point(at, `${path}.at`, sceneLimits.placeMm)),
    ...given(fields, 'heading', (heading) => reader.number(heading, `${path}.heading`, sceneLimits.headingDeg)),
    ...given(fields, 'scale', (scale) => reader.number(scale, `${path}.scale`, sceneLimits.scale)),
    ...given(fields, 'options', (options) => readOptions(options, `${path}.options`, reader)),
    ...given(fields, 'name', (name) => readRobotName(name, `${path}.name`, reader)),
    ...given(fields, 'color', (color) => readRobotColor(color, `${path}.color`, reader)),
  };
}

const given = <const K extends string, T>(
  fields: Fields,
  key: K,
  read: (value: unknown) => T,
): Partial<Record<K, T>> | Record<K, T> =>
  fields[key] === undefined ? {} : ({ [key]: read(fields[key]) } as Record<K, T>);

/** Checks only the form: whether the levels can be inflated shows when they are (`background.ts`). */
function readBackground(value: unknown, path: string, reader: Reader): Background | null {
  if (value === null) return null;
  const fields = reader.fields(value, path, ['at', 'size', 'cells', 'levels', 'picture']);
  const { placeMm, backgroundMm, cells: maxCells } = sceneLimits;
  const cells = reader.point(fields.cells, `${path}.cells`, { min: 1, max: maxCells });
  const count = cells[0] * cells[1];
  if (count > maxCells)
    reader.report('too-many', `${path}.cells`, cells, `${count} cells; there may be 1 … ${maxCells}.`, {
      count,
      min: 1,
      max: maxCells,
    });
  return {
    at: reader.point(fields.at, `${path}.at`, placeMm),
    size: reader.point(fields.size, `${path}.size`, backgroundMm),
    cells,
    levels: readBase64(fields.levels, `${path}.levels`, /^/, reader),
    picture:
      fields.picture === undefined || fields.picture === ''
        ? ''
        : readBase64(fields.picture, `${path}.picture`, PICTURE, reader),
  };
}
