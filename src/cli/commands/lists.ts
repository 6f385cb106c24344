import { boardTypes } from '#board/boards/index';
import { robotTypes } from '#robots/index';
import { NO_ROBOT } from '#simulation/run-setup';
import type { Choices } from './about';
import { commandList } from './commands';

/** The lists of values that are not written out in the table. */
export type Lists = Readonly<Record<Extract<Choices, string>, readonly string[]>>;

/** @param courses the ids of the ready courses and missions, which take longest to read */
export const listsWith = (courses: readonly string[]): Lists => ({
  robots: [...robotTypes.map(({ id }) => id), NO_ROBOT],
  boards: boardTypes.map(({ id }) => id),
  firmwares: [...new Set(boardTypes.flatMap(({ firmwares }) => firmwares.map(({ id }) => id)))],
  commands: commandList.map(({ name }) => name),
  courses,
});

/** The values that are meant. */
export const valuesOf = (choices: Choices, lists: Lists): readonly string[] =>
  typeof choices === 'string' ? lists[choices] : choices;
