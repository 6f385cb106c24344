import { describe, expect, it } from 'vitest';
import { changesOf, withChanges } from './changes';
import { createRng } from './rng';

const rng = createRng(3);
const upTo = (n: number): number => rng.u32() % n;

/** Plain data of a few levels. */
function random(depth: number): unknown {
  const kind = upTo(depth > 0 ? 7 : 5);
  if (kind === 0) return upTo(3);
  if (kind === 1) return rng.unit() < 0.5 ? NaN : -0;
  if (kind === 2) return 'abc'.slice(upTo(3));
  if (kind === 3) return rng.unit() < 0.5 ? null : rng.unit() < 0.5;
  if (kind === 4) return Uint8Array.of(upTo(2), 1);
  const parts = Array.from({ length: upTo(4) }, () => random(depth - 1));
  return kind === 5 ? parts : Object.fromEntries(parts.map((part, n) => ['xyzw'[n], part]));
}

describe('the changes between two pieces of plain data', () => {
  it('make the second of the first, whatever they are', () => {
    for (let trial = 0; trial < 2000; trial++) {
      const [before, after] = [random(3), random(3)];
      expect(withChanges(before, changesOf(before, after))).toEqual(after);
      expect(changesOf(after, after)).toBeUndefined();
    }
  });

  it('are as small as what has changed', () => {
    const before = { at: { x: 1, y: 2 }, lights: [0, 9, 9], name: 'robot' };
    expect(changesOf(before, { at: { x: 1, y: 3 }, lights: [0, 9, 5], name: 'robot' })).toEqual({
      at: { y: [3] },
      lights: { 2: [5] },
    });
  });

  it('leave the object as it was where nothing has changed, and say nothing of data that is equal', () => {
    const before = { at: { x: 1 }, sensors: { light: 3, tilt: [1, 2] } };
    const after = { at: { x: 2 }, sensors: { light: 3, tilt: [1, 2] } };
    const made = withChanges(before, changesOf(before, after)) as typeof before;
    expect(made.sensors).toBe(before.sensors);
    expect(changesOf(before.sensors, after.sensors)).toBeUndefined();
  });

  it('take a key that every object inherits for one of its own', () => {
    const after = { constructor: 2 };
    expect(withChanges({ a: 1 }, changesOf({ a: 1 }, after))).toEqual(after);
  });

  it('share nothing with what they were made of', () => {
    const after = { list: [1, 2] };
    const changes = changesOf(null, after);
    after.list[0] = 9;
    expect(withChanges(null, changes)).toEqual({ list: [1, 2] });
  });
});
