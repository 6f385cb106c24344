import { describe, expect, it } from 'vitest';
import { degOf, radOf, wrappedDeg } from './angle';

describe('an angle', () => {
  it('of half a turn is 180° or π', () => {
    expect(degOf(Math.PI)).toBe(180);
    expect(radOf(180)).toBe(Math.PI);
  });

  it('is wrapped to more than −180° up to 180°, exactly', () => {
    const cases = [0, -0, 180, -180, 181, -181, 270, 359.5, 360, -360, 540, 720.25, -1000];
    expect(cases.map(wrappedDeg)).toEqual([0, 0, 180, 180, -179, 179, -90, -0.5, 0, 0, 180, 0.25, 80]);
  });
});
