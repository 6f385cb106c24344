import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import type { ChassisPart } from './chassis';
import { createToolRig, OPEN_RAD, TEST_CLAW, TEST_FORK } from './testing/tools';
import type { ToolRig } from './testing/tools';

/** A half of a bumper, 6 mm deep, ahead of the test robot's front at 59 mm. */
const half = (fromY: number, toY: number): Vec[] => [
  { x: 60, y: fromY },
  { x: 66, y: fromY },
  { x: 66, y: toY },
  { x: 60, y: toY },
];

interface BumperRig extends ToolRig {
  readonly left: ChassisPart;
  readonly right: ChassisPart;
  /** True if left and right are pressed. */
  readonly pressed: () => boolean[];
}

function bumperRig(): BumperRig {
  const rig = createToolRig();
  const left = rig.robot.addPart(half(1, 40));
  const right = rig.robot.addPart(half(-40, -1));
  return { ...rig, left, right, pressed: () => [left.isTouched(), right.isTouched()] };
}

const wallAhead = (rig: ToolRig, fromY: number, toY: number): void =>
  rig.world.addWall({ fromMm: { x: 2150, y: 2000 + fromY }, toMm: { x: 2150, y: 2000 + toY }, thicknessMm: 10 });

describe('a bumper of two halves', () => {
  it.each([
    ['neither', 200, 300, [false, false]],
    ['the left half', 10, 200, [true, false]],
    ['the right half', -200, -10, [false, true]],
    ['both', -200, 200, [true, true]],
  ])('of a robot before a wall is pressed on: %s', (_, fromY, toY, expected) => {
    const rig = bumperRig();
    wallAhead(rig, fromY, toY);
    expect(rig.pressed()).toEqual([false, false]);
    rig.drive(60, 60, 0.8);
    expect(rig.pressed()).toEqual(expected);
  });

  it('stops the robot 66 mm before its axle, and counts one collision', () => {
    const rig = bumperRig();
    wallAhead(rig, -200, 200);
    rig.drive(60, 60, 2);
    expect(Math.abs(rig.robot.pose().xMm + 66 - 2145)).toBeLessThan(0.5);
    expect(rig.robot.collisions()).toBe(1);
  });

  it.each([40, 100, 255])('stays pressed while the robot pushes at byte %i, and is free 1 mm away', (byte) => {
    const rig = bumperRig();
    wallAhead(rig, -200, 200);
    rig.drive(byte, byte, 1.5);
    for (let step = 0; step < 250; step++) {
      rig.drive(byte, byte, 0.004);
      expect(rig.pressed()).toEqual([true, true]);
    }
    const at = rig.robot.pose().xMm;
    while (rig.robot.pose().xMm > at - 1) rig.drive(-byte, -byte, 0.004);
    expect(rig.pressed()).toEqual([false, false]);
  });

  it('is pressed by the edge of the arena and by a block', () => {
    const atEdge = bumperRig();
    atEdge.robot.place({ xMm: 3900, yMm: 2000, headingRad: 0 });
    atEdge.drive(60, 60, 1);
    expect(atEdge.pressed()).toEqual([true, true]);
    const atBlock = bumperRig();
    atBlock.block({ x: 2100, y: 1975 }, 40);
    atBlock.drive(60, 60, 0.5);
    expect(atBlock.pressed()).toEqual([false, true]);
  });

  it('is free again when the hand lifts the robot away', () => {
    const rig = bumperRig();
    wallAhead(rig, -200, 200);
    rig.drive(60, 60, 1);
    rig.robot.place({ xMm: 1000, yMm: 1000, headingRad: 0 });
    rig.drive(0, 0, 0.004);
    expect(rig.pressed()).toEqual([false, false]);
  });
});

describe('a part of a body', () => {
  it('changes nothing in how the robot drives, to the last bit', () => {
    const rig = bumperRig();
    const bare = createToolRig();
    for (const { drive } of [rig, bare]) {
      drive(60, 90, 2);
      drive(-40, 30, 1);
    }
    expect(rig.robot.pose()).toEqual(bare.robot.pose());
  });

  it('touches nothing any more once it is taken off; the robot drives on as it was built', () => {
    const rig = bumperRig();
    wallAhead(rig, -200, 200);
    rig.drive(60, 60, 1);
    rig.left.remove();
    rig.right.remove();
    rig.right.remove();
    expect(rig.pressed()).toEqual([false, false]);
    rig.drive(60, 60, 1);
    expect(rig.pressed()).toEqual([false, false]);
    expect(Math.abs(rig.robot.pose().xMm + 59 - 2145)).toBeLessThan(0.5);
  });

  it('can be taken off at full speed without a jolt', () => {
    const rig = bumperRig();
    const bare = createToolRig();
    for (const { drive } of [rig, bare]) drive(100, 60, 1);
    rig.left.remove();
    rig.right.remove();
    for (const { drive } of [rig, bare]) drive(100, 60, 1);
    expect(rig.robot.pose()).toEqual(bare.robot.pose());
  });

  it('is seen by the distance sensors of others and not by those of its robot', () => {
    const rig = bumperRig();
    const cone = { openingRad: 0.1, rangeMm: 1000 };
    const from = { x: 2166, y: 2010 };
    expect(rig.world.distanceCone(from, Math.PI, cone).distanceMm).toBeCloseTo(100, 6);
    expect(rig.world.distanceCone(from, Math.PI, cone, rig.robot).distanceMm).toBe(Infinity);
    rig.left.remove();
    rig.right.remove();
    expect(rig.world.distanceCone(from, Math.PI, cone).distanceMm).toBeCloseTo(107, 6);
  });
});

describe('a part that is put where a wall stands', () => {
  const deep: readonly Vec[] = [
    { x: 60, y: -30 },
    { x: 80, y: -30 },
    { x: 80, y: 30 },
    { x: 60, y: 30 },
  ];
  /** A robot that has driven with its body, 59 mm ahead of the axle, to a wall whose face is at x = 2145. */
  const atWall = (thicknessMm: number): ToolRig => {
    const rig = createToolRig();
    const x = 2145 + thicknessMm / 2;
    rig.world.addWall({ fromMm: { x, y: 1800 }, toMm: { x, y: 2200 }, thicknessMm });
    rig.drive(60, 60, 2);
    return rig;
  };

  it.each([5, 10, 20, 40])('%f mm thick is pressed at once and lets the robot back off', (thicknessMm) => {
    const rig = atWall(thicknessMm);
    const part = rig.robot.addPart(deep);
    expect(part.isTouched()).toBe(true);
    rig.drive(0, 0, 0.5);
    expect(part.isTouched()).toBe(true);
    const { xMm } = rig.robot.pose();
    expect(xMm).toBeCloseTo(2145 - 59, 0);
    rig.drive(-60, -60, 1);
    expect(rig.robot.pose().xMm).toBeLessThan(xMm - 100);
    expect(part.isTouched()).toBe(false);
  });

  it('stops the robot there again once it was free, also at full speed', () => {
    const rig = atWall(20);
    const part = rig.robot.addPart(deep);
    rig.drive(-60, -60, 1);
    rig.drive(255, 255, 2);
    expect(part.isTouched()).toBe(true);
    expect(Math.abs(rig.robot.pose().xMm + 80 - 2145)).toBeLessThan(0.5);
  });

  it('is let out again by the hand that moves the robot, too', () => {
    const rig = atWall(20);
    rig.drive(-60, -60, 1);
    rig.robot.addPart(deep);
    rig.robot.place({ xMm: 2145 - 60, yMm: 2000, headingRad: 0 });
    rig.drive(-60, -60, 1);
    expect(rig.robot.pose().xMm).toBeLessThan(2145 - 160);
  });

  it.each([
    ['claw', (rig: ToolRig) => rig.robot.addGripper(TEST_CLAW).setSwing(OPEN_RAD)],
    ['fork', (rig: ToolRig) => rig.robot.addFork(TEST_FORK)],
  ])('is no trap as a %s either', (_, add) => {
    const rig = atWall(20);
    add(rig);
    rig.drive(-60, -60, 1);
    expect(rig.robot.pose().xMm).toBeLessThan(2145 - 159);
  });
});
