import { describe, expect, it } from 'vitest';

import { WORDS } from './columns';
import { DamagedBytes } from './damaged-bytes';
import { MODELLED_BYTES, ModelReader, ModelWriter, TooManyBytes } from './model-coder';

const LARGEST = 2 ** 35 - 1;

describe('values written with a model', () => {
  it('come back as they were: small, large, of either sign, as differences, bytes and letters', () => {
    const out = new ModelWriter();
    const numbers = [0, 1, 2, 255, 65_536, LARGEST];
    const signed = [0, -1, 1, -20_000, 17_179_869_183];
    for (const value of numbers) out.uint(1, value);
    for (const value of signed) out.int(2, value);
    for (const value of signed) out.delta(3, value);
    for (const value of [0, 7, 255]) out.byte(4, value);
    for (const unit of 'Grüezi 👋\u0000\ud800') out.uint(WORDS, unit.charCodeAt(0));
    const from = new ModelReader(out.bytes());
    expect(numbers.map(() => from.uint(1))).toEqual(numbers);
    expect(signed.map(() => from.int(2))).toEqual(signed);
    expect(signed.map(() => from.delta(3))).toEqual(signed);
    expect([from.byte(4), from.byte(4), from.byte(4)]).toEqual([0, 7, 255]);
    for (const unit of 'Grüezi 👋\u0000\ud800') expect(from.uint(WORDS)).toBe(unit.charCodeAt(0));
    expect(from.isAtEnd).toBe(true);
  });

  it('take next to nothing once they are as expected', () => {
    const out = new ModelWriter();
    for (let index = 0; index < 1_000; index += 1) out.uint(1, 7);
    expect(out.bytes().length).toBeLessThan(15);
  });

  it('are given up when there are more than 64 kB of them', () => {
    const out = new ModelWriter();
    for (let index = 0; index <= MODELLED_BYTES; index += 1) out.uint(1, 0);
    const from = new ModelReader(out.bytes());
    const all = (): void => {
      for (;;) from.uint(1);
    };
    expect(all).toThrow(TooManyBytes);
  });

  it('end where the bytes end', () => {
    const from = new ModelReader(Uint8Array.of(1, 2, 3));
    const all = (): void => {
      for (;;) from.uint(WORDS);
    };
    expect(all).toThrow(DamagedBytes);
  });
});
