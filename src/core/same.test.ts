import { describe, expect, it } from 'vitest';
import { isSame } from './same';

describe('two pieces of plain data', () => {
  it('say the same when all that is in them does, in any order of properties', () => {
    expect(isSame({ at: [1, 2], name: 'a' }, { name: 'a', at: [1, 2] })).toBe(true);
    expect(isSame([NaN, null, undefined], [NaN, null, undefined])).toBe(true);
  });

  it.each([
    [{ a: 1 }, { a: 1, b: undefined }],
    [{ a: undefined }, { b: undefined }],
    [
      [1, 2],
      [1, 2, 3],
    ],
    [{ at: [1, 2] }, { at: [2, 1] }],
    [null, {}],
    ['1', 1],
    [NaN, null],
  ])('differ: %j and %j', (one, other) => {
    expect([isSame(one, other), isSame(other, one)]).toEqual([false, false]);
  });
});
