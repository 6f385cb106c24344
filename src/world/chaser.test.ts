import { describe, expect, it } from 'vitest';
import type { Pose, Vec } from '#core/geometry';
import type { Chase, MoverHandle, MoverShape } from './shapes';
import { STEP_S } from './step';
import { createRig, hashOf, testChassis } from './testing/rig';
import type { World } from './world';

const after = (x: number, y: number, more: Partial<Chase & MoverShape> = {}): MoverShape => ({
  ...{ id: 'foe', sizeMm: { x: 60, y: 60 }, angleRad: 0, speedMmPerS: 100, spinRadPerS: 0, ...more },
  goes: {
    homeMm: { x, y },
    reachMm: more.reachMm ?? Infinity,
    returns: more.returns ?? false,
    wants: more.wants ?? null,
  },
});

const wait = (world: World, seconds: number): void => {
  for (let step = 0; step < Math.round(seconds / STEP_S); step++) world.step();
};

const placeOf = (foe: MoverHandle): Vec => ({ x: foe.pose().xMm, y: foe.pose().yMm });

const arena = (x: number, y: number, size = { widthMm: 1200, heightMm: 900 }) =>
  createRig({ xMm: x, yMm: y, headingRad: 0 }, testChassis(), size);

const numbersOf = ({ xMm, yMm, headingRad }: Pose): number[] => [xMm, yMm, headingRad];

/** Wants robots of which a part is right of x = 600. */
const rightHalf = (body: readonly (readonly Vec[])[]): boolean => body.flat().some(({ x }) => x > 600);

describe('an obstacle that chases', () => {
  it('comes straight to a robot at its speed: 100 mm/s, after a start within 25 ms', () => {
    const { world } = arena(900, 450);
    const foe = world.addMover(after(100, 450));
    wait(world, 2);
    expect(placeOf(foe).x).toBeGreaterThan(298);
    expect(placeOf(foe).x).toBeLessThanOrEqual(300);
    expect(placeOf(foe).y).toBeCloseTo(450, 9);
  });

  it('touches the robot and shoves it although its motors brake', () => {
    const { world, robot } = arena(500, 450);
    world.addMover(after(100, 450));
    wait(world, 6);
    expect(robot.touching()).toContain('foe');
    expect(robot.pose().xMm).toBeGreaterThan(510);
  });

  it('ends at a wall between it and the robot, and does not pass through', () => {
    const { world } = arena(900, 450);
    world.addWall({ fromMm: { x: 600, y: 100 }, toMm: { x: 600, y: 800 }, thicknessMm: 10 });
    const foe = world.addMover(after(200, 450, { speedMmPerS: 500 }));
    wait(world, 20);
    expect(placeOf(foe).x).toBeGreaterThan(564.5);
    expect(placeOf(foe).x).toBeLessThan(565.5); // wall at 595, half a box of 60
    expect(placeOf(foe).y).toBeCloseTo(450, 6);
  });

  it('slides along a wall, past its end', () => {
    const { world, robot } = arena(900, 300);
    world.addWall({ fromMm: { x: 600, y: 400 }, toMm: { x: 600, y: 900 }, thicknessMm: 10 });
    const foe = world.addMover(after(400, 600));
    wait(world, 12);
    expect(placeOf(foe).x).toBeGreaterThan(700);
    expect(robot.touching()).toContain('foe');
  });

  it('is stopped by a fixed block and pushes a loose one', () => {
    const { world } = arena(1000, 450);
    const at = { x: 500, y: 450 };
    const loose = world.addBlock({ atMm: at, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false });
    world.addBlock({ atMm: { x: 700, y: 450 }, sizeMm: { x: 50, y: 200 }, angleRad: 0, fixed: true });
    const foe = world.addMover(after(200, 450));
    wait(world, 8);
    expect(loose.pose().xMm).toBeCloseTo(650, 0);
    expect(placeOf(foe).x).toBeGreaterThan(594);
    expect(placeOf(foe).x).toBeLessThan(595.5);
  });

  it('stays where it is while the robot is farther away than its reach', () => {
    const { world, robot } = arena(900, 450);
    const foe = world.addMover(after(200, 450, { reachMm: 300 }));
    wait(world, 1);
    expect(placeOf(foe)).toEqual({ x: 200, y: 450 });
    robot.place({ xMm: 490, yMm: 450, headingRad: 0 });
    wait(world, 1);
    expect(placeOf(foe).x).toBeGreaterThan(290);
    robot.place({ xMm: 900, yMm: 450, headingRad: 0 });
    wait(world, 1);
    const there = placeOf(foe);
    wait(world, 1);
    expect(placeOf(foe)).toEqual(there);
  });

  it('takes the nearest of two robots, and of two equally near the first', () => {
    const { world, robot } = arena(600, 800);
    const second = world.addChassis(testChassis(), { xMm: 600, yMm: 100, headingRad: 0 });
    const foe = world.addMover(after(600, 450));
    wait(world, 1);
    expect(placeOf(foe).y).toBeGreaterThan(500);
    robot.place({ xMm: 100, yMm: 800, headingRad: 0 });
    second.place({ xMm: 600, yMm: 200, headingRad: 0 });
    wait(world, 2);
    expect(placeOf(foe).y).toBeLessThan(450);
  });

  it('is hardly moved by a robot that drives against it, and is seen by its sensor', () => {
    const { world, robot, drive } = arena(300, 450);
    const foe = world.addMover(after(700, 450, { reachMm: 1 }));
    const cone = { openingRad: 0.1, rangeMm: 3000 };
    expect(world.distanceCone({ x: 360, y: 450 }, 0, cone, robot).distanceMm).toBeCloseTo(310, 6);
    drive(150, 150, 6);
    expect(robot.touching()).toEqual(['foe']);
    expect(placeOf(foe).x).toBeLessThan(700.5);
  });

  it('turns by its own spin alone, also while it chases', () => {
    const { world } = arena(900, 450);
    const foe = world.addMover(after(100, 450, { spinRadPerS: 1 }));
    wait(world, 2);
    expect(foe.pose().headingRad).toBeCloseTo(2, 9);
    expect(placeOf(foe).x).toBeGreaterThan(298);
  });

  it('holds a robot against a wall without pressing it through', () => {
    const { world, robot } = arena(500, 200, { widthMm: 600, heightMm: 400 });
    const foe = world.addMover(after(100, 200, { speedMmPerS: 500 }));
    wait(world, 20);
    expect(robot.pose().xMm + 59).toBeLessThan(601);
    expect(placeOf(foe).x).toBeLessThan(robot.pose().xMm - 22);
    expect(robot.touching()).toEqual(expect.arrayContaining([null, 'foe']));
  });

  it('comes out the same to the last bit again', () => {
    const numbers = (): number[] => {
      const { world, robot, drive } = arena(500, 450);
      world.addWall({ fromMm: { x: 600, y: 100 }, toMm: { x: 620, y: 800 }, thicknessMm: 10 });
      const foe = world.addMover(after(100, 100, { speedMmPerS: 300, spinRadPerS: 2 }));
      return Array.from({ length: 500 }, (_, i) => {
        drive(60 + (i % 90), i % 200 < 150 ? 60 : -40, 0.02);
        return [foe, robot].flatMap((body) => numbersOf(body.pose()));
      }).flat();
    };
    expect(hashOf(numbers())).toBe(hashOf(numbers()));
  });
});

describe('an obstacle that guards', () => {
  it('stands at its place until a robot is where it must not be, chases it, and goes back to its place', () => {
    const { world, robot } = arena(300, 450);
    const foe = world.addMover(after(800, 700, { wants: rightHalf, returns: true, speedMmPerS: 200 }));
    wait(world, 2);
    expect(placeOf(foe)).toEqual({ x: 800, y: 700 });
    robot.place({ xMm: 800, yMm: 200, headingRad: 0 });
    wait(world, 1.5);
    expect(placeOf(foe).y).toBeLessThan(410);
    robot.place({ xMm: 300, yMm: 200, headingRad: 0 });
    wait(world, 4);
    expect(placeOf(foe).x).toBeCloseTo(800, 9);
    expect(placeOf(foe).y).toBeCloseTo(700, 9);
  });

  it('runs after the robot in the zone, not after a nearer one outside', () => {
    const { world } = arena(500, 450);
    world.addChassis(testChassis(), { xMm: 1000, yMm: 200, headingRad: 0 });
    const foe = world.addMover(after(600, 450, { wants: rightHalf }));
    wait(world, 1);
    expect(placeOf(foe).x).toBeGreaterThan(650);
  });
});
