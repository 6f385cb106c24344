import { describe, expect, it } from 'vitest';
import { createRig, testChassis } from '../testing/rig';
import { createWorld, type World } from '../world';
import { EYE_MM, UPWARDS, type Eye } from './light';

const upAt = (x: number, y = 1000): Eye => ({ atMm: { x, y }, facing: UPWARDS });

/** An arena of 3 × 2 m in a dark room, with a lamp of 40 cd, 200 mm above the eyes, over (1000, 1000). */
function lit(heightMm = EYE_MM + 200): World {
  const world = createWorld({ widthMm: 3000, heightMm: 2000 });
  world.light.setRoom(0);
  world.light.addLamp({ atMm: { x: 1000, y: 1000 }, heightMm, candela: 40, on: true });
  return world;
}

describe('the light in an arena', () => {
  it('is that of an ordinary room without a lamp: 300 lx, and nobody has said anything of it', () => {
    const world = createWorld({ widthMm: 1000, heightMm: 1000 });
    expect([world.luxAt(upAt(500)), world.light.isKnown]).toEqual([300, false]);
  });

  it.each([
    [0.2, 1000],
    [0.4, 250],
    [1, 40],
    [2, 10],
  ])('is right below a lamp of 40 cd, %f m under it, by the inverse square %f lx', (metres, lux) => {
    expect(lit(EYE_MM + 1000 * metres).luxAt(upAt(1000))).toBeCloseTo(lux, 9);
  });

  it('is beside the lamp I · cos φ / d²', () => {
    // 480 mm aside and 200 mm below: d = 520 mm, cos φ = 200 / 520.
    expect(lit().luxAt(upAt(1480))).toBeCloseTo((40 / (0.52 * 0.52)) * (200 / 520), 9);
    const towards: Eye = { atMm: { x: 1480, y: 1000 }, facing: { x: -480 / 520, y: 0, z: 200 / 520 } };
    expect(lit().luxAt(towards)).toBeCloseTo(40 / (0.52 * 0.52), 9);
    expect(lit().luxAt({ ...towards, facing: { x: 1, y: 0, z: 0 } })).toBe(0);
  });

  it('is that of the room and all lamps together; a lamp that is off, moved away or removed gives none', () => {
    const world = lit();
    world.light.setRoom(50);
    const other = world.light.addLamp({ atMm: { x: 1000, y: 1000 }, heightMm: 1060, candela: 40, on: false });
    expect(world.luxAt(upAt(1000))).toBeCloseTo(1050, 9);
    other.switch(true);
    expect(world.luxAt(upAt(1000))).toBeCloseTo(1090, 9);
    other.remove();
    expect(world.luxAt(upAt(1000))).toBeCloseTo(1050, 9);
  });
});

describe('a shadow', () => {
  const wallAt = (world: World, x: number, heightMm?: number): void =>
    world.addWall({ fromMm: { x, y: 900 }, toMm: { x, y: 1100 }, thicknessMm: 10, ...(heightMm && { heightMm }) });

  it('lies behind a wall and nowhere else', () => {
    const world = lit();
    wallAt(world, 1200);
    expect(world.luxAt(upAt(1300))).toBe(0);
    expect(world.luxAt(upAt(1100))).toBeGreaterThan(0);
    expect(world.luxAt(upAt(700))).toBeGreaterThan(0);
    expect(world.luxAt(upAt(1300, 1300))).toBeGreaterThan(0);
  });

  it('is as long as the ray over the top of the thing needs to come down to the eye', () => {
    // The lamp is 200 mm above the eyes, the wall 100 mm: the ray over its far side at 205 mm comes down at 410 mm.
    const world = lit();
    wallAt(world, 1200, EYE_MM + 100);
    expect(world.luxAt(upAt(1405))).toBe(0);
    expect(world.luxAt(upAt(1415))).toBeGreaterThan(0);
  });

  it('is thrown by nothing that ends below the eyes', () => {
    const world = lit();
    wallAt(world, 1200, EYE_MM);
    expect(world.luxAt(upAt(1220))).toBeGreaterThan(0);
  });

  it.each([true, false])('follows a block that is pushed (round: %s) and ends when it is gone', (isRound) => {
    const world = lit();
    const block = world.addBlock({
      ...{ atMm: { x: 1200, y: 1000 }, sizeMm: { x: 60, y: 60 }, isRound, heightMm: 150 },
      ...{ angleRad: 0.3, fixed: false },
    });
    expect(world.luxAt(upAt(1260))).toBe(0);
    block.place({ xMm: 1200, yMm: 1200, headingRad: 0 });
    expect(world.luxAt(upAt(1260))).toBeGreaterThan(0);
    block.place({ xMm: 1200, yMm: 1000, headingRad: 0 });
    world.removeBlock(block);
    expect(world.luxAt(upAt(1260))).toBeGreaterThan(0);
  });

  it('is thrown by other robots, and not by the one that carries the eye', () => {
    const { world, robot } = createRig();
    world.light.setRoom(0);
    world.light.addLamp({ atMm: { x: 2300, y: 2000 }, heightMm: 200, candela: 40, on: true });
    expect(world.luxAt(upAt(2000, 2000))).toBe(0);
    expect(world.luxAt(upAt(2000, 2000), robot)).toBeGreaterThan(0);
    world.addChassis(testChassis(), { xMm: 2150, yMm: 2000, headingRad: Math.PI / 2 });
    expect(world.luxAt(upAt(2000, 2000), robot)).toBeGreaterThan(0); // the ray passes over its 85 mm
    expect(world.luxAt(upAt(2080, 2000), robot)).toBe(0);
  });
});

describe('a tunnel', () => {
  const square = (x: number) => [
    { x, y: 900 },
    { x: x + 200, y: 900 },
    { x: x + 200, y: 1100 },
    { x, y: 1100 },
  ];

  it('is dark inside: neither the room nor a lamp outside reaches in, only its own lamp', () => {
    const world = lit();
    world.light.setRoom(300);
    const open = world.light.addTunnel([square(1100)]);
    expect(world.luxAt(upAt(1150))).toBe(2);
    expect(world.luxAt(upAt(1400))).toBeGreaterThan(300);
    world.light.addLamp({ atMm: { x: 1150, y: 1000 }, heightMm: EYE_MM + 200, candela: 40, on: true });
    expect(world.luxAt(upAt(1150))).toBeCloseTo(1002, 9);
    open();
    expect(world.luxAt(upAt(1150))).toBeGreaterThan(1300);
  });

  it('is no brighter than a dark room', () => {
    const world = createWorld({ widthMm: 3000, heightMm: 2000 });
    world.light.setRoom(1);
    world.light.addTunnel([square(1100)]);
    expect(world.luxAt(upAt(1150))).toBe(1);
  });
});
