import { describe, expect, it } from 'vitest';
import type { BlockHandle } from './shapes';
import { createRig, LITE_DRIVE, testChassis } from './testing/rig';

/** How far the test robot's front is ahead of its axle, in mm. */
const FRONT_MM = 59;
const BLOCK_DRAG_N = 0.3 * 0.04 * 9.80665;

const rigWithTrain = (blocks: number, type = testChassis()) => {
  const rig = createRig({ xMm: 200, yMm: 2000, headingRad: 0 }, type);
  const train: BlockHandle[] = [];
  for (let i = 0; i < blocks; i++) {
    const atMm = { x: 200 + FRONT_MM + 26 + 50 * i, y: 2000 };
    train.push(rig.world.addBlock({ atMm, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false }));
  }
  return { ...rig, train };
};

describe('pushing', () => {
  it.each([
    [1, 40],
    [1, 100],
    [3, 40],
    [5, 40],
    [5, 100],
  ])('pushes %i blocks of 40 g at byte %i as fast as motors and friction say, to 0.1 mm in 3 s', (blocks, byte) => {
    const { robot, drive } = rigWithTrain(blocks);
    drive(byte, byte, 3);
    const before = robot.pose().xMm;
    drive(byte, byte, 3);
    const duty = byte / 255;
    const { v0MmPerS, coulomb, viscous, stallForceN } = LITE_DRIVE;
    const speed = (v0MmPerS * (duty - coulomb - (blocks * BLOCK_DRAG_N) / (2 * stallForceN))) / (duty + viscous);
    expect(Math.abs(robot.pose().xMm - before - 3 * speed)).toBeLessThan(0.1);
  });

  it('keeps a pushed block within 0.5 mm of its front', () => {
    const { robot, drive, train } = rigWithTrain(1);
    drive(60, 60, 3);
    const gap = (train[0]?.pose().xMm ?? 0) - 25 - FRONT_MM - robot.pose().xMm;
    expect(gap).toBeGreaterThan(0);
    expect(gap).toBeLessThan(0.5);
  });

  it('leaves a block where it was pushed, to the last bit', () => {
    const { robot, drive, train } = rigWithTrain(1);
    drive(60, 60, 2);
    drive(-60, -60, 1);
    const left = train[0]?.pose();
    drive(0, 0, 2);
    expect(train[0]?.pose()).toEqual(left);
    expect(robot.collisions()).toBe(1);
  });

  it('stalls before a train of 12 blocks, creeping less than 0.5 mm in 5 s', () => {
    const { robot, drive } = rigWithTrain(12); // needs 1.4 N, the tyres hold 0.9 N
    drive(255, 255, 1);
    const before = robot.pose().xMm;
    drive(255, 255, 5);
    expect(Math.abs(robot.pose().xMm - before)).toBeLessThan(0.5);
  });

  it('turns a block that it meets off its middle', () => {
    const { world, drive } = createRig({ xMm: 200, yMm: 1000, headingRad: 0 });
    const block = world.addBlock({ atMm: { x: 300, y: 1045 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false });
    drive(40, 40, 4);
    expect(Math.abs(block.pose().headingRad)).toBeGreaterThan(0.02);
    expect(block.pose().xMm).toBeGreaterThan(500);
  });

  it('cannot move a fixed block', () => {
    const { world, robot, drive } = createRig({ xMm: 200, yMm: 1000, headingRad: 0 });
    const block = world.addBlock({ atMm: { x: 400, y: 1000 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: true });
    drive(100, 100, 3);
    expect(block.pose()).toEqual({ xMm: 400, yMm: 1000, headingRad: 0 });
    expect(robot.pose().xMm).toBeCloseTo(375 - FRONT_MM, 0);
  });
});

describe('walls', () => {
  it.each([40, 100, 255])('stop the robot at byte %i: gap under 0.5 mm, no jitter, no turn', (byte) => {
    const { robot, drive } = createRig({ xMm: 3800, yMm: 2000, headingRad: 0 });
    drive(byte, byte, 3);
    const stopped = robot.pose();
    expect(4000 - FRONT_MM - stopped.xMm).toBeGreaterThan(0);
    expect(4000 - FRONT_MM - stopped.xMm).toBeLessThan(0.5);
    expect(Math.abs(stopped.headingRad)).toBeLessThan(1e-6);
    for (let i = 0; i < 100; i++) {
      drive(byte, byte, 0.02);
      expect(Math.abs(robot.pose().xMm - stopped.xMm)).toBeLessThan(1e-6);
    }
    expect(robot.collisions()).toBe(1);
  });

  it('stall the wheels at byte 40; at full duty the tyres slip', () => {
    const slow = createRig({ xMm: 3900, yMm: 2000, headingRad: 0 });
    slow.drive(40, 40, 3);
    expect(slow.robot.wheelSpeedMmPerS(0)).toBe(0);
    const fast = createRig({ xMm: 3900, yMm: 2000, headingRad: 0 });
    fast.drive(255, 255, 3);
    expect(fast.robot.wheelSpeedMmPerS(0)).toBeGreaterThan(200);
  });

  it('let the robot back off at once', () => {
    const { robot, drive } = createRig({ xMm: 3900, yMm: 2000, headingRad: 0 });
    drive(255, 255, 3);
    drive(-100, -100, 1);
    expect(robot.pose().xMm).toBeLessThan(3750);
  });

  it('turn a robot that meets them at 21° until it slides along them', () => {
    const headingRad = (21 * Math.PI) / 180;
    const { robot, drive } = createRig({ xMm: 300, yMm: 3800, headingRad });
    drive(40, 40, 6);
    expect(Math.abs(robot.pose().headingRad)).toBeLessThan(0.01);
    expect(robot.pose().xMm).toBeGreaterThan(1100);
    expect(4000 - robot.pose().yMm - 40).toBeLessThan(0.6);
  });

  it('push out a robot that the hand left inside one, slower than 1 m/s', () => {
    const { world, robot } = createRig({ xMm: 1000, yMm: 1000, headingRad: 0 });
    world.addWall({ fromMm: { x: 1050, y: 800 }, toMm: { x: 1050, y: 1200 }, thicknessMm: 10 });
    let last = robot.pose().xMm;
    for (let step = 0; step < 500; step++) {
      world.step();
      expect(Math.abs(robot.pose().xMm - last)).toBeLessThan(20);
      last = robot.pose().xMm;
    }
    expect(last).toBeLessThan(1045 - FRONT_MM + 1);
    expect(last).toBeGreaterThan(970);
  });
});

describe('collisions', () => {
  it('count each wall once per touch', () => {
    const { robot, drive } = createRig({ xMm: 3900, yMm: 2000, headingRad: 0 });
    drive(60, 60, 2);
    expect(robot.collisions()).toBe(1);
    drive(-60, -60, 1);
    drive(60, 60, 2);
    expect(robot.collisions()).toBe(2);
  });

  it('count one for two parts of the body that touch the same wall', () => {
    const whole = testChassis();
    const halves = [-1, 1].map((side) => [
      { x: -22, y: side < 0 ? -40 : 0 },
      { x: 59, y: side < 0 ? -40 : 0 },
      { x: 59, y: side < 0 ? 0 : 40 },
      { x: -22, y: side < 0 ? 0 : 40 },
    ]);
    const { robot, drive } = createRig({ xMm: 3900, yMm: 2000, headingRad: 0 }, { ...whole, outlineMm: halves });
    drive(60, 60, 2);
    expect(robot.collisions()).toBe(1);
  });
});
