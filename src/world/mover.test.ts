import { describe, expect, it } from 'vitest';
import type { MoverHandle, MoverShape, Way } from './shapes';
import { createRig, hashOf, testChassis } from './testing/rig';
import { STEP_S } from './step';
import { createWorld } from './world';
import type { World } from './world';

type Place = readonly [x: number, y: number];
type Stop = readonly [x: number, y: number, waitS?: number];

const along = (stops: readonly Stop[], speedMmPerS: number, more: Partial<MoverShape & Way> = {}): MoverShape => ({
  ...{ id: 'mover', sizeMm: { x: 60, y: 60 }, angleRad: 0, speedMmPerS, spinRadPerS: 0, ...more },
  goes: {
    stops: stops.map(([x, y, waitS = 0]) => ({ atMm: { x, y }, waitS })),
    loops: more.loops ?? false,
    phaseS: more.phaseS ?? 0,
  },
});

const box = (from: Place, to: Place, speedMmPerS: number): MoverShape => along([from, to], speedMmPerS);

const wait = (world: World, seconds: number): void => {
  for (let step = 0; step < Math.round(seconds / STEP_S); step++) world.step();
};

const xOf = (mover: MoverHandle): number => mover.pose().xMm;

describe('a moving obstacle', () => {
  it('goes to and fro at its speed: 300 mm at 100 mm/s take 3 s there and 3 s back', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(box([200, 200], [500, 200], 100));
    expect(mover.pose()).toEqual({ xMm: 200, yMm: 200, headingRad: 0 });
    wait(world, 1);
    expect(xOf(mover)).toBe(300);
    wait(world, 2);
    expect(xOf(mover)).toBe(500);
    wait(world, 2);
    expect(xOf(mover)).toBe(300);
    wait(world, 3);
    expect(xOf(mover)).toBeCloseTo(400, 9);
  });

  it('is where it has to be to the last bit after 10 minutes', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(box([200, 200], [500, 200], 100));
    wait(world, 600);
    expect(xOf(mover)).toBe(200);
  });

  it('stands still when it has nowhere to go', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(box([200, 200], [200, 200], 100));
    wait(world, 1);
    expect(mover.pose()).toEqual({ xMm: 200, yMm: 200, headingRad: 0 });
  });

  it('pushes a block ahead of itself and leaves it behind on the way back', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    world.addMover(box([200, 200], [500, 200], 200));
    const block = world.addBlock({ atMm: { x: 300, y: 200 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false });
    wait(world, 1.5);
    expect(block.pose().xMm).toBeGreaterThan(554.5);
    expect(block.pose().xMm).toBeLessThan(556);
    wait(world, 0.2); // it slides on a little, by its friction on the floor
    const left = block.pose();
    wait(world, 1.2);
    expect(block.pose()).toEqual(left);
  });

  it('pushes a robot that stands with its motors braked, sideways too, and is not stopped by it', () => {
    const { world, robot } = createRig({ xMm: 1000, yMm: 1000, headingRad: 0 });
    const mover = world.addMover(box([1020, 800], [1020, 1100], 100));
    wait(world, 3);
    expect(mover.pose().yMm).toBe(1100);
    expect(robot.pose().yMm).toBeGreaterThan(1000 + 60);
    expect(robot.collisions()).toBe(1);
    expect(robot.touching()).toEqual(['mover']);
  });

  it('is touched by a robot that drives against it', () => {
    const { world, robot, drive } = createRig({ xMm: 1000, yMm: 1000, headingRad: 0 });
    world.addMover(box([1300, 1000], [1600, 1000], 20));
    drive(100, 100, 3);
    expect(robot.touching()).toEqual(['mover']);
  });

  it('is seen by a distance sensor where it is now', () => {
    const { world, robot } = createRig({ xMm: 1000, yMm: 1000, headingRad: 0 });
    world.addMover(box([1500, 1000], [1800, 1000], 100));
    const beam = { openingRad: 0.1, rangeMm: 3000 };
    const distance = (): number => world.distanceCone({ x: 1060, y: 1000 }, 0, beam, robot).distanceMm;
    expect(distance()).toBeCloseTo(1470 - 1060, 9);
    wait(world, 2);
    expect(distance()).toBeCloseTo(1670 - 1060, 9);
  });

  it('waits at each of its stops: 2 s at the first, 1 s at the second, none at the third, and back the same way', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(along([[200, 100, 2], [300, 100, 1], [300, 200]], 100)); // prettier-ignore
    const places = Array.from({ length: 11 }, () => {
      const { xMm, yMm } = mover.pose();
      wait(world, 1);
      return [xMm, yMm];
    });
    expect(places).toEqual([
      ...[[200, 100], [200, 100], [200, 100], [300, 100], [300, 100]], // 2 s waiting, 1 s way, 1 s waiting
      ...[[300, 200], [300, 100], [300, 100]], // 1 s on, 1 s back, 1 s waiting
      ...[[200, 100], [200, 100], [200, 100]],
    ]); // prettier-ignore
  });

  it('goes round and round: 100 mm along each side of a square', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(along([[200, 100], [300, 100], [300, 200], [200, 200]], 100, { loops: true })); // prettier-ignore
    wait(world, 3.5);
    expect(mover.pose()).toMatchObject({ xMm: 200, yMm: 150 });
    wait(world, 1);
    expect(mover.pose()).toMatchObject({ xMm: 250, yMm: 100 });
  });

  it('starts with its phase: where it would be after 4.5 s', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const mover = world.addMover(along([[200, 200, 1], [500, 200]], 100, { phaseS: 4.5 })); // prettier-ignore
    expect(xOf(mover)).toBe(450);
    wait(world, 1);
    expect(xOf(mover)).toBe(350);
  });

  it('has its 20 stops to the mm after 10 minutes', () => {
    const world = createWorld({ widthMm: 3000, heightMm: 500 });
    const stops = Array.from({ length: 20 }, (_, i): Stop => [100 + 100 * i, 200, 0.5]);
    const mover = world.addMover(along(stops, 100));
    wait(world, 57); // a round: 38 legs of 1 s, 38 waits of 0.5 s
    wait(world, 57 * 9 + 30);
    // 30 s into a round: 0.5 s at the first stop, then 19 legs with their waits end after 29 s.
    expect(xOf(mover)).toBeCloseTo(1900, 6);
  });

  it('turns on the spot, either way, and while it travels: 90° a second', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    const spinRadPerS = Math.PI / 2;
    const left = world.addMover(along([[200, 200]], 100, { spinRadPerS }));
    const right = world.addMover(along([[500, 200], [700, 200]], 100, { spinRadPerS: -spinRadPerS })); // prettier-ignore
    wait(world, 1.5);
    expect(left.pose()).toMatchObject({ xMm: 200, yMm: 200 });
    expect(left.pose().headingRad).toBeCloseTo(0.75 * Math.PI, 12);
    expect(right.pose()).toMatchObject({ xMm: 650, yMm: 200 });
    expect(right.pose().headingRad).toBeCloseTo(-0.75 * Math.PI, 12);
  });

  it('strikes a block with its turning arm, and is seen where the arm points', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    world.addMover(along([[500, 250]], 100, { spinRadPerS: 1, sizeMm: { x: 300, y: 20 } }));
    const block = world.addBlock({ atMm: { x: 600, y: 350 }, sizeMm: { x: 40, y: 40 }, angleRad: 0, fixed: false });
    const ahead = { openingRad: 0.01, rangeMm: 3000 };
    expect(world.distanceCone({ x: 100, y: 250 }, 0, ahead).distanceMm).toBeCloseTo(250, 6);
    wait(world, 1.5);
    expect(block.pose().yMm).toBeGreaterThan(380);
    expect(world.distanceCone({ x: 100, y: 250 }, 0, ahead).distanceMm).toBeGreaterThan(380);
  });

  it('refuses sides and speeds that are not above 0', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 500 });
    expect(() => world.addMover(box([1, 1], [9, 9], 0))).toThrow(/0 mm\/s/);
    expect(() => world.addMover({ ...box([1, 1], [9, 9], 5), sizeMm: { x: 0, y: 5 } })).toThrow(/0 × 5/);
  });
});

/** Checks that jammed things stay in an arena of 600 × 400 mm and never fly: the longest step of anything, in mm. */
function jam(speedMmPerS: number, thing: 'block' | 'robot', wallAtMm?: number) {
  const world = createWorld({ widthMm: 600, heightMm: 400 });
  const mover = world.addMover(box([100, 200], [590, 200], speedMmPerS));
  if (wallAtMm !== undefined)
    world.addWall({ fromMm: { x: wallAtMm, y: 0 }, toMm: { x: wallAtMm, y: 400 }, thicknessMm: 10 });
  const body =
    thing === 'robot'
      ? world.addChassis(testChassis(), { xMm: 250, yMm: 200, headingRad: 0.1 })
      : world.addBlock({ atMm: { x: 250, y: 205 }, sizeMm: { x: 50, y: 50 }, angleRad: 0.1, fixed: false });
  const poses = [body.pose()];
  let farthest = 0;
  for (let step = 0; step < 15_000; step++) {
    world.step();
    const [before, now] = [poses[poses.length - 1] ?? body.pose(), body.pose()];
    farthest = Math.max(farthest, Math.hypot(now.xMm - before.xMm, now.yMm - before.yMm));
    poses.push(now);
  }
  return { poses, farthest, mover };
}

describe('what is jammed between a moving obstacle and a wall', () => {
  const cases = ([20, 100, 500] as const).flatMap((speed) =>
    (['block', 'robot'] as const).flatMap((thing) => [undefined, 450].map((wall) => ({ speed, thing, wall }))),
  );
  it.each(cases)('neither flies nor leaves: $thing at $speed mm/s, wall at $wall', ({ speed, thing, wall }) => {
    const { poses, farthest, mover } = jam(speed, thing, wall);
    for (const { xMm, yMm } of poses) {
      expect(xMm).toBeGreaterThan(0);
      expect(xMm).toBeLessThan(wall ?? 600);
      expect(Math.min(yMm, 400 - yMm)).toBeGreaterThan(0);
    }
    expect(farthest).toBeLessThan(8);
    expect(mover.pose().xMm).toBeGreaterThanOrEqual(100);
  });

  it('comes out the same to the last bit again', () => {
    const numbers = (): number[] =>
      jam(500, 'block', 450).poses.flatMap(({ xMm, yMm, headingRad }) => [xMm, yMm, headingRad]);
    expect(hashOf(numbers())).toBe(hashOf(numbers()));
  });

  it('is free again once the obstacle has gone: the robot drives away', () => {
    const { world, robot, drive } = createRig({ xMm: 250, yMm: 200, headingRad: 0 }, testChassis(), {
      widthMm: 600,
      heightMm: 400,
    });
    world.addMover(box([100, 200], [580, 200], 200));
    drive(0, 0, 4.8);
    const before = robot.pose().xMm;
    expect(before).toBeGreaterThan(500);
    drive(-120, -120, 1);
    expect(robot.pose().xMm).toBeLessThan(before - 100);
  });
});
