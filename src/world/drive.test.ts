import { describe, expect, it } from 'vitest';
import type { ChassisType } from './chassis';
import { byteForSpeed, createRig, LITE_DRIVE, testChassis } from './testing/rig';

const TURN = 2 * Math.PI;

describe('driving straight', () => {
  it.each([0, 0.7, 2.2, -1])('does not bend by 1 nm in 1 m at equal duty, heading %s rad', (headingRad) => {
    const { robot, drive } = createRig({ xMm: 2000, yMm: 2000, headingRad });
    drive(byteForSpeed(200), byteForSpeed(200), 5.5);
    const { xMm, yMm, headingRad: after } = robot.pose();
    expect(robot.pathMm()).toBeGreaterThan(1000);
    expect(Math.abs((yMm - 2000) * Math.cos(headingRad) - (xMm - 2000) * Math.sin(headingRad))).toBeLessThan(1e-6);
    expect(after).toBe(headingRad);
  });

  it('covers 1 m in 5 s at 200 mm/s to 0.01 mm', () => {
    const { robot, drive } = createRig();
    drive(byteForSpeed(200), byteForSpeed(200), 4);
    const before = robot.pose().xMm;
    drive(byteForSpeed(200), byteForSpeed(200), 5);
    expect(robot.pose().xMm - before).toBeCloseTo(1000, 2);
  });

  it('crawls at 10 mm/s to 0.01 % far from the origin', () => {
    const { robot, drive } = createRig({ xMm: 2700, yMm: 2000, headingRad: 0 });
    drive(byteForSpeed(10), byteForSpeed(10), 5);
    const before = robot.pose().xMm;
    drive(byteForSpeed(10), byteForSpeed(10), 5);
    expect(robot.pose().xMm - before).toBeCloseTo(50, 2);
  });

  it('stays still below the duty that overcomes the motors’ dry friction', () => {
    const { robot, drive } = createRig();
    drive(7, 7, 1); // 7 / 255 < 0.0296
    expect(robot.pathMm()).toBe(0);
    drive(8, 8, 1);
    expect(robot.pathMm()).toBeGreaterThan(0.5);
  });

  it('needs more power to start than to keep rolling where the gears stick', () => {
    const sticky = testChassis({ coulomb: 0, breakaway: { share: 0.1, until: 0.2 } });
    const atRest = createRig(undefined, sticky);
    atRest.drive(25, 25, 2); // 25 / 255 < 0.1
    expect(atRest.robot.pathMm()).toBe(0);
    atRest.drive(60, 60, 2);
    atRest.drive(25, 25, 4);
    expect(atRest.robot.wheelSpeedMmPerS(0)).toBeGreaterThan(100);
  });

  it('reaches 63 % of its full speed after 60 ms', () => {
    const { robot, drive } = createRig();
    drive(255, 255, 0.06);
    const full = (387 * (1 - 0.0296)) / 1.1;
    expect(robot.wheelSpeedMmPerS(0) / full).toBeCloseTo(0.63, 1);
    drive(255, 255, 1);
    expect(robot.wheelSpeedMmPerS(0)).toBeCloseTo(full, 3);
  });

  it('stops within 3 cm when the duty goes from full to 0, and then stands still', () => {
    const { robot, drive } = createRig();
    drive(255, 255, 1);
    const before = robot.pathMm();
    drive(0, 0, 0.5);
    expect(robot.pathMm() - before).toBeLessThan(30);
    const stopped = robot.pose();
    drive(0, 0, 1);
    expect(robot.pose()).toEqual(stopped);
  });

  it('turns its wheels by the way they went', () => {
    const { robot, drive } = createRig();
    drive(100, 100, 3);
    expect(robot.wheelTurnRad(0) * 21.5).toBeCloseTo(robot.pathMm(), 1);
  });
});

describe('turning on the spot', () => {
  it.each([20, 40, 100, 255])('keeps the middle of the axle within 1 µm at byte %i', (byte) => {
    const { robot, drive } = createRig();
    drive(-byte, byte, 6);
    const { xMm, yMm } = robot.pose();
    expect(robot.turnedRad()).toBeGreaterThan(TURN);
    expect(Math.abs(xMm - 2000) + Math.abs(yMm - 2000)).toBeLessThan(1e-3);
  });

  it('turns at the speed of its wheels to 0.01 %', () => {
    const { robot, drive } = createRig();
    const byte = byteForSpeed(140);
    drive(-byte, byte, 3);
    const before = robot.turnedRad();
    drive(-byte, byte, 3);
    expect((robot.turnedRad() - before) / ((3 * 140) / 35)).toBeCloseTo(1, 4);
  });
});

describe('driving curves', () => {
  it('keeps a radius of 160 mm to 0.02 % without scrub', () => {
    const { robot, drive } = createRig(undefined, testChassis({ yawResistance: 0 }));
    const [inner, outer] = [byteForSpeed((150 * 125) / 160), byteForSpeed((150 * 195) / 160)];
    drive(inner, outer, 4);
    const [path, turned] = [robot.pathMm(), robot.turnedRad()];
    drive(inner, outer, 5);
    const radius = (robot.pathMm() - path) / (robot.turnedRad() - turned);
    expect(Math.abs(radius / 160 - 1)).toBeLessThan(2e-4);
  });

  it.each([
    [14, 39],
    [33, 65],
    [60, 255],
  ])('runs its wheels at the drive law’s speeds to 2 in 1000 at bytes %i and %i', (inner, outer) => {
    const { robot, drive } = createRig();
    drive(inner, outer, 8);
    const [slow, fast] = [robot.wheelSpeedMmPerS(0), robot.wheelSpeedMmPerS(1)];
    const { v0MmPerS: v0, coulomb, viscous, yawResistance } = LITE_DRIVE;
    const mean = (slow + fast) / 2;
    const givingWay = (fast - slow) / Math.hypot(fast - slow, 0.1 * mean);
    const scrub = yawResistance * (mean / v0) ** 3 * givingWay;
    const expectedSlow = (v0 * (inner / 255 - coulomb + scrub)) / (inner / 255 + viscous);
    const expectedFast = (v0 * (outer / 255 - coulomb - scrub)) / (outer / 255 + viscous);
    expect(Math.abs(slow / expectedSlow - 1)).toBeLessThan(0.002);
    expect(Math.abs(fast / expectedFast - 1)).toBeLessThan(0.002);
  });

  it('curves to the other side when the bytes change sides, mirrored to 1 nm', () => {
    const left = createRig();
    const right = createRig();
    left.drive(20, 60, 3);
    right.drive(60, 20, 3);
    const [a, b] = [left.robot.pose(), right.robot.pose()];
    expect(a.xMm).toBeCloseTo(b.xMm, 6);
    expect(a.yMm - 2000).toBeCloseTo(2000 - b.yMm, 6);
    expect(a.headingRad).toBeCloseTo(-b.headingRad, 9);
  });

  it('lets scrub hold back a small difference of the wheels, never reverse it', () => {
    const free = createRig(undefined, testChassis({ yawResistance: 0 }));
    const scrubbing = createRig(undefined, testChassis({ yawResistance: 1 }));
    for (const { drive } of [free, scrubbing]) drive(195, 200, 4);
    expect(scrubbing.robot.turnedRad()).toBeGreaterThan(0);
    expect(scrubbing.robot.turnedRad()).toBeLessThan(0.2 * free.robot.turnedRad());
    expect(scrubbing.robot.wheelSpeedMmPerS(1)).toBeGreaterThanOrEqual(scrubbing.robot.wheelSpeedMmPerS(0));
  });

  it('never drags the standing inner wheel backwards', () => {
    const { robot, drive } = createRig();
    drive(0, 60, 0.004);
    for (let step = 0; step < 250; step++) {
      drive(0, 60, 0.004);
      expect(robot.wheelSpeedMmPerS(0)).toBeGreaterThanOrEqual(0);
    }
  });

  it('does not swing when it comes out of a curve at full power: the turn dies out, it never changes sides', () => {
    const { robot, drive } = createRig();
    drive(60, 255, 1);
    let before = robot.turnedRad();
    for (let step = 0; step < 250; step++) {
      drive(255, 255, 0.004);
      expect(robot.turnedRad() - before).toBeGreaterThan(-1e-9);
      before = robot.turnedRad();
    }
    drive(255, 255, 1);
    expect(robot.turnedRad() - before).toBeLessThan(1e-3);
  });
});

describe('unequal motors', () => {
  const unequal: ChassisType = { ...testChassis(), strength: [1.05, 0.95] };

  it.each([
    [39, 60],
    [100, 60],
    [255, 40],
  ])('bend the way of a robot with a strong left motor at byte %i: over %i mm to the right within 1 m', (byte, mm) => {
    const { robot, drive } = createRig(undefined, unequal);
    while (robot.pathMm() < 1000) drive(byte, byte, 0.004);
    expect(2000 - robot.pose().yMm).toBeGreaterThan(mm);
  });

  it('drive mirrored when the right one is the stronger, to 1 nm', () => {
    const right: ChassisType = { ...testChassis(), strength: [0.95, 1.05] };
    const [a, b] = [createRig(undefined, unequal), createRig(undefined, right)];
    for (const { drive } of [a, b]) drive(39, 39, 3);
    expect(a.robot.pose().yMm - 2000).toBeCloseTo(2000 - b.robot.pose().yMm, 6);
  });

  it('drive as any others when both are as strong as the law says', () => {
    const plain = createRig();
    const same = createRig(undefined, { ...testChassis(), strength: [1, 1] });
    for (const { drive } of [plain, same]) drive(30, 80, 3);
    expect(same.robot.pose()).toEqual(plain.robot.pose());
  });

  it('turn 5 % faster or slower at full power, and start a little earlier or later', () => {
    const { robot, drive } = createRig(undefined, { ...testChassis({ yawResistance: 0 }), strength: [1.05, 0.95] });
    drive(255, 255, 2);
    const ofStrength = (strength: number): number => (387 * strength * (1 - 0.0296 / strength)) / 1.1;
    expect(robot.wheelSpeedMmPerS(0)).toBeCloseTo(ofStrength(1.05), 1);
    expect(robot.wheelSpeedMmPerS(1)).toBeCloseTo(ofStrength(0.95), 1);
    const weak = createRig(undefined, { ...testChassis(), strength: [0.8, 0.8] });
    weak.drive(8, 8, 1); // 0.8 · 8 / 255 < 0.0296
    expect(weak.robot.pathMm()).toBe(0);
  });
});
