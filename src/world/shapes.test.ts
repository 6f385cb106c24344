import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import type { BlockShape } from './shapes';
import { STEP_S } from './step';
import { createRig, testChassis } from './testing/rig';
import type { World } from './world';

const can = (atMm: Vec, fixed = false): BlockShape => ({
  ...{ atMm, sizeMm: { x: 66, y: 66 }, angleRad: 0, isRound: true, fixed, id: 'can' },
});
/** Each of its sides 60 mm from left to right; its right angle at the lower left. */
const triangle: readonly Vec[] = [
  { x: -30, y: -30 },
  { x: 30, y: -30 },
  { x: -30, y: 30 },
];
/** An L of two squares of 40 mm beside each other and one above the left of them. */
const ell: readonly (readonly Vec[])[] = [
  [{ x: -40, y: -40 }, { x: 40, y: -40 }, { x: 40, y: 0 }, { x: -40, y: 0 }], // prettier-ignore
  [{ x: -40, y: 0 }, { x: 0, y: 0 }, { x: 0, y: 40 }, { x: -40, y: 40 }], // prettier-ignore
];
const CONE = { openingRad: 0.5, rangeMm: 4000 };
const ahead = (world: World, from: Vec, headingRad = 0): number =>
  world.distanceCone(from, headingRad, CONE).distanceMm;

describe('a can', () => {
  it('stays on its line when pushed straight by a flat front, and turns no robot', () => {
    const { world, robot, drive } = createRig();
    const block = world.addBlock(can({ x: 2150, y: 2000 }));
    drive(150, 150, 3);
    const { xMm, yMm } = block.pose();
    expect(xMm).toBeGreaterThan(2500);
    expect(Math.abs(yMm - 2000)).toBeLessThan(1);
    expect(Math.abs(robot.turnedRad())).toBeLessThan(0.01);
    expect(robot.touching()).toEqual(['can']);
  });

  it('lies still again when the robot backs off', () => {
    const { world, drive } = createRig();
    const block = world.addBlock(can({ x: 2150, y: 2000 }));
    drive(150, 150, 1);
    drive(-150, -150, 1);
    const before = block.pose();
    drive(-150, -150, 1);
    expect(block.pose()).toEqual(before);
  });

  it('weighs as much as a block of the same area', () => {
    const side = 33 * Math.sqrt(Math.PI);
    const way = (shape: BlockShape): number => {
      const { world, drive } = createRig({ xMm: 2000, yMm: 2000, headingRad: 0 }, testChassis());
      const block = world.addBlock(shape);
      drive(120, 120, 2);
      return block.pose().xMm - shape.atMm.x;
    };
    const square = { ...can({ x: 2200, y: 2000 }), isRound: false, sizeMm: { x: side, y: side } };
    expect(Math.abs(way(can({ x: 2200, y: 2000 })) - way(square))).toBeLessThan(5);
  });
});

describe('the ultrasonic cone', () => {
  it('meets a round pole where it is nearest: its middle less its radius, to 1 mm, from all sides', () => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    world.addBlock({ ...can({ x: 2000, y: 2000 }, true), sizeMm: { x: 50, y: 50 } });
    for (let angle = 0; angle < 6.28; angle += 0.1) {
      const from = { x: 2000 - 500 * Math.cos(angle), y: 2000 - 500 * Math.sin(angle) };
      expect(Math.abs(ahead(world, from, angle) - 475)).toBeLessThan(0.001);
    }
  });

  it('meets the edge of a pole that stands half beside it on its own edge', () => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    world.addBlock({ ...can({ x: 1000, y: 1000 }, true), sizeMm: { x: 400, y: 400 } });
    // The edge of the cone, 0.25 rad to the left of +x, passes the middle at a known distance.
    const from = { x: 400, y: 1000 - 600 * Math.tan(0.25) - 100 };
    const [x, y] = [1000 - from.x, 1000 - from.y];
    const along = x * Math.cos(0.25) + y * Math.sin(0.25);
    const across = y * Math.cos(0.25) - x * Math.sin(0.25);
    expect(ahead(world, from)).toBeCloseTo(along - Math.sqrt(200 * 200 - across * across), 3);
  });

  it('hears a pole by rays, too, when it is turned away from nothing', () => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    world.addBlock({ ...can({ x: 1000, y: 1000 }, true), sizeMm: { x: 50, y: 50 } });
    const heard = world.distanceCone({ x: 700, y: 1000 }, 0, { ...CONE, incidenceLimitRad: 0.4 });
    expect(Math.abs(heard.distanceMm - 275)).toBeLessThan(1);
  });

  it.each([10, 22.5, 37, 63.4])('meets the nearest corner or face of a block that is turned by %d°', (deg) => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    const angleRad = (deg * Math.PI) / 180;
    world.addBlock({ ...can({ x: 1000, y: 1000 }, true), isRound: false, sizeMm: { x: 60, y: 40 }, angleRad });
    const reach = Math.abs(30 * Math.cos(angleRad)) + Math.abs(20 * Math.sin(angleRad));
    const { distanceMm, hitMm } = world.distanceCone({ x: 500, y: 1000 }, 0, { openingRad: 0.5, rangeMm: 4000 });
    const corner = { x: 1000 - reach, y: 1000 + (-30 * Math.sin(angleRad) + 20 * Math.cos(angleRad)) };
    const toCorner = Math.hypot(corner.x - 500, corner.y - 1000);
    expect(distanceMm).toBeLessThanOrEqual(toCorner + 1e-6);
    expect(distanceMm).toBeGreaterThan(500 - reach - 1e-6);
    expect(Math.hypot((hitMm?.x ?? 0) - 500, (hitMm?.y ?? 0) - 1000)).toBeCloseTo(distanceMm, 9);
  });

  it('looks into the hollow of an L, and meets its arms from outside', () => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    world.addBlock({ ...can({ x: 1000, y: 1000 }, true), isRound: false, sizeMm: { x: 80, y: 80 }, partsMm: ell });
    const beam = { openingRad: 0.02, rangeMm: 4000 };
    expect(world.distanceCone({ x: 1500, y: 1020 }, Math.PI, beam).distanceMm).toBeCloseTo(500, 6);
    expect(world.distanceCone({ x: 1500, y: 980 }, Math.PI, beam).distanceMm).toBeCloseTo(460, 6);
    expect(world.distanceCone({ x: 990, y: 990 }, 0, beam).distanceMm).toBe(0);
  });
});

describe('a polygon', () => {
  it('stands where it was put, and turns about the middle of its rectangle', () => {
    const { world } = createRig();
    const shape = { ...can({ x: 1000, y: 1000 }), isRound: false, sizeMm: { x: 60, y: 60 }, partsMm: [triangle] };
    const block = world.addBlock(shape);
    expect(block.pose().xMm).toBeCloseTo(1000, 9);
    expect(block.pose().yMm).toBeCloseTo(1000, 9);
    block.place({ xMm: 1200, yMm: 1300, headingRad: 1 });
    expect(block.pose().xMm).toBeCloseTo(1200, 9);
    expect(block.pose().yMm).toBeCloseTo(1300, 9);
    expect(ahead(world, { x: 1200, y: 1300 })).toBe(0);
  });

  it('is one thing to bump into, however many parts it has', () => {
    const { world, robot, drive } = createRig({ xMm: 2000, yMm: 2000, headingRad: 0 });
    world.addBlock({ ...can({ x: 2150, y: 2000 }, true), isRound: false, sizeMm: { x: 80, y: 80 }, partsMm: ell.map((part) => part.map(({ x, y }) => ({ x: -x, y: -y }))) }); // prettier-ignore
    drive(150, 150, 2);
    expect(robot.touching()).toEqual(['can']);
    expect(robot.collisions()).toBe(1);
    expect(robot.pose().xMm).toBeLessThan(2052);
  });

  it('is pushed and turned when it is met beside the middle of its area', () => {
    const { world, drive } = createRig();
    const block = world.addBlock({ ...can({ x: 2130, y: 2000 }), isRound: false, sizeMm: { x: 60, y: 60 }, partsMm: [triangle] }); // prettier-ignore
    drive(150, 150, 2);
    expect(block.pose().xMm).toBeGreaterThan(2300);
    expect(Number.isFinite(block.pose().headingRad)).toBe(true);
  });
});

describe('a round mover', () => {
  it('pushes a can before it like one of the hand', () => {
    const { world } = createRig({ xMm: 100, yMm: 100, headingRad: 0 });
    world.addMover({
      ...{ sizeMm: { x: 60, y: 60 }, angleRad: 0, isRound: true, speedMmPerS: 100, spinRadPerS: 0 },
      goes: {
        stops: [
          { atMm: { x: 1000, y: 1000 }, waitS: 0 },
          { atMm: { x: 1400, y: 1000 }, waitS: 0 },
        ],
        ...{ loops: false, phaseS: 0 },
      },
    });
    const block = world.addBlock(can({ x: 1100, y: 1000 }));
    for (let step = 0; step < 2 / STEP_S; step++) world.step();
    expect(block.pose().xMm).toBeGreaterThan(1255);
    expect(Math.abs(block.pose().yMm - 1000)).toBeLessThan(2);
  });
});
