import { describe, expect, it } from 'vitest';
import type { Pose, Vec } from '#core/geometry';
import type { Gripper } from './chassis';
import { turned } from './physics/block-body';
import { gapBetween } from './physics/convex';
import type { BlockHandle } from './shapes';
import { createToolRig, OPEN_RAD, TEST_CLAW } from './testing/tools';
import type { ToolRig } from './testing/tools';

/** How far the test robot's front is ahead of its axle, in mm. */
const FRONT_MM = 59;

/** The robot's place at the start. */
const HERE: Pose = { xMm: 2000, yMm: 2000, headingRad: 0 };

interface ClawRig extends ToolRig {
  readonly claw: Gripper;
}

/** A robot that looks along x from (2000, 2000), with its claw open. */
function clawRig(): ClawRig {
  const rig = createToolRig();
  const claw = rig.robot.addGripper(TEST_CLAW);
  claw.setSwing(OPEN_RAD);
  return { ...rig, claw };
}

/** The same with a block before it, and the claw closed on it. */
function gripped(sideMm = 50): ClawRig & { readonly held: BlockHandle } {
  const rig = clawRig();
  const held = rig.block({ x: 2000 + FRONT_MM + 22 + sideMm / 2, y: 2000 }, sideMm);
  rig.swing(rig.claw, 0);
  return { ...rig, held };
}

/** A block's pose in the robot's frame. */
function inRobotFrame(robot: Pose, block: Pose): Pose {
  const x = block.xMm - robot.xMm;
  const y = block.yMm - robot.yMm;
  const cos = Math.cos(robot.headingRad);
  const sin = Math.sin(robot.headingRad);
  return { xMm: x * cos + y * sin, yMm: y * cos - x * sin, headingRad: block.headingRad - robot.headingRad };
}

function expectSamePlace(a: Pose, b: Pose, mm: number): void {
  expect(Math.abs(a.xMm - b.xMm)).toBeLessThan(mm);
  expect(Math.abs(a.yMm - b.yMm)).toBeLessThan(mm);
  expect(Math.abs(a.headingRad - b.headingRad)).toBeLessThan(0.001);
}

const square = (sideMm: number, { xMm: x, yMm: y, headingRad: angle }: Pose): Vec[] => {
  const half = sideMm / 2;
  const corner = (sx: number, sy: number): Vec => ({ x: sx * half, y: sy * half });
  return turned([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], { x, y, angle });
};

describe('a gripper', () => {
  it('closes fully on nothing, and opens again', () => {
    const { claw, swing } = clawRig();
    swing(claw, 0);
    expect(claw.swingRad()).toBe(0);
    expect(claw.isHolding()).toBe(false);
    swing(claw, OPEN_RAD);
    expect(claw.swingRad()).toBe(OPEN_RAD);
  });

  it('swings no faster than 10 rad/s, whatever it is told', () => {
    const { claw, world } = clawRig();
    claw.setSwing(0);
    world.step();
    expect(claw.swingRad()).toBeCloseTo(OPEN_RAD - 0.04, 9);
  });

  it('takes an angle that is no number, or below 0, for closed', () => {
    const { claw, swing, block } = clawRig();
    const ahead = block({ x: 2106, y: 2000 });
    swing(claw, 0);
    claw.setSwing(NaN);
    claw.setSwing(-1);
    expect(claw.isHolding()).toBe(true);
    expect(ahead.pose().xMm).toBeCloseTo(2106, 0);
  });

  it.each([30, 35, 40, 45, 50, 55, 60])('holds a block of %i mm; the robot stands still meanwhile', (sideMm) => {
    const { claw, held, robot } = gripped(sideMm);
    expect(claw.isHolding()).toBe(true);
    expect(held.isHeld()).toBe(true);
    expect(held.liftMm()).toBe(0);
    expectSamePlace(robot.pose(), HERE, 0.001);
    expect(Math.abs(held.pose().yMm - 2000)).toBeLessThan(0.5);
  });

  it('carries a block of 50 mm for 30 cm and as straight as without it, turns it by 90° and leaves it there within 1 mm', () => {
    const { claw, held, robot, drive, swing } = gripped();
    const start = inRobotFrame(robot.pose(), held.pose());
    const empty = createToolRig();
    drive(60, 60, 1.5);
    empty.drive(60, 60, 1.5);
    expect(robot.pose()).toEqual(empty.robot.pose());
    expect(robot.pose().xMm).toBeGreaterThan(2300);
    while (robot.turnedRad() < Math.PI / 2) drive(-50, 50, 0.02);
    drive(0, 0, 0.5);
    expectSamePlace(inRobotFrame(robot.pose(), held.pose()), start, 1e-6);
    const down = held.pose();
    swing(claw, OPEN_RAD);
    expect(claw.isHolding()).toBe(false);
    drive(-60, -60, 1);
    expectSamePlace(held.pose(), down, 1);
    expect(robot.pose().yMm).toBeLessThan(1850);
    expect(robot.collisions()).toBe(0);
  });

  it('lets go as soon as the jaws are told to be as wide as they are, not before', () => {
    const { claw, held, world } = gripped();
    const wide = claw.swingRad();
    claw.setSwing(wide - 0.001);
    world.step();
    expect(held.isHeld()).toBe(true);
    claw.setSwing(wide);
    world.step();
    expect(held.isHeld()).toBe(false);
    expect(claw.isHolding()).toBe(false);
  });

  it('takes a block along backwards, too', () => {
    const { held, robot, drive } = gripped();
    const start = inRobotFrame(robot.pose(), held.pose());
    drive(-100, -100, 2);
    expect(robot.pose().xMm).toBeLessThan(1500);
    expectSamePlace(inRobotFrame(robot.pose(), held.pose()), start, 1e-6);
  });

  it.each([
    [8, 0],
    [-12, 0],
    [0, 0.4],
    [5, 0.785],
  ])('moves a block that lies %i mm off its middle, turned by %d rad, and holds it', (offMm, angleRad) => {
    const { claw, swing, block, robot } = clawRig();
    const ahead = block({ x: 2110, y: 2000 + offMm }, 40, angleRad);
    swing(claw, 0);
    expect(claw.isHolding()).toBe(true);
    expect(Math.abs(ahead.pose().yMm - 2000)).toBeLessThan(Math.abs(offMm) + 3);
    expectSamePlace(robot.pose(), HERE, 0.001);
  });

  it('holds two blocks of 25 mm that lie side by side', () => {
    const { claw, swing, block, drive } = clawRig();
    const left = block({ x: 2106, y: 2013 }, 25);
    const right = block({ x: 2106, y: 1987 }, 25);
    swing(claw, 0);
    expect([left.isHeld(), right.isHeld()]).toEqual([true, true]);
    drive(-60, -60, 1);
    expect(left.pose().xMm).toBeLessThan(1950);
    expect(right.pose().xMm).toBeLessThan(1950);
  });
});

describe('a gripper that something stops', () => {
  it('closes on a fixed block and stays there; nothing is held, nothing moves', () => {
    const { claw, swing, block, robot, drive } = clawRig();
    const post = block({ x: 2106, y: 2000 }, 50, 0, true);
    swing(claw, 0);
    const stopped = claw.swingRad();
    expect(stopped).toBeGreaterThan(0.3);
    expect(claw.isHolding()).toBe(false);
    expect(post.isHeld()).toBe(false);
    drive(0, 0, 2);
    expect(claw.swingRad()).toBe(stopped);
    expectSamePlace(robot.pose(), HERE, 0.001);
    swing(claw, OPEN_RAD);
    expect(claw.swingRad()).toBe(OPEN_RAD);
  });

  it('opens until a jaw meets a wall beside it, and goes on when the robot has driven away', () => {
    const { claw, swing, world, robot, drive } = clawRig();
    swing(claw, 0);
    world.addWall({ fromMm: { x: 2065, y: 2041 }, toMm: { x: 2200, y: 2041 }, thicknessMm: 10 });
    swing(claw, OPEN_RAD);
    expect(claw.swingRad()).toBeGreaterThan(0.3);
    expect(claw.swingRad()).toBeLessThan(OPEN_RAD - 0.05);
    expectSamePlace(robot.pose(), HERE, 0.001);
    drive(-60, -60, 1);
    expect(claw.swingRad()).toBe(OPEN_RAD);
  });

  it('pushes a block aside with one jaw, and a second one behind it', () => {
    const { claw, swing, block, robot, drive } = clawRig();
    swing(claw, 0);
    const near = block({ x: 2105, y: 2052 }, 40);
    const far = block({ x: 2105, y: 2094 }, 40);
    swing(claw, OPEN_RAD);
    expect(claw.swingRad()).toBe(OPEN_RAD);
    expect(near.pose().yMm).toBeGreaterThan(2059);
    expect(far.pose().yMm).toBeGreaterThan(2099);
    const still = [near.pose().yMm, far.pose().yMm];
    drive(0, 0, 2);
    expect(near.pose().yMm).toBeCloseTo(still[0] ?? 0, 0);
    expect(far.pose().yMm).toBeCloseTo(still[1] ?? 0, 0);
    expectSamePlace(robot.pose(), HERE, 0.1);
  });

  it('does not push a block of 200 mm, whose friction is 1.9 N, with a force of 1 N', () => {
    const rig = createToolRig();
    const weak = rig.robot.addGripper({ ...TEST_CLAW, forceN: 1 });
    weak.setSwing(0);
    const heavy = rig.block({ x: 2166, y: 2133 }, 200);
    rig.swing(weak, OPEN_RAD);
    expect(weak.swingRad()).toBeLessThan(OPEN_RAD);
    expectSamePlace(heavy.pose(), { xMm: 2166, yMm: 2133, headingRad: 0 }, 0.001);
  });
});

describe('a held block', () => {
  it('does not pass through a wall: the robot stalls', () => {
    const { held, robot, drive, world } = gripped();
    world.addWall({ fromMm: { x: 2300, y: 1800 }, toMm: { x: 2300, y: 2200 }, thicknessMm: 10 });
    drive(150, 150, 3);
    const front = Math.max(...square(50, held.pose()).map(({ x }) => x));
    expect(front).toBeGreaterThan(2294);
    expect(front).toBeLessThan(2295.2);
    const stopped = robot.pose().xMm;
    drive(150, 150, 2);
    expect(Math.abs(robot.pose().xMm - stopped)).toBeLessThan(0.1);
    expect(robot.collisions()).toBe(1);
  });

  it('stops the robot from turning at a wall beside it', () => {
    const { held, drive, world } = gripped();
    world.addWall({ fromMm: { x: 2000, y: 2060 }, toMm: { x: 2300, y: 2060 }, thicknessMm: 10 });
    drive(-60, 60, 2);
    expect(Math.max(...square(50, held.pose()).map(({ y }) => y))).toBeLessThan(2056);
    expect(held.isHeld()).toBe(true);
  });

  it('pushes other blocks before it', () => {
    const { held, drive, block } = gripped();
    const other = block({ x: 2160, y: 2000 });
    drive(60, 60, 2);
    expect(other.pose().xMm).toBeGreaterThan(2400);
    expect(gapBetween(square(50, held.pose()), square(50, other.pose())).gap).toBeGreaterThan(0);
  });

  it('is seen by a distance sensor where it is', () => {
    const { robot, drive, world } = gripped();
    drive(60, 60, 2);
    const look = (): number => {
      const { x, y } = robot.toWorld({ x: FRONT_MM, y: 0 });
      return world.distanceCone({ x, y }, robot.pose().headingRad, { openingRad: 0.2, rangeMm: 1000 }, robot)
        .distanceMm;
    };
    expect(look()).toBeGreaterThan(15);
    expect(look()).toBeLessThan(25);
  });

  it('comes along when the hand moves the robot', () => {
    const { held, robot } = gripped();
    const start = inRobotFrame(robot.pose(), held.pose());
    robot.place({ xMm: 500, yMm: 700, headingRad: 1.5 });
    expectSamePlace(inRobotFrame(robot.pose(), held.pose()), start, 1e-6);
  });

  it('is let go when the hand takes it away, and the jaws close', () => {
    const { held, claw, drive } = gripped();
    held.place({ xMm: 1000, yMm: 1000, headingRad: 0.5 });
    expect(claw.isHolding()).toBe(false);
    drive(0, 0, 1);
    expect(claw.swingRad()).toBe(0);
    drive(60, 60, 1);
    expect(held.pose()).toEqual({ xMm: 1000, yMm: 1000, headingRad: 0.5 });
  });

  it('stays where it is when the gripper is taken off, and can be driven through where the jaws were', () => {
    const { held, claw, drive, robot } = gripped();
    const before = held.pose();
    claw.remove();
    claw.remove();
    expect(held.isHeld()).toBe(false);
    drive(-60, -60, 1);
    expectSamePlace(held.pose(), before, 1e-6);
    const bare = createToolRig();
    bare.drive(-60, -60, 1);
    expect(robot.pose()).toEqual(bare.robot.pose());
  });
});

describe('two grippers on one robot', () => {
  it('hold a block each and let go of their own', () => {
    const rig = clawRig();
    // A second one at the rear: its jaws point forward too, but far to the side.
    const other = rig.robot.addGripper({ ...TEST_CLAW, hingeMm: { x: -150, y: 15 } });
    other.setSwing(OPEN_RAD);
    const front = rig.block({ x: 2106, y: 2000 });
    const rear = rig.block({ x: 2000 - 150 + 36, y: 2000 });
    rig.swing(rig.claw, 0);
    rig.swing(other, 0);
    expect([front.isHeld(), rear.isHeld()]).toEqual([true, true]);
    rig.swing(rig.claw, OPEN_RAD);
    expect([front.isHeld(), rear.isHeld()]).toEqual([false, true]);
    expect(other.isHolding()).toBe(true);
  });
});
