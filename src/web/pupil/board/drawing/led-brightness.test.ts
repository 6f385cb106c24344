import { describe, expect, it } from 'vitest';
import { ledOpacity } from './led-brightness';

describe('the brightness of the display', () => {
  it('has ten steps, each brighter than the one before', () => {
    const steps = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map(ledOpacity);
    expect(steps[0]).toBe(0);
    expect(steps[9]).toBe(1);
    for (let i = 1; i < 10; i += 1) expect(steps[i]).toBeGreaterThan(steps[i - 1]!);
  });

  it('shows level 5 at 47 %, clearly brighter than the 12 % of power it gets', () => {
    expect(ledOpacity(5)).toBeCloseTo(0.47, 2);
  });

  it('takes 12 for 9 and -1 for 0', () => {
    expect(ledOpacity(12)).toBe(1);
    expect(ledOpacity(-1)).toBe(0);
  });
});
