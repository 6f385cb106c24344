import { describe, expect, it, vi } from 'vitest';

import { fill, ofCanvas, ofEveryList, ofLists, ofObjects, ofSignals } from './methods';

/** A list that has, of all that is filled in, only what is filled in. */
function bare<T>(values: readonly T[]): T[] {
  const methods = { ...ofEveryList, ...ofLists };
  const own = Object.fromEntries(Object.entries(methods).map(([name, value]) => [name, { value }]));
  return Object.defineProperties([...values], own);
}

const LISTS = [[], [3], [3, 1, 2, 3], [10, 9, 1, -0, 0]];

describe('what the oldest browsers lack of lists', () => {
  it.each(LISTS.map((list) => [list]))('is for %j what newer ones do', (list) => {
    const filled = bare(list);
    expect(filled.toReversed()).toEqual(list.toReversed());
    expect(filled.toSorted()).toEqual(list.toSorted());
    expect(filled.toSorted((a, b) => b - a)).toEqual(list.toSorted((a, b) => b - a));
    expect(filled.findLast((value) => value > 2)).toBe(list.findLast((value) => value > 2));
    expect(filled.findLastIndex((value) => value > 2)).toBe(list.findLastIndex((value) => value > 2));
    for (const [start, count] of [
      [0, 1],
      [-2, 1],
      [1, 9],
      [9, 1],
    ] as const)
      // prettier-ignore
      expect(filled.toSpliced(start, count, 7, 8)).toEqual(list.toSpliced(start, count, 7, 8));
    expect(filled).toEqual(list);
  });

  it('puts a value at a place, also counted from the end, and refuses one that is not there', () => {
    const list = [1, 2, 3];
    for (const place of [0, 2, -1, -3, 1.7]) expect(bare(list).with(place, 9)).toEqual(list.with(place, 9));
    for (const place of [3, -4, Infinity]) {
      expect(() => list.with(place, 9)).toThrow(RangeError);
      expect(() => bare(list).with(place, 9)).toThrow(RangeError);
    }
  });

  it('leaves lists of numbers what they are', () => {
    const numbers = Float64Array.of(10, 9, -1);
    expect(ofEveryList.toSorted.call(numbers as never)).toEqual(numbers.toSorted());
    expect(ofEveryList.with.call(numbers as never, 1, 4)).toEqual(numbers.with(1, 4));
    expect(ofEveryList.findLastIndex.call(numbers as never, (value) => Number(value) > 0)).toBe(1);
  });
});

describe('what they lack of the rest', () => {
  it('tells own properties from inherited ones', () => {
    expect(ofObjects.hasOwn({ a: 1 }, 'a')).toBe(true);
    expect(ofObjects.hasOwn({}, 'toString')).toBe(false);
    expect(ofObjects.hasOwn(Object.create(null) as object, 'a')).toBe(false);
  });

  it('stops what was called off', () => {
    const stopper = new AbortController();
    ofSignals.throwIfAborted.call(stopper.signal);
    stopper.abort();
    expect(() => ofSignals.throwIfAborted.call(stopper.signal)).toThrow(/abort/i);
    expect(() => ofSignals.throwIfAborted.call({ aborted: true } as AbortSignal)).toThrow(/abort/i);
  });

  it('rounds a rectangle’s corners by no more than half of it', () => {
    const drawn: string[] = [];
    const note =
      (name: string) =>
      (...values: number[]) =>
        void drawn.push(`${name} ${values.join(' ')}`.trim());
    const canvas = { moveTo: note('moveTo'), arcTo: note('arcTo'), closePath: note('closePath') };
    ofCanvas.roundRect.call(canvas as never, 10, 20, 30, 8, 6);
    expect(drawn).toEqual([
      'moveTo 14 20',
      ...['arcTo 40 20 40 28 4', 'arcTo 40 28 10 28 4', 'arcTo 10 28 10 20 4', 'arcTo 10 20 40 20 4'],
      ...['closePath', 'moveTo 10 20'],
    ]);
  });

  it('is put only where it is missing, unseen by loops', () => {
    const there = vi.fn();
    const owner = { there };
    fill(owner, { there: vi.fn(), missing: () => 1 });
    expect(owner.there).toBe(there);
    expect(Object.keys(owner)).toEqual(['there']);
    expect((owner as { missing?: () => number }).missing?.()).toBe(1);
    fill(undefined, { missing: 1 });
  });
});
