import { describe, expect, it } from 'vitest';
import { exactExp, exactLog } from './exact-exp';
import { exactAcos, exactAsin, exactAtan, exactAtan2, exactCos, exactSin, exactTan } from './exact-math';
import { createRng } from './rng';

const bitsOf = (value: number): string => {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return view.getBigUint64(0).toString(16).padStart(16, '0');
};

/** Largest relative difference from the engine's own function over 20,000 random inputs. */
const worst = (ours: (x: number) => number, theirs: (x: number) => number, low: number, high: number): number => {
  const rng = createRng(1);
  let largest = 0;
  for (let i = 0; i < 20_000; i++) {
    const x = low + (high - low) * rng.unit();
    const expected = theirs(x);
    largest = Math.max(largest, Math.abs(ours(x) - expected) / Math.abs(expected));
  }
  return largest;
};

describe('exact maths', () => {
  it.each([
    ['sin 1', exactSin(1), '3feaed548f090cee'],
    ['sin −0', exactSin(-0), '8000000000000000'],
    ['sin π', exactSin(3.141592653589793), '3ca1a62633145c07'],
    ['sin 100 000', exactSin(100_000), '3fa24daa9c527e96'],
    ['cos 1', exactCos(1), '3fe14a280fb5068c'],
    ['cos 100 000', exactCos(100_000), 'bfeffac3841b3da7'],
    ['atan 0.6', exactAtan(0.6), '3fe14b1dd5f90ce1'],
    ['atan2(1, −2)', exactAtan2(1, -2), '40056c6e7397f5ae'],
    ['atan2(−3, −4)', exactAtan2(-3, -4), 'c003fc176b7a8560'],
    ['acos 0.5', exactAcos(0.5), '3ff0c152382d7366'],
    ['acos −0.7', exactAcos(-0.7), '4002c501446cd5f2'],
    ['asin 0.8', exactAsin(0.8), '3fedac670561bb50'],
    ['exp −10.5', exactExp(-10.5), '3efcdfc263f6a0ba'],
    ['log 10', exactLog(10), '40026bb1bbb55516'],
  ])('%s has the expected 64 bits', (_name, value, bits) => expect(bitsOf(value)).toBe(bits));

  it.each([
    ['sin', exactSin, Math.sin, -50, 50],
    ['cos', exactCos, Math.cos, -50, 50],
    ['sin of large angles', exactSin, Math.sin, -800_000, 800_000],
    ['cos of large angles', exactCos, Math.cos, -800_000, 800_000],
    ['tan', exactTan, Math.tan, -1.5, 1.5],
    ['atan', exactAtan, Math.atan, -30, 30],
    ['asin', exactAsin, Math.asin, -1, 1],
    ['acos', exactAcos, Math.acos, -1, 1],
    ['exp', exactExp, Math.exp, -700, 700],
    ['log', exactLog, Math.log, 0, 20],
  ] as const)('%s is within 1e-15 of the engine’s', (_name, ours, theirs, low, high) =>
    expect(worst(ours, theirs, low, high)).toBeLessThan(1e-15),
  );

  it('treats zeros and infinities of atan2 like Math.atan2', () => {
    const edges = [0, -0, 1, -1, Infinity, -Infinity];
    for (const y of edges) for (const x of edges) expect(exactAtan2(y, x)).toBe(Math.atan2(y, x));
  });

  it('gives NaN for the sine of an angle beyond 823 549 rad', () => {
    expect(exactSin(1e6)).toBeNaN();
    expect(exactCos(-1e6)).toBeNaN();
  });

  it('gives NaN outside the range of acos, asin and log', () => {
    expect([exactAcos(1.1), exactAsin(-1.1), exactLog(-1)]).toEqual([NaN, NaN, NaN]);
  });

  it('goes to 0 and Infinity at the ends of exp', () => {
    expect([exactExp(-800), exactExp(800)]).toEqual([0, Infinity]);
    expect(bitsOf(exactExp(-740))).toBe('0000000000000055');
  });
});
