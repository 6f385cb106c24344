/** What is said of a robot wherever it starts: its type and its options. */
import { braces } from './json-text';
import type { Fields, Reader } from './reader';
import { robotColors, sceneLimits, type RobotColor, type RobotStart } from './scene';

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

/** What a robot is called; empty: as its device. */
export const readRobotName = (value: unknown, path: string, reader: Reader): string =>
  reader.text(value, path, sceneLimits.startNameCharacters);

/** A robot's colour; `null`: by the place of its device. */
export const readRobotColor = (value: unknown, path: string, reader: Reader): RobotColor | null =>
  value === null ? null : reader.word(value, path, robotColors, 'blue');

/** The first robot's start with other values; an empty name and no colour are left out. */
export function withRobot(start: RobotStart, changes: Partial<RobotStart>): RobotStart {
  const { name = '', color = null, ...rest } = { ...start, ...changes };
  return { ...rest, ...(name === '' ? {} : { name }), ...(color === null ? {} : { color }) };
}

/** The first robot's start as the values of an edit that leave nothing of another one. */
export const robotValues = (start: RobotStart): Required<RobotStart> => ({ name: '', color: null, ...start });

/** In the order of their ids, so that equal choices give equal text. */
export function optionsProperty(options: RobotStart['options']): string[] {
  const entries = Object.entries(options).sort(([one], [other]) => (one < other ? -1 : 1));
  if (entries.length === 0) return [];
  return [`"options": ${braces(entries.map(([id, choice]) => `${JSON.stringify(id)}: ${JSON.stringify(choice)}`))}`];
}
