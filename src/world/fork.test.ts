import { describe, expect, it } from 'vitest';
import type { Fork } from './chassis';
import { turned } from './physics/block-body';
import { gapBetween } from './physics/convex';
import { rectangleCorners, wallCorners } from './shapes';
import type { BlockHandle } from './shapes';
import { createToolRig, TEST_FORK, UP_MM } from './testing/tools';
import type { ToolRig } from './testing/tools';

/** How far the test robot's front is ahead of its axle, in mm. */
const FRONT_MM = 59;

interface ForkRig extends ToolRig {
  readonly fork: Fork;
  /** Raises or lowers the fork at 100 mm/s and waits a moment. */
  readonly lift: (toMm: number) => void;
}

/** A robot that looks along x from (2000, 2000), with its fork on the floor. */
function forkRig(): ForkRig {
  const rig = createToolRig();
  const fork = rig.robot.addFork(TEST_FORK);
  const lift = (toMm: number): void => {
    let now = fork.heightMm();
    while (now !== toMm) {
      now += Math.min(Math.max(toMm - now, -0.4), 0.4);
      fork.setHeightMm(now);
      rig.world.step();
    }
    rig.drive(0, 0, 0.1);
  };
  return { ...rig, fork, lift };
}

/** The same with a block of 50 mm over its plate, lifted. */
function lifted(): ForkRig & { readonly load: BlockHandle } {
  const rig = forkRig();
  const load = rig.block({ x: 2090, y: 2000 });
  rig.lift(UP_MM);
  return { ...rig, load };
}

describe('a fork on the floor', () => {
  it('slides under a block, which stays where it is until the robot itself meets it', () => {
    const { drive, robot, block } = forkRig();
    const ahead = block({ x: 2200, y: 2000 });
    drive(60, 60, 0.5);
    const start = robot.pose().xMm;
    expect(start + 120).toBeGreaterThan(2180); // the plate's tip is under it
    expect(ahead.pose()).toEqual({ xMm: 2200, yMm: 2000, headingRad: 0 });
    expect(robot.collisions()).toBe(0);
    drive(60, 60, 1.5);
    expect(ahead.pose().xMm - 25 - FRONT_MM - robot.pose().xMm).toBeLessThan(0.6);
    expect(ahead.pose().xMm).toBeGreaterThan(2250);
  });

  it('is stopped by a wall and by a fixed block', () => {
    const atWall = forkRig();
    atWall.world.addWall({ fromMm: { x: 2300, y: 1900 }, toMm: { x: 2300, y: 2100 }, thicknessMm: 10 });
    atWall.drive(80, 80, 3);
    expect(Math.abs(atWall.robot.pose().xMm + 120 - 2295)).toBeLessThan(0.6);
    expect(atWall.robot.collisions()).toBe(1);
    const atBlock = forkRig();
    atBlock.block({ x: 2300, y: 2000 }, 50, 0, true);
    atBlock.drive(80, 80, 3);
    expect(Math.abs(atBlock.robot.pose().xMm + 120 - 2275)).toBeLessThan(0.6);
  });

  it('lets a block lie when it is raised to 4 mm, which is not clear of the floor', () => {
    const { lift, fork, block, drive } = forkRig();
    const over = block({ x: 2090, y: 2000 });
    lift(4);
    expect(fork.isHolding()).toBe(false);
    drive(-60, -60, 1);
    expect(over.pose()).toEqual({ xMm: 2090, yMm: 2000, headingRad: 0 });
  });
});

describe('a raised fork', () => {
  it('lifts a block that stands with its middle above the plate', () => {
    const { fork, load, robot } = lifted();
    expect(fork.isHolding()).toBe(true);
    expect(load.isHeld()).toBe(true);
    expect(load.liftMm()).toBe(UP_MM);
    expect(load.pose()).toEqual({ xMm: 2090, yMm: 2000, headingRad: 0 });
    expect(robot.collisions()).toBe(0);
  });

  it('carries it as straight as without it and round a corner, and sets it down where it is', () => {
    const { fork, load, robot, drive, lift } = lifted();
    const empty = createToolRig();
    drive(60, 60, 2);
    empty.drive(60, 60, 2);
    expect(robot.pose()).toEqual(empty.robot.pose());
    while (robot.turnedRad() < Math.PI / 2) drive(-50, 50, 0.02);
    drive(0, 0, 0.5);
    const ahead = robot.toWorld({ x: 90, y: 0 });
    expect(load.pose().xMm).toBeCloseTo(ahead.x, 6);
    expect(load.pose().yMm).toBeCloseTo(ahead.y, 6);
    const above = load.pose();
    lift(0);
    expect(fork.isHolding()).toBe(false);
    expect(load.isHeld()).toBe(false);
    drive(-60, -60, 1.5);
    expect(Math.abs(load.pose().xMm - above.xMm)).toBeLessThan(1e-6);
    expect(Math.abs(load.pose().yMm - above.yMm)).toBeLessThan(1e-6);
    expect(robot.collisions()).toBe(0);
  });

  it('takes up two blocks of 20 mm beside each other', () => {
    const { block, lift } = forkRig();
    const blocks = [block({ x: 2100, y: 2011 }, 20), block({ x: 2100, y: 1989 }, 20)];
    lift(UP_MM);
    expect(blocks.map((one) => one.isHeld())).toEqual([true, true]);
  });

  it('leaves a block on the floor that stands over its edge, and neither throws it away nor is thrown', () => {
    const { block, lift, drive, robot, fork } = forkRig();
    const beside = block({ x: 2090, y: 2030 });
    lift(UP_MM);
    drive(0, 0, 2);
    expect(fork.isHolding()).toBe(false);
    expect(beside.pose()).toEqual({ xMm: 2090, yMm: 2030, headingRad: 0 });
    expect(robot.pose()).toEqual({ xMm: 2000, yMm: 2000, headingRad: 0 });
  });

  it('pushes the blocks it meets: only a lowered fork goes under one', () => {
    const { block, lift, drive, robot } = forkRig();
    lift(UP_MM);
    const ahead = block({ x: 2200, y: 2000 });
    drive(60, 60, 3);
    expect(ahead.pose().xMm - 25 - 120 - robot.pose().xMm).toBeGreaterThan(0);
    expect(ahead.pose().xMm).toBeGreaterThan(2400);
  });

  it('does not carry its load through a wall', () => {
    const { world, load, robot, drive } = lifted();
    world.addWall({ fromMm: { x: 2300, y: 1900 }, toMm: { x: 2300, y: 2100 }, thicknessMm: 10 });
    drive(150, 150, 3);
    expect(robot.pose().xMm + 120).toBeLessThan(2295.1);
    expect(load.pose().xMm + 25).toBeLessThan(2295.1);
    expect(robot.collisions()).toBe(1);
  });

  it('does not carry a load that juts out through a wall beside it', () => {
    const { world, robot, lift, block, drive } = forkRig();
    const wide = block({ x: 2090, y: 2020 }, 60);
    lift(UP_MM);
    expect(wide.isHeld()).toBe(true);
    const wall = { fromMm: { x: 2200, y: 2045 }, toMm: { x: 2200, y: 2200 }, thicknessMm: 10 };
    world.addWall(wall);
    // The wheels spin, and the robot turns about the end of the wall.
    for (let part = 0; part < 30; part++) {
      drive(150, 150, 0.1);
      const { xMm: x, yMm: y, headingRad: angle } = wide.pose();
      const outline = turned(rectangleCorners({ x: 60, y: 60 }), { x, y, angle });
      expect(gapBetween(outline, wallCorners(wall)).gap).toBeGreaterThan(-0.5);
    }
    expect(robot.collisions()).toBe(1);
  });

  it('gives its load to the hand, and takes what the hand puts on it', () => {
    const { fork, load, drive } = lifted();
    load.place({ xMm: 1500, yMm: 1500, headingRad: 0 });
    expect(fork.isHolding()).toBe(false);
    load.place({ xMm: 2095, yMm: 2005, headingRad: 0.3 });
    expect(fork.isHolding()).toBe(true);
    drive(-60, -60, 1);
    expect(load.pose().xMm).toBeLessThan(1950);
  });

  it('sets its load down when it is taken off', () => {
    const { fork, load, drive } = lifted();
    fork.remove();
    fork.remove();
    expect(load.isHeld()).toBe(false);
    expect(load.liftMm()).toBe(0);
    drive(-60, -60, 1);
    expect(load.pose()).toEqual({ xMm: 2090, yMm: 2000, headingRad: 0 });
  });
});
