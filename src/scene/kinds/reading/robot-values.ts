/** Reads the properties that a robot has wherever it starts. */
import type { Fields, Reader } from '../../reader';
import { robotColors, sceneLimits, type RobotColor, type RobotStart } from '../../scene';

/** The id of a board or robot type; `null` or left out: chosen by the program. */
export function readTypeId(value: unknown, path: string, reader: Reader): string | null {
  return value === undefined || value === null ? null : reader.text(value, path, sceneLimits.idCharacters);
}

/** The chosen options of a robot. */
export function readOptions(value: unknown, path: string, reader: Reader): RobotStart['options'] {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    reader.wrongType(value, path, 'an object { "option": "choice" }');
    return {};
  }
  const { options, idCharacters } = sceneLimits;
  const ids = reader.list(Object.keys(value), path, { min: 0, max: options }) as readonly string[];
  const choices = new Map<string, string>();
  for (const id of ids) {
    const place = `${path}.${id.slice(0, 40)}`;
    reader.text(id, place, idCharacters);
    if (id === '__proto__') reader.report('unknown-value', place, id, '"__proto__" cannot be an id.');
    choices.set(id, reader.text((value as Fields)[id], place, idCharacters));
  }
  return Object.fromEntries(choices);
}

/** The name of a robot; empty: that of its device. */
export const readRobotName = (value: unknown, path: string, reader: Reader): string =>
  reader.text(value, path, sceneLimits.startNameCharacters);

/** A robot's colour; `null`: by the place of its device. */
export const readRobotColor = (value: unknown, path: string, reader: Reader): RobotColor | null =>
  value === null ? null : reader.word(value, path, robotColors, 'blue');
