import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';

import { CERTAIN, RangeDecoder, RangeEncoder } from './range-coder';

/** Decisions that come out with their stated probability. */
function decisions(count: number, seed: number) {
  const rng = createRng(seed);
  return Array.from({ length: count }, () => {
    const yes = Math.max(1, Math.min(CERTAIN - 1, Math.floor(rng.unit() * CERTAIN)));
    return { yes, bit: rng.unit() * CERTAIN < yes ? 1 : 0 };
  });
}

function encoded(all: readonly { readonly yes: number; readonly bit: number }[]): Uint8Array {
  const coder = new RangeEncoder();
  for (const { yes, bit } of all) coder.encode(bit, yes);
  return coder.bytes();
}

describe('arithmetic coder', () => {
  it('reads the decisions that were written, and then is at the end to the byte', () => {
    for (const count of [0, 1, 7, 5_000]) {
      const all = decisions(count, count);
      const decoder = new RangeDecoder(encoded(all));
      expect(all.map(({ yes }) => decoder.decode(yes))).toEqual(all.map(({ bit }) => bit));
      expect(decoder.isAtEnd).toBe(true);
    }
  });

  it('reads the least likely as well, a thousand times in a row', () => {
    const all = Array.from({ length: 1_000 }, (_, index) => ({ yes: index % 2 === 0 ? 1 : CERTAIN - 1, bit: 1 - (index % 2) })); // prettier-ignore
    const decoder = new RangeDecoder(encoded(all));
    expect(all.every(({ yes, bit }) => decoder.decode(yes) === bit)).toBe(true);
  });

  it('takes 125 bytes for 1,000 even decisions, and 5 for 1,000 that are as good as certain', () => {
    const same = (yes: number, bit: number) => encoded(Array.from({ length: 1_000 }, () => ({ yes, bit })));
    expect(same(CERTAIN / 2, 1).length).toBeLessThanOrEqual(126);
    expect(same(CERTAIN - 100, 1).length).toBeLessThanOrEqual(5);
  });

  it('throws when more is read than was written, instead of going on for ever', () => {
    const decoder = new RangeDecoder(Uint8Array.of(0x80));
    const more = (): void => {
      for (let index = 0; index < 100; index += 1) decoder.decode(CERTAIN / 2);
    };
    expect(more).toThrow();
  });
});
