import { describe, expect, it } from 'vitest';

import { accelerationOf, anglesOf, LEVEL } from './tilt';

describe('a board tilted by hand', () => {
  it('feels 1024 mg into its back when it lies flat', () => {
    expect(accelerationOf(0, 0)).toEqual(LEVEL);
  });

  it('feels half of it to the right at 30°, and 887 mg into its back', () => {
    expect(accelerationOf(0.5, 0)).toEqual({ x: 512, y: 0, z: -887 });
    expect(anglesOf({ x: 512, y: 0 }).rightDeg).toBeCloseTo(30);
  });

  it('stands upright at the rim, and cannot be tilted further', () => {
    expect(accelerationOf(0, 1)).toEqual({ x: 0, y: 1024, z: 0 });
    expect(accelerationOf(0, 5)).toEqual({ x: 0, y: 1024, z: 0 });
    expect(accelerationOf(3, -4)).toEqual({ x: 614, y: -819, z: 0 });
  });

  it('is drawn upright at most, also when a value beyond gravity is set', () => {
    expect(anglesOf({ x: 2000, y: -2000 })).toEqual({ rightDeg: 90, downDeg: -90 });
  });
});
