import { describe, expect, it } from 'vitest';
import { shallowRef, watch } from 'vue';

import { steady } from './steady';

/** A steady list made anew from what is in `source`, and how often it changed. */
function follow<T extends object>(first: T) {
  const source = shallowRef(first);
  const value = steady(() => source.value);
  let changes = 0;
  watch(value, () => (changes += 1), { flush: 'sync' });
  return { source, value, changes: () => changes };
}

describe('a list that stays the same while its values do', () => {
  it('is the very same object for equal values: nothing is drawn anew', () => {
    const { source, value, changes } = follow<readonly number[]>([1, 2, 3]);
    const before = value.value;
    source.value = [1, 2, 3];
    expect(value.value).toBe(before);
    expect(changes()).toBe(0);
  });

  it('changes with any value, and with its length', () => {
    const { source, value, changes } = follow<readonly number[]>([1, 2, 3]);
    source.value = [1, 2, 4];
    expect(value.value).toEqual([1, 2, 4]);
    source.value = [1, 2];
    expect(value.value).toEqual([1, 2]);
    source.value = [1, 2, 0];
    expect(value.value).toEqual([1, 2, 0]);
    expect(changes()).toBe(3);
  });

  it('compares lists inside by their values as well: the colours of lights', () => {
    const { source, value, changes } = follow<readonly (readonly number[])[]>([
      [255, 0, 0],
      [0, 0, 0],
    ]);
    source.value = [
      [255, 0, 0],
      [0, 0, 0],
    ];
    expect(changes()).toBe(0);
    source.value = [
      [255, 0, 0],
      [0, 0, 1],
    ];
    expect(changes()).toBe(1);
    expect(value.value[1]).toEqual([0, 0, 1]);
  });

  it('does so for records by their names', () => {
    const { source, changes } = follow<Readonly<Record<string, boolean>>>({ a: true, b: false });
    source.value = { a: true, b: false };
    expect(changes()).toBe(0);
    source.value = { a: true, c: false };
    expect(changes()).toBe(1);
  });

  it('takes not-a-number for the same as itself', () => {
    const { source, changes } = follow<readonly number[]>([NaN]);
    source.value = [NaN];
    expect(changes()).toBe(0);
  });
});
