import { describe, expect, it } from 'vitest';
import { linesIn, rangesText, toggled } from './line-ranges';

describe('lines as people write them', () => {
  it('are ranges and single ones, with any dash', () => {
    expect(linesIn('1-3, 7', 9)).toEqual([1, 2, 3, 7]);
    expect(linesIn('7;1–3 2', 9)).toEqual([1, 2, 3, 7]);
    expect(rangesText([7, 1, 2, 3])).toBe('1–3, 7');
    expect([linesIn('', 9), rangesText([])]).toEqual([[], '']);
  });

  it.each(['0', '3-1', '8-10', 'all', '1-', '1.5'])('are not “%s” in a program of nine', (typed) =>
    expect(linesIn(typed, 9)).toBeNull(),
  );

  it('go on and off by a tap; with Shift all since the last tap become like that one', () => {
    expect(toggled([1], 3, null)).toEqual([1, 3]);
    expect(toggled([1, 3], 3, null)).toEqual([1]);
    expect(toggled([2], 5, 2)).toEqual([2, 3, 4, 5]);
    expect(toggled([3, 4, 9], 5, 2)).toEqual([9]);
  });
});
