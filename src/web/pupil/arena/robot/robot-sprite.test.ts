import { describe, expect, it } from 'vitest';
import { resolutionStep } from './robot-sprite';

describe('the robot as pixels', () => {
  it('is made in steps of √2, never coarser than the screen and at most 24 pixels per mm', () => {
    expect(Math.SQRT2 ** resolutionStep(2)).toBeCloseTo(2);
    expect(Math.SQRT2 ** resolutionStep(2.1)).toBeGreaterThan(2.1);
    expect(Math.SQRT2 ** resolutionStep(1000)).toBeLessThan(25);
  });
});
