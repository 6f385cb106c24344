import { describe, expect, it } from 'vitest';
import { exactCos, exactSin } from '#core/exact-math';
import { createRng } from '#core/rng';
import type { FieldShape } from '../shapes';
import { fieldOf, underFields, type Field } from './fields';

const SIZE = 24;
const NEITHER = 1;

const chance = createRng(7).fork('fields');
const between = (least: number, most: number): number => least + (most - least) * chance.unit();

const PARTS = [
  [{ x: -10, y: -10 }, { x: 10, y: -10 }, { x: 0, y: 15 }],
  [{ x: 0, y: 0 }, { x: 20, y: 0 }, { x: 10, y: 15 }],
]; // prettier-ignore

function anyField(layer: number): Field {
  const atMm = { x: between(-30, 30), y: between(-30, 30) };
  const sizeMm = { x: between(3, 60), y: between(3, 60) };
  const angleRad = chance.unit() < 0.5 ? 0 : between(-3, 3);
  const form = [{ isRound: true }, { partsMm: PARTS }, {}][Math.floor(between(0, 3))];
  const shape: FieldShape = { atMm, sizeMm, angleRad, reflectance: between(0, 1), ...form };
  return fieldOf(shape, shape.reflectance, layer);
}

/** The mean under a spot, with all looks one after the other. */
function meanOfAllLooks(at: (x: number, y: number) => number, x: number, y: number, radius: number): number {
  let mean = 0;
  for (let row = 0; row < SIZE; row++) {
    const angle = (Math.PI * (row + 1)) / (SIZE + 1);
    const [offset, half] = [exactCos(angle), exactSin(angle)];
    let sum = 0;
    for (let look = 0; look < SIZE; look++)
      sum += at(x + ((2 * look + 1) / SIZE - 1) * half * radius, y + offset * radius);
    mean += (((2 * half * half) / (SIZE + 1)) * sum) / SIZE;
  }
  return mean;
}

describe('a spot on the edges of fields', () => {
  it('is to the last bit the mean of all looks, though most need not be taken', () => {
    let mixed = 0;
    for (let n = 0; n < 1000; n++) {
      const fields = [2, 1, 0].map(anyField);
      const [x, y, radius] = [between(-40, 40), between(-40, 40), between(0.5, 12)];
      const under = underFields(fields, NEITHER, x, y, radius);
      if (typeof under === 'number') continue;
      const at = (px: number, py: number): number =>
        fields.find((field) => field.depth(px, py) >= 0)?.reflectance ?? NEITHER;
      expect(under.under(x, y, radius)).toBe(meanOfAllLooks(at, x, y, radius));
      mixed++;
    }
    expect(mixed).toBeGreaterThan(300);
  });
});
