import { describe, expect, it } from 'vitest';
import { createRig, testChassis } from './testing/rig';

const deg = (rad: number): number => (rad * 180) / Math.PI;
const radOf = (degrees: number): number => (degrees * Math.PI) / 180;

describe('a tyre', () => {
  it.each([5, 15, 25, -20])(
    'that spins gives way sideways: pushing at %i° the nose turns flat against the wall',
    (angle) => {
      const { robot, drive } = createRig({ xMm: 3850, yMm: 2000, headingRad: radOf(angle) });
      drive(255, 255, 6);
      expect(robot.wheelSpeedMmPerS(0)).toBeGreaterThan(50);
      expect(Math.abs(deg(robot.pose().headingRad))).toBeLessThan(1);
    },
  );

  it('holds sideways while it rolls: a push too weak to make the wheels spin leaves the robot aslant', () => {
    const { robot, drive } = createRig({ xMm: 3850, yMm: 2000, headingRad: radOf(40) });
    drive(20, 20, 6);
    expect(robot.wheelSpeedMmPerS(0)).toBeLessThan(1);
    expect(deg(robot.pose().headingRad)).toBeGreaterThan(30);
  });

  it('has one grip for both directions: the robot starts at full power with the force that its tyres transmit', () => {
    const slippery = { ...testChassis(), wheels: testChassis().wheels.map((w) => ({ ...w, gripMu: 0.1 })) };
    const [left, right] = slippery.wheels;
    const { robot, drive } = createRig(undefined, { ...slippery, wheels: [left!, right!] });
    drive(255, 255, 0.1);
    // µ · g · the share of the weight that the castor leaves to the wheels, for 0.1 s
    expect(robot.pathMm()).toBeCloseTo((0.1 * 9806.65 * (1 - 12 / 45) * 0.1 * 0.104) / 2, 1);
  });
});
