import { describe, expect, it } from 'vitest';
import { createRig } from './testing/rig';
import type { World } from './world';

const FRONT_MM = 59;

/** A barrier 300 mm ahead of the robot's axle, and the beam that looks for it. */
function withBarrier() {
  const rig = createRig();
  const barrier = rig.world.addBarrier({
    ...{ id: 'gate', fromMm: { x: 2305, y: 1800 }, toMm: { x: 2305, y: 2200 } },
    ...{ thicknessMm: 10, heightMm: 100 },
  });
  return { ...rig, barrier };
}

const ahead = (world: World, robot: ReturnType<typeof createRig>['robot']): number =>
  world.distanceCone({ x: 2000, y: 2000 }, 0, { openingRad: 0.2, rangeMm: 1000 }, robot).distanceMm;

describe('a barrier', () => {
  it('is no obstacle while it is open, neither for bodies nor for beams', () => {
    const { world, robot, drive } = withBarrier();
    expect(ahead(world, robot)).toBe(Infinity);
    drive(150, 150, 4);
    expect(robot.pose().xMm).toBeGreaterThan(2400);
    expect(robot.collisions()).toBe(0);
  });

  it('stops a robot while it is closed, is felt and seen under its name, and lets it on once it opens', () => {
    const { world, robot, barrier, drive } = withBarrier();
    barrier.set(false);
    expect(ahead(world, robot)).toBeCloseTo(300, 6);
    drive(150, 150, 4);
    expect(robot.pose().xMm).toBeCloseTo(2300 - FRONT_MM, 0);
    expect([robot.collisions(), robot.touching()]).toEqual([1, ['gate']]);
    barrier.set(true);
    drive(150, 150, 2);
    expect(robot.pose().xMm).toBeGreaterThan(2400);
    expect(robot.touching()).toEqual([]);
  });

  it('closes only when nothing that moves stands in it any more', () => {
    const { world, robot, barrier, drive } = withBarrier();
    const block = world.addBlock({
      ...{ atMm: { x: 2305, y: 2100 }, sizeMm: { x: 50, y: 50 } },
      ...{ angleRad: 0, fixed: false },
    });
    barrier.set(false);
    drive(0, 0, 0.1);
    expect(barrier.isOpen).toBe(true);
    block.place({ xMm: 500, yMm: 500, headingRad: 0 });
    robot.place({ xMm: 2305, yMm: 2000, headingRad: 0 });
    drive(0, 0, 0.1);
    expect(barrier.isOpen).toBe(true);
    drive(150, 150, 1);
    expect(barrier.isOpen).toBe(false);
  });

  it('throws a shadow only while it is closed', () => {
    const { world, barrier } = withBarrier();
    world.light.setRoom(0);
    world.light.addLamp({ atMm: { x: 2400, y: 2000 }, heightMm: 100, candela: 40, on: true });
    const eye = { atMm: { x: 2250, y: 2000 }, facing: { x: 0, y: 0, z: 1 } };
    expect(world.luxAt(eye)).toBeGreaterThan(0);
    barrier.set(false);
    expect(world.luxAt(eye)).toBe(0);
  });
});
