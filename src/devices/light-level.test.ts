import { expect, it } from 'vitest';
import { levelOfLux } from './light-level';

it('reads 127 in an ordinary room of 300 lx, 0 in the dark, and rises with the light up to 255', () => {
  expect(levelOfLux(300)).toBe(127);
  expect(levelOfLux(0)).toBe(0);
  const levels = [1, 5, 30, 100, 300, 500, 1000, 3000, 30_000, 100_000].map(levelOfLux);
  expect(levels).toEqual([...levels].sort((a, b) => a - b));
  expect(Math.max(...levels)).toBeLessThan(255);
});
