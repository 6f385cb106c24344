import { describe, expect, it } from 'vitest';
import { tagPattern } from './tag-pattern';

const drawn = (number: number): string[] =>
  tagPattern(number).map((row) => row.map((isWhite) => (isWhite ? '#' : '.')).join(''));
const codeOf = (number: number): number =>
  tagPattern(number)
    .flat()
    .reduce((code, isWhite) => code * 2 + (isWhite ? 1 : 0), 0);

describe('the pattern of a tag', () => {
  it('is that of the family 36h11', () => {
    expect(drawn(0)).toEqual(['##.#.#', '.###.#', '.##...', '#.#...', '.#.##.', '...#..']);
    // The published codes of 1, 2, 5, 6 and 10.
    expect([1, 2, 5, 6].map((number) => codeOf(number).toString(16))).toEqual(['d97f18b49', 'dd280910e', 'f31dab3ac', '56a5d085']); // prettier-ignore
    expect(codeOf(99).toString(16)).toBe('499ff26c7');
  });

  it('differs from every other, however it is turned, in eleven cells or more', () => {
    const turned = (cells: readonly boolean[]): boolean[] => cells.map((_, i) => cells[(5 - (i % 6)) * 6 + Math.floor(i / 6)]!); // prettier-ignore
    const all = Array.from({ length: 99 }, (_, i) => tagPattern(i + 1).flat());
    let least = 36;
    for (const [i, one] of all.entries()) {
      let other: readonly boolean[] = one;
      for (let turn = 0; turn < 4; turn++) {
        for (const second of all.slice(turn === 0 ? i + 1 : i)) {
          least = Math.min(least, second.filter((cell, place) => cell !== other[place]).length);
        }
        other = turned(other);
      }
    }
    expect(least).toBe(11);
  });
});
