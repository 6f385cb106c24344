import { describe, expect, it } from 'vitest';
import { createCache } from './shelf';

describe('a shelf', () => {
  it('makes a thing once for each key, and all anew when there was too much', () => {
    const made: number[] = [];
    const at = createCache<object>(2);
    const ask = (key: number): object =>
      at(['ring', key], () => {
        made.push(key);
        return {};
      });
    const first = ask(1);
    ask(2);
    expect(ask(1)).toBe(first);
    expect(made).toEqual([1, 2]);
    ask(3);
    expect(ask(1)).not.toBe(first);
    expect(made).toEqual([1, 2, 3, 1]);
  });
});
