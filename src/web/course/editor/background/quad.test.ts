import { describe, expect, it } from 'vitest';

import { quarterTurnedQuad, scaledQuad, straightExtentOf, turnedQuad, wholeOf, withCorner, withSide } from './quad';

const extent = { width: 400, height: 300 };
const whole = wholeOf(extent);

describe('the part of a picture that becomes the floor', () => {
  it('follows a corner, in whole pixels and never beyond the picture', () => {
    expect(withCorner(whole, 0, [20.4, 30.6], extent)[0]).toEqual([20, 31]);
    expect(withCorner(whole, 0, [-50, 10], extent)[0]).toEqual([0, 10]);
  });

  it('stays as it was when a corner would fold it over or cross to the other side', () => {
    expect(withCorner(whole, 0, [390, 290], extent)).toBe(whole);
    expect(withCorner(whole, 2, [10, 10], extent)).toBe(whole);
  });

  it('is never narrower than a finger could have meant', () => {
    const narrow = withSide(whole, 1, [-390, 0], extent);
    expect(narrow).toBe(whole);
    expect(withSide(whole, 1, [-380, 0], extent)[1]).toEqual([20, 0]);
  });

  it('is cropped by a side: both of its corners go along', () => {
    expect(withSide(whole, 0, [0, 40], extent)).toEqual([
      [0, 40],
      [400, 40],
      [400, 300],
      [0, 300],
    ]);
  });

  it('turns about its middle and gets smaller rather than leave the picture', () => {
    const turned = turnedQuad(whole, 10, extent);
    for (const [x, y] of turned) {
      expect(x).toBeGreaterThanOrEqual(0);
      expect(x).toBeLessThanOrEqual(400);
      expect(y).toBeGreaterThanOrEqual(0);
      expect(y).toBeLessThanOrEqual(300);
    }
    const { width, height } = straightExtentOf(turned);
    expect(width / height).toBeCloseTo(4 / 3, 1);
    expect(width).toBeLessThan(400);
  });

  it('turns clockwise: its upper side falls to the right', () => {
    const [one, two] = turnedQuad(whole, 10, extent);
    expect(two[1]).toBeGreaterThan(one[1]);
  });

  it('goes along when the picture is turned by a quarter: after four it is itself', () => {
    const part = withCorner(whole, 1, [350, 20], extent);
    const upright = { width: 300, height: 400 };
    const once = quarterTurnedQuad(part, extent);
    expect(once[2]).toEqual([280, 350]);
    const again = quarterTurnedQuad(quarterTurnedQuad(quarterTurnedQuad(once, upright), extent), upright);
    expect(again).toEqual(part);
  });

  it('has the shape of its mean sides, and the same in a smaller picture', () => {
    expect(straightExtentOf(whole)).toEqual({ width: 400, height: 300 });
    const sheet = withCorner(withCorner(whole, 0, [50, 0], extent), 1, [350, 0], extent);
    expect(straightExtentOf(sheet).width).toBe(350);
    expect(straightExtentOf(scaledQuad(whole, 0.5))).toEqual({ width: 200, height: 150 });
  });
});
