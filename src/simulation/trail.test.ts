import { describe, expect, it } from 'vitest';
import { createRig } from '#world/testing/rig';
import { createTrailSender, type TrailPoint } from './trail';

/** A robot at (300 | 1000) that looks along x, with its recorded path. */
function setUp() {
  const { robot, world } = createRig({ xMm: 300, yMm: 1000, headingRad: 0 });
  const points: TrailPoint[] = [];
  const step = createTrailSender(robot, (point) => points.push(point));
  step();
  const drive = (left: number, right: number, seconds: number): void => {
    robot.setDuty(0, left);
    robot.setDuty(1, right);
    for (let i = 0; i < seconds * 250; i += 1) {
      world.step();
      step();
    }
  };
  return { robot, points, drive };
}

describe('the trail of a robot', () => {
  it('begins where it stands and has no more points while it stands still', () => {
    const { points, drive } = setUp();
    drive(0, 0, 1);
    expect(points).toEqual([{ x: 300, y: 1000 }]);
  });

  it('has a point every 4 to 6 mm', () => {
    const { robot, points, drive } = setUp();
    drive(0.3, 0.2, 2);
    expect(points.length).toBeGreaterThan(robot.pathMm() / 6);
    expect(points.length).toBeLessThan(robot.pathMm() / 4 + 2);
    const end = points.at(-1);
    expect(Math.hypot(robot.pose().xMm - (end?.x ?? 0), robot.pose().yMm - (end?.y ?? 0))).toBeLessThan(4);
  });

  it('has a gap where the hand carried the robot', () => {
    const { robot, points, drive } = setUp();
    drive(0.3, 0.3, 1);
    const before = points.length;
    robot.place({ xMm: 900, yMm: 400, headingRad: 1 });
    drive(0, 0, 0.1);
    expect(points.slice(before)).toEqual([null, { x: 900, y: 400 }]);
    drive(0.3, 0.3, 1);
    expect(points.slice(before + 1)).not.toContain(null);
  });
});
