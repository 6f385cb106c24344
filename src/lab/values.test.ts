import { describe, expect, it } from 'vitest';
import { readNumbers } from './values';

const numbersOf = (text: string): readonly number[] | string => {
  const read = readNumbers(text);
  return 'numbers' in read ? read.numbers : read.problem;
};

describe('the values of what varies', () => {
  it.each([
    ['500..650/50', [500, 550, 600, 650]],
    ['500..640/50', [500, 550, 600]],
    ['650..500/50', [650, 600, 550, 500]],
    ['650..600/-50', [650, 600]],
    ['0..0.4/0.1', [0, 0.1, 0.2, 0.3, 0.4]],
    ['-0.2..0.1/0.1', [-0.2, -0.1, 0, 0.1]],
    ['1e2..3e2/1e2', [100, 200, 300]],
    ['5..5/1', [5]],
    ['0..1#5', [0, 0.25, 0.5, 0.75, 1]],
    ['1..-1#3', [1, 0, -1]],
    ['7..9#1', [7]],
    ['3,-1.5,2', [3, -1.5, 2]],
    ['42', [42]],
  ])('%s are %j', (text, numbers) => expect(numbersOf(text)).toEqual(numbers));

  it('have no minus before a nought', () => expect(Object.is(Number(numbersOf('-0')), -0)).toBe(false));

  it.each([
    ['1..2', 'is neither like 500..900/50'],
    ['1,,2', 'is neither like'],
    ['one', 'is neither like'],
    ['1..2/0', 'the end is never reached'],
    ['1..2/-1', 'the end is never reached'],
    ['1..2#0', 'has no numbers'],
    ['0..1/0.000001', 'at most 100000 runs'],
    ['0..1#100001', 'at most 100000 runs'],
  ])('%s are refused', (text, problem) => expect(numbersOf(text)).toContain(problem));
});
