import { commandList } from '../commands';

/** A value in quotes, as both shells read it. */
export const quoted = (value: string): string => `'${value.replaceAll("'", "'\\''")}'`;

/** The words with which commands begin. */
export const firstWords = (): readonly string[] => [
  ...new Set(commandList.map(({ name }) => name.split(' ')[0] ?? name)),
];

/** The first words that several commands or one of two words have, with their second words. */
export const secondWords = (): readonly (readonly [first: string, seconds: readonly string[]])[] =>
  firstWords().flatMap((first) => {
    const seconds = commandList.flatMap(({ name }) =>
      name.startsWith(`${first} `) ? [name.slice(first.length + 1)] : [],
    );
    return seconds.length === 0 ? [] : [[first, seconds] as const];
  });
