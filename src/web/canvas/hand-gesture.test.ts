import { describe, expect, it } from 'vitest';
import { keepInside, normalAngle, nudgedPose, placedPose, twistedHeading, wheelTurnedHeading } from './hand-gesture';

const pose = { xMm: 100, yMm: 100, headingRad: 0 };

describe('a gesture', () => {
  it('moves by 10 mm per arrow key, up being +y, and by 1 mm with Shift', () => {
    expect(nudgedPose(pose, 'ArrowUp', false)).toEqual({ xMm: 100, yMm: 110, headingRad: 0 });
    expect(nudgedPose(pose, 'ArrowLeft', true)).toEqual({ xMm: 99, yMm: 100, headingRad: 0 });
    expect(nudgedPose(pose, 'x', false)).toBeNull();
  });

  it('twists by the angle between two fingers, the short way round', () => {
    const a = { x: 0, y: 0 };
    expect(twistedHeading(1, [a, { x: -10, y: 1 }], [a, { x: -10, y: -1 }])).toBeCloseTo(1 + 2 * Math.atan(0.1));
  });

  it('turns by 45° at most in one jump of the wheel', () => {
    expect(wheelTurnedHeading(0, 10_000)).toBeCloseTo(-Math.PI / 4);
  });

  it('keeps 30 mm from the edge, and the middle of an arena of 40 mm', () => {
    expect(keepInside({ ...pose, xMm: 5 }, [200, 40], 30)).toEqual({ xMm: 30, yMm: 20, headingRad: 0 });
  });

  it('is told in tenths of a mm and degrees from -180 (excluded) to 180', () => {
    expect(placedPose({ xMm: 12.345, yMm: -0.01, headingRad: -Math.PI })).toEqual({
      xMm: 12.3,
      yMm: 0,
      headingDeg: 180,
    });
    expect(placedPose({ xMm: 0, yMm: 0, headingRad: 7 }).headingDeg).toBe(41.1);
  });

  it('counts angles from -π to π', () => {
    expect(normalAngle(3 * Math.PI + 0.1)).toBeCloseTo(-Math.PI + 0.1);
  });
});
