import { describe, expect, it } from 'vitest';

import { unlikeLines } from './unlike-lines';

const compared = (one: string, other: string): readonly [number[], number[]] => {
  const unlike = unlikeLines(one.split('|'), other.split('|'));
  return [[...unlike.one], [...unlike.other]];
};

describe('two programs side by side', () => {
  it.each([
    ['a|b|c', 'a|b|c', [[], []]],
    ['a|x|c', 'a|y|c', [[1], [1]]],
    ['a|b', 'a|new|b', [[], [1]]],
    ['a|old|b', 'a|b', [[1], []]],
    ['a|b|c|d', 'd|a|b|c', [[3], [0]]],
    ['a  ||b', 'a|b||', [[], []]],
    ['', 'a', [[], [0]]],
    ['  a', 'a', [[0], [0]]],
  ])('%j and %j differ in lines %j', (one, other, unlike) => expect(compared(one, other)).toEqual(unlike));

  it('are not compared where that would take long', () => {
    const many = Array.from({ length: 2000 }, (_, place) => String(place));
    expect(unlikeLines(many, many.toReversed())).toEqual({ one: new Set(), other: new Set() });
  });
});
