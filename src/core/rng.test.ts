import { describe, expect, it } from 'vitest';
import { createRng } from './rng';

describe('chance', () => {
  it('repeats with its seed and differs without', () => {
    expect(createRng(7).u32()).toBe(createRng(7).u32());
    expect(createRng(7).u32()).not.toBe(createRng(8).u32());
  });

  it('gives each purpose a stream of its own, whatever was drawn before', () => {
    const rng = createRng(7);
    const before = rng.fork('motors').u32();
    rng.u32();
    expect(rng.fork('motors').u32()).toBe(before);
    expect(rng.fork('sensors').u32()).not.toBe(before);
  });

  it('tells a fork of a fork by the order of the names', () => {
    const one = createRng(7).fork('left').fork('noise').u32();
    const other = createRng(7).fork('noise').fork('left').u32();
    expect(one).not.toBe(other);
  });
});
