import { describe, expect, it } from 'vitest';
import {
  gripBody,
  keepInside,
  normalAngle,
  nudgedPose,
  placedPose,
  pulledPose,
  twistedHeading,
  wheelTurnedHeading,
} from './hand-gesture';

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

describe('a thing that is pulled', () => {
  /** Drags a thing at (100, 100), held at `heldAt`, to these places; returns its final place. */
  function pulled(heldAt: { x: number; y: number }, ...places: { x: number; y: number }[]) {
    let now = { pose, grip: gripBody(pose, heldAt, 30) };
    for (const place of places) if (now.grip.kind === 'move') now = pulledPose(now.grip, now.pose, place);
    const { xMm, yMm, headingRad } = now.pose;
    return [xMm, yMm, (headingRad * 180) / Math.PI].map((value) => Math.round(value) + 0);
  }

  it('keeps its heading when it is pulled straight ahead, and when it is pushed back', () => {
    expect(pulled({ x: 140, y: 100 }, { x: 340, y: 100 })).toEqual([300, 100, 0]);
    expect(pulled({ x: 140, y: 100 }, { x: 130, y: 100 })).toEqual([90, 100, 0]);
  });

  it('turns into the direction of the drag like a trailer', () => {
    expect(pulled({ x: 140, y: 100 }, { x: 140, y: 400 })).toEqual([140, 360, 90]);
    expect(pulled({ x: 60, y: 100 }, { x: 60, y: 400 })).toEqual([60, 360, -90]); // held by its tail
  });

  it('turns with its front ahead when it is held in its middle', () => {
    expect(pulled({ x: 100, y: 100 }, { x: 100, y: 400 })).toEqual([100, 400, 90]);
  });

  it('goes the same way in one jump as in many small steps, within 2°', () => {
    const steps = Array.from({ length: 50 }, (_, i) => ({ x: 140 + i, y: 100 + i }));
    const [, , fine = 0] = pulled({ x: 140, y: 100 }, ...steps);
    const [, , jump = 0] = pulled({ x: 140, y: 100 }, { x: 189, y: 149 });
    expect(Math.abs(fine - jump)).toBeLessThanOrEqual(2);
  });
});
