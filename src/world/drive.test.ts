import { describe, expect, it } from 'vitest';
import { byteForSpeed, createRig, LITE_DRIVE, testChassis } from './testing/rig';

const TURN = 2 * Math.PI;

/** Duty bytes of mbrobot's setSpeed for the Lite, and the inner and outer wheel of its leftArc(radius) at speed 50. */
const byteOfPercent = (s: number): number =>
  s <= 0 ? 0 : Math.floor(s <= 33 ? 0.4 * s + 11 : s <= 63 ? 0.89 * s - 5 : s < 100 ? 1.0561 ** s + 20 : 255);
const arcBytes = (radiusM: number): [number, number] => {
  const cm = Math.round(100 * radiusM);
  const outer = 50 - Math.max(cm + 20, 40) <= 0 ? Math.min(Math.max(cm + 40, 40), 100) : 50;
  const outerPercent = Math.max(outer, 50);
  const inner = (outerPercent * (10 * cm - 35)) / (cm * 10.6 + 90 + Math.floor((100 - outerPercent) / 2));
  return [byteOfPercent(Math.floor(inner)), byteOfPercent(outerPercent)];
};

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
    const scrub = yawResistance * ((slow + fast) / 2 / v0) ** 2;
    const expectedSlow = (v0 * (inner / 255 - coulomb + scrub)) / (inner / 255 + viscous);
    const expectedFast = (v0 * (outer / 255 - coulomb - scrub)) / (outer / 255 + viscous);
    expect(Math.abs(slow / expectedSlow - 1)).toBeLessThan(0.002);
    expect(Math.abs(fast / expectedFast - 1)).toBeLessThan(0.002);
  });

  it.each([0.15, 0.2, 0.25, 0.3, 0.35, 0.4])(
    'drives leftArc(%f) at speed 50 as a circle within a quarter of its radius',
    (radiusM) => {
      const { robot, drive } = createRig();
      const [inner, outer] = arcBytes(radiusM);
      drive(inner, outer, 1);
      const [path, turned] = [robot.pathMm(), robot.turnedRad()];
      drive(inner, outer, 4);
      const radius = (robot.pathMm() - path) / (robot.turnedRad() - turned) / 1000;
      expect(Math.abs(radius / radiusM - 1)).toBeLessThan(0.15);
    },
  );

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

  it('lets scrub cancel a small difference of the wheels, never reverse it', () => {
    const { robot, drive } = createRig();
    drive(200, 201, 6);
    expect(Math.abs(robot.turnedRad())).toBeLessThan(0.02);
    expect(robot.wheelSpeedMmPerS(1)).toBeGreaterThanOrEqual(robot.wheelSpeedMmPerS(0) - 1e-9);
  });
});
