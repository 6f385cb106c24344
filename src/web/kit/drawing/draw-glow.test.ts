import { describe, expect, it } from 'vitest';
import { floorLight } from './draw-glow';

describe('the light under the robot', () => {
  it('keeps its hue and fades with its brightness', () => {
    const dim = floorLight([0, 0, 25]);
    const full = floorLight([0, 0, 255]);
    expect(dim.color).toEqual(full.color);
    expect(dim.alpha).toBeGreaterThan(0.2);
    expect(dim.alpha).toBeLessThan(full.alpha / 2);
  });

  it('is nothing when it is off', () => expect(floorLight([0, 0, 0]).alpha).toBe(0));

  it('is a light blue when it is white: white on a white floor could not be seen', () => {
    expect(floorLight([255, 255, 255]).color).toEqual([150, 200, 255]);
  });
});
