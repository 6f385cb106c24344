import { describe, expect, it } from 'vitest';
import { compareTables } from './compare';
import type { ProbeTable, Unit } from './table';

const table = (...rows: readonly (readonly [string, Unit, string])[]): ProbeTable => ({
  program: 'timing',
  machine: 'micro:bit',
  rows: new Map(rows.map(([id, unit, value]) => [id, { unit, value }])),
});
const namesOf = (board: ProbeTable, here: ProbeTable): readonly string[] =>
  compareTables(board, here).differences.map(({ id }) => id);

describe('two tables of a probe', () => {
  it('are alike within a fifth of a time, and within 10 µs', () => {
    const board = table(['a', 'us', '100'], ['b', 'us', '100'], ['c', 'us', '3']);
    expect(namesOf(board, table(['a', 'us', '119'], ['b', 'us', '121'], ['c', 'us', '12']))).toEqual(['b']);
  });

  it('have the same words, to the letter', () => {
    expect(namesOf(table(['a', 'text', '69.8']), table(['a', 'text', '69.80']))).toEqual(['a']);
  });

  it('tell how much more or less it is here', () => {
    const [found] = compareTables(table(['a', 'us', '200']), table(['a', 'us', '130'])).differences;
    expect(found).toEqual({ id: 'a', unit: 'us', board: '200', here: '130', more: -0.35 });
  });

  it('differ where one has a row that the other lacks, or says something else than a number', () => {
    const board = table(['a', 'us', '1'], ['b', 'us', '1']);
    expect(namesOf(board, table(['b', 'text', 'NameError()'], ['c', 'us', '1']))).toEqual(['a', 'b', 'c']);
    expect(compareTables(board, board).differences).toEqual([]);
  });
});
