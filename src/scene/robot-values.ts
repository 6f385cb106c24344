/** The values of the first robot's start, and the options of any robot as text. */
import { braces } from './json-text';
import type { RobotStart } from './scene';

/** The first robot's start with other values; an empty name and no colour are left out. */
export function withRobot(start: RobotStart, changes: Partial<RobotStart>): RobotStart {
  const { name = '', color = null, ...rest } = { ...start, ...changes };
  return { ...rest, ...(name === '' ? {} : { name }), ...(color === null ? {} : { color }) };
}

/** The first robot's start as the values of an edit that leaves none of those before. */
export const robotValues = (start: RobotStart): Required<RobotStart> => ({ name: '', color: null, ...start });

/** The chosen options as a property of a file, in the order of their ids, so that equal choices give equal text. */
export function optionsProperty(options: RobotStart['options']): string[] {
  const entries = Object.entries(options).sort(([one], [other]) => (one < other ? -1 : 1));
  if (entries.length === 0) return [];
  return [`"options": ${braces(entries.map(([id, choice]) => `${JSON.stringify(id)}: ${JSON.stringify(choice)}`))}`];
}
