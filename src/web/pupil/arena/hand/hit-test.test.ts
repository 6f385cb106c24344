import { describe, expect, it } from 'vitest';
import { robotRadiusMm, targetAt, toLocal, type Things } from './hit-test';

const square = [
  [
    { x: 30, y: -30 },
    { x: 30, y: 30 },
    { x: -30, y: 30 },
    { x: -30, y: -30 },
  ],
];
const things: Things = {
  robot: { pose: { xMm: 100, yMm: 100, headingRad: Math.PI / 4 }, outlineMm: square, scale: 1 },
  knobMm: null,
  blocks: [
    { id: 'low', pose: { xMm: 300, yMm: 100, headingRad: 0 }, sizeMm: { x: 40, y: 40 } },
    { id: 'high', pose: { xMm: 310, yMm: 100, headingRad: 0 }, sizeMm: { x: 40, y: 40 } },
  ],
};
const mouse = { slopMm: 0, touchMm: 5 };

describe('what lies under the pointer', () => {
  it('is the robot, as far as its turned outline reaches', () => {
    expect(targetAt({ x: 140, y: 100 }, things, mouse).kind).toBe('robot'); // a corner, 42 mm from the middle
    expect(targetAt({ x: 129, y: 129 }, things, mouse).kind).toBe('floor'); // beyond a side, 41 mm from the middle
  });

  it('is a robot of twice the size at 60 mm', () => {
    const large = { ...things, robot: { ...things.robot!, scale: 2 } };
    expect(targetAt({ x: 160, y: 100 }, large, mouse).kind).toBe('robot');
    expect(robotRadiusMm(large.robot)).toBeCloseTo(84.85, 2);
  });

  it('is the block on top, of two that overlap', () => {
    expect(targetAt({ x: 305, y: 100 }, things, mouse)).toEqual({ kind: 'block', id: 'high' });
    expect(targetAt({ x: 285, y: 100 }, things, mouse)).toEqual({ kind: 'block', id: 'low' });
  });

  it('is for a finger still the block 10 mm beside it', () => {
    expect(targetAt({ x: 272, y: 100 }, things, mouse).kind).toBe('floor');
    expect(targetAt({ x: 272, y: 100 }, things, { slopMm: 10, touchMm: 22 })).toEqual({ kind: 'block', id: 'low' });
  });

  it('is the knob of the ring before everything else', () => {
    expect(targetAt({ x: 300, y: 100 }, { ...things, knobMm: { x: 303, y: 100 } }, mouse).kind).toBe('ring');
  });

  it('is told in the frame of a thing: 10 mm in front of a robot that looks up', () => {
    const local = toLocal({ xMm: 0, yMm: 0, headingRad: Math.PI / 2 }, { x: 0, y: 10 });
    expect(local.x).toBeCloseTo(10);
    expect(local.y).toBeCloseTo(0);
  });
});
