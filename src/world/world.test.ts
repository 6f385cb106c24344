import { describe, expect, it } from 'vitest';
import { createRig } from './testing/rig';
import { createWorld } from './world';

describe('the hand', () => {
  it('puts the robot down standing still, and neither path nor turn counts it', () => {
    const { robot, world, drive } = createRig();
    drive(100, 60, 2);
    const [path, turned] = [robot.pathMm(), robot.turnedRad()];
    robot.place({ xMm: 500, yMm: 600, headingRad: 1 });
    expect(robot.pose()).toEqual({ xMm: 500, yMm: 600, headingRad: 1 });
    expect([robot.pathMm(), robot.turnedRad()]).toEqual([path, turned]);
    expect(robot.wheelSpeedMmPerS(0)).toBe(0);
    world.step();
    expect(robot.pathMm() - path).toBeLessThan(0.2);
  });

  it('moves a block out of the robot’s way while it runs', () => {
    const { world, robot, drive } = createRig({ xMm: 300, yMm: 1000, headingRad: 0 });
    const block = world.addBlock({ atMm: { x: 500, y: 1000 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: true });
    drive(60, 60, 2);
    const before = robot.pose().xMm;
    block.place({ xMm: 500, yMm: 2000, headingRad: 0.5 });
    drive(60, 60, 1);
    expect(robot.pose().xMm).toBeGreaterThan(before + 100);
    expect(block.pose().headingRad).toBeCloseTo(0.5, 12);
    const beam = { openingRad: 0, rangeMm: 3000 };
    expect(world.distanceCone({ x: 500, y: 500 }, Math.PI / 2, beam).distanceMm).toBeGreaterThan(1400);
  });
});

describe('the world', () => {
  it('maps points of the robot frame to the world', () => {
    const { robot } = createRig({ xMm: 100, yMm: 200, headingRad: Math.PI / 2 });
    const point = robot.toWorld({ x: 30, y: 10 });
    expect(point.x).toBeCloseTo(90, 9);
    expect(point.y).toBeCloseTo(230, 9);
  });

  it('refuses a wall without length or thickness and a block without sides', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 1000 });
    const [a, b] = [
      { x: 10, y: 20 },
      { x: 50, y: 20 },
    ];
    expect(() => world.addWall({ fromMm: a, toMm: a, thicknessMm: 10 })).toThrow(/length.*10, 20/);
    expect(() => world.addWall({ fromMm: a, toMm: b, thicknessMm: 0 })).toThrow(/thickness/);
    expect(() => world.addBlock({ atMm: a, sizeMm: { x: 0, y: 5 }, angleRad: 0, fixed: false })).toThrow(/0 × 5/);
  });

  it('clamps duties to −1 … 1', () => {
    const { robot, world } = createRig();
    robot.setDuty(0, 5);
    robot.setDuty(1, 5);
    for (let step = 0; step < 500; step++) world.step();
    expect(robot.wheelSpeedMmPerS(0)).toBeCloseTo((387 * (1 - 0.0296)) / 1.1, 2);
  });

  it('is black outside the arena', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    expect(world.reflectanceAt({ x: 999, y: 499 }, 3)).toBe(1);
    expect(world.reflectanceAt({ x: 999, y: 501 }, 3)).toBe(0);
  });
});
