import { describe, expect, it } from 'vitest';
import { createRig } from '../testing/rig';
import { createWorld } from '../world';

const BEAM = { openingRad: (30 * Math.PI) / 180, rangeMm: 4000 };
const DEGREE = Math.PI / 180;

/** A sensor at (500, 2500) in an arena of 5 × 5 m, looking along x at a wall 2 m wide. */
const facing = (distanceMm: number, turnedRad = 0) => {
  const world = createWorld({ widthMm: 5000, heightMm: 5000 });
  // The wall is turned about the point that the sensor looks at.
  const foot = { x: 500 + distanceMm, y: 2500 };
  const [c, s] = [Math.cos(turnedRad), Math.sin(turnedRad)];
  const end = (along: number) => ({ x: foot.x + 5 * c - along * s, y: foot.y + 5 * s + along * c });
  world.addWall({ fromMm: end(-1000), toMm: end(1000), thicknessMm: 10 });
  return world;
};

describe('the distance cone', () => {
  it.each([5, 50, 51.3, 200, 777.7, 1500, 2000])('finds a wall %f mm ahead to 1 nm', (distanceMm) => {
    const { distanceMm: found, hitMm } = facing(distanceMm).distanceCone({ x: 500, y: 2500 }, 0, BEAM);
    expect(found).toBeCloseTo(distanceMm, 6);
    expect(hitMm?.x).toBeCloseTo(500 + distanceMm, 6);
    expect(hitMm?.y).toBeCloseTo(2500, 6);
  });

  it('finds the nearest point of a wall turned by 10°: the foot of the perpendicular', () => {
    const { distanceMm } = facing(1000, 10 * DEGREE).distanceCone({ x: 500, y: 2500 }, 0, BEAM);
    expect(distanceMm).toBeCloseTo(1000 * Math.cos(10 * DEGREE), 6);
  });

  it('finds the point on the cone’s edge when the wall is turned further than the cone is wide', () => {
    const { distanceMm } = facing(1000, 40 * DEGREE).distanceCone({ x: 500, y: 2500 }, 0, BEAM);
    // The edge ray at 15° meets the wall, whose normal lies at 40°.
    expect(distanceMm).toBeCloseTo((1000 * Math.cos(40 * DEGREE)) / Math.cos(25 * DEGREE), 6);
  });

  it('finds nothing beyond its range', () => {
    const cone = { ...BEAM, rangeMm: 1999 };
    expect(facing(2000).distanceCone({ x: 500, y: 2500 }, 0, cone)).toEqual({ distanceMm: Infinity, hitMm: null });
  });

  it('finds the edge of the arena', () => {
    const world = createWorld({ widthMm: 1200, heightMm: 900 });
    for (const [headingRad, distance] of [[0, 800], [Math.PI / 2, 600], [Math.PI, 400], [-Math.PI / 2, 300]] as const) {
      const hit = world.distanceCone({ x: 400, y: 300 }, headingRad, { ...BEAM, rangeMm: 2000 });
      expect(hit.distanceMm).toBeCloseTo(distance, 6);
    } // prettier-ignore
  });

  it('sees a block of 2 mm at 2 m, between any two rays', () => {
    const world = createWorld({ widthMm: 8000, heightMm: 8000 });
    const y = 4000 + 2000 * Math.sin(0.1234);
    const x = 1000 + 2000 * Math.cos(0.1234);
    world.addBlock({ atMm: { x, y }, sizeMm: { x: 2, y: 2 }, angleRad: 0, fixed: false });
    const hit = world.distanceCone({ x: 1000, y: 4000 }, 0, BEAM);
    expect(Math.abs(hit.distanceMm - 2000)).toBeLessThan(1.5);
  });

  it('does not see a block beside the cone or behind the sensor', () => {
    const world = createWorld({ widthMm: 9000, heightMm: 9000 });
    const size = { x: 50, y: 50 };
    world.addBlock({ atMm: { x: 4800, y: 4700 }, sizeMm: size, angleRad: 0.3, fixed: false });
    world.addBlock({ atMm: { x: 4300, y: 4500 }, sizeMm: size, angleRad: 0, fixed: true });
    expect(world.distanceCone({ x: 4500, y: 4500 }, 0, BEAM).distanceMm).toBe(Infinity);
  });

  it('reports 0 from inside a block', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 1000 });
    world.addBlock({ atMm: { x: 500, y: 500 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false });
    expect(world.distanceCone({ x: 510, y: 490 }, 1, BEAM)).toEqual({ distanceMm: 0, hitMm: { x: 510, y: 490 } });
  });

  it('follows a moving block and overlooks the robot that carries the sensor', () => {
    const { world, robot, drive } = createRig({ xMm: 500, yMm: 2000, headingRad: 0 });
    const block = world.addBlock({ atMm: { x: 700, y: 2000 }, sizeMm: { x: 50, y: 50 }, angleRad: 0, fixed: false });
    drive(60, 60, 4);
    const sensor = robot.toWorld({ x: 53, y: 0 });
    const gap = block.pose().xMm - 25 - sensor.x;
    expect(world.distanceCone(sensor, robot.pose().headingRad, BEAM, robot).distanceMm).toBeCloseTo(gap, 3);
    expect(world.distanceCone(sensor, robot.pose().headingRad, BEAM).distanceMm).toBe(0);
  });
});

describe('the distance cone with an incidence limit of 25°', () => {
  const cone = { ...BEAM, incidenceLimitRad: 25 * DEGREE };

  it.each([50, 500, 2000])('finds a wall %f mm ahead to 0.1 mm', (distanceMm) =>
    expect(facing(distanceMm).distanceCone({ x: 500, y: 2500 }, 0, cone).distanceMm).toBeCloseTo(distanceMm, 1),
  );

  it('finds a wall turned by 20° at its perpendicular’s side of the cone', () => {
    const { distanceMm } = facing(1000, 20 * DEGREE).distanceCone({ x: 500, y: 2500 }, 0, cone);
    expect(distanceMm).toBeCloseTo((1000 * Math.cos(20 * DEGREE)) / Math.cos(5 * DEGREE), 3);
  });

  it.each([
    [24, true],
    [26, false],
    [34, false],
  ])('tells a wall turned by %f° against the way it looks: seen is %s', (degrees, isSeen) => {
    const { distanceMm } = facing(1000, degrees * DEGREE).distanceCone({ x: 500, y: 2500 }, 0, cone);
    expect(distanceMm < Infinity).toBe(isSeen);
  });

  it('does not see a wall turned by 45°, nor what is behind it', () => {
    const world = facing(1000, 45 * DEGREE);
    world.addBlock({ atMm: { x: 2500, y: 2500 }, sizeMm: { x: 50, y: 2000 }, angleRad: 0, fixed: true });
    expect(world.distanceCone({ x: 500, y: 2500 }, 0, cone).distanceMm).toBe(Infinity);
  });
});
