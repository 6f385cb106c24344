import { describe, expect, it } from 'vitest';
import { movedBy } from './kinds/index';
import { commonStep } from './moves';
import { block, stroke } from './testing/desk';

describe('the step of things that were moved', () => {
  const things = [block('a', [100, 100]), stroke('b', [0, 0], [50, 80])];
  const once = things.map((thing) => movedBy(thing, 20, -5));
  const twice = once.map((thing) => movedBy(thing, 10, 10));

  it('is known without comparing their points, also over several moves and back', () => {
    expect(commonStep(things, twice)).toEqual({ x: 30, y: 5 });
    expect(commonStep(twice, once)).toEqual({ x: -10, y: -10 });
    expect(commonStep(once, once)).toEqual({ x: 0, y: 0 });
  });

  it('is not known where they went apart, changed otherwise or are others', () => {
    expect(commonStep(things, [once[0]!, twice[1]!])).toBeNull();
    expect(commonStep(things, [once[0]!, { ...once[1]! }])).toBeNull();
    expect(commonStep(things, once.slice(1))).toBeNull();
    expect(commonStep(things, [...once].reverse())).toBeNull();
  });
});
