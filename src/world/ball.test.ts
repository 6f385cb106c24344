import { describe, expect, it } from 'vitest';
import type { BlockShape } from './shapes';
import { createRig } from './testing/rig';

const thing = (of: Partial<BlockShape>): BlockShape => ({
  ...{ atMm: { x: 2120, y: 2000 }, sizeMm: { x: 40, y: 40 }, isRound: true, angleRad: 0, fixed: false },
  ...of,
});

/** The places of a thing and a robot that has pushed it for a second and left it alone for three. */
function pushed(of: Partial<BlockShape>): { readonly thingMm: number; readonly robotMm: number } {
  const { world, robot, drive } = createRig();
  const block = world.addBlock(thing(of));
  drive(120, 120, 1);
  drive(0, 0, 3);
  return { thingMm: block.pose().xMm, robotMm: robot.pose().xMm };
}

describe('a ball', () => {
  it('rolls on when the robot has stopped, and comes to rest; a block stays where it was pushed to', () => {
    const ball = pushed({ rolls: true });
    const block = pushed({});
    expect(ball.thingMm - ball.robotMm).toBeGreaterThan(59 + 20 + 50);
    expect(block.thingMm - block.robotMm).toBeLessThan(59 + 20 + 15);
    const { world, drive } = createRig();
    const rolling = world.addBlock(thing({ rolls: true }));
    drive(120, 120, 1);
    drive(0, 0, 6);
    const rest = rolling.pose();
    drive(0, 0, 1);
    expect(rolling.pose()).toEqual(rest);
  });

  it('jumps back from a wall', () => {
    const { world, drive } = createRig();
    world.addWall({ fromMm: { x: 2300, y: 1900 }, toMm: { x: 2300, y: 2100 }, thicknessMm: 10 });
    const ball = world.addBlock(thing({ rolls: true }));
    drive(120, 120, 0.7);
    let farthest = 0;
    for (let i = 0; i < 750; i++) {
      drive(0, 0, 0.004);
      farthest = Math.max(farthest, ball.pose().xMm);
    }
    expect(Math.abs(farthest - 2275)).toBeLessThan(2); // in one step it moves by 1 mm
    expect(ball.pose().xMm).toBeLessThan(2272);
  });

  it('rolls the farther, the less friction there is', () => {
    const ways = [0.1, 0.02, 0.01].map((friction) => pushed({ rolls: true, friction }).thingMm);
    expect(ways).toEqual([...ways].sort((a, b) => a - b));
    expect((ways[2] ?? 0) - (ways[0] ?? 0)).toBeGreaterThan(50);
  });
});

describe('a block with a mass and a friction of its own', () => {
  it('moves as before with the mass and the friction that it has by itself', () => {
    const massG = (Math.PI * 20 * 20 * 40) / 2500;
    expect(pushed({ massG, friction: 0.3 }).thingMm).toBeCloseTo(pushed({}).thingMm, 6);
  });

  it('slows the robot the more, the heavier and the rougher it is, and stops it at last', () => {
    const ways = [
      { massG: 20 },
      { massG: 200 },
      { massG: 200, friction: 0.8 },
      { massG: 2000, friction: 1 },
    ].map((of) => pushed(of).robotMm); // prettier-ignore
    expect(ways).toEqual([...ways].sort((a, b) => b - a));
    expect(ways[3]).toBeLessThan(2045);
  });

  it('is the same run each time, bit for bit', () => {
    expect(pushed({ rolls: true, massG: 3 })).toEqual(pushed({ rolls: true, massG: 3 }));
  });
});
