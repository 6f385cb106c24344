import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import type { Rng } from '#core/rng';
import type { Chassis } from './chassis';
import { turned } from './physics/block-body';
import { gapBetween } from './physics/convex';
import { rectangleCorners, wallCorners, type BlockHandle } from './shapes';
import type { WallShape } from './shapes';
import { createRig, hashOf, testChassis } from './testing/rig';
import { OPEN_RAD, TEST_CLAW, TEST_FORK, UP_MM } from './testing/tools';
import type { World } from './world';

const SIZE = { widthMm: 900, heightMm: 700 };
const SIDES_MM = [50, 30, 60, 40, 50, 35];
const FIXED = 4;
const WALLS: readonly WallShape[] = [
  { fromMm: { x: 600, y: 0 }, toMm: { x: 600, y: 250 }, thicknessMm: 10 },
  { fromMm: { x: 0, y: 500 }, toMm: { x: 250, y: 450 }, thicknessMm: 6 },
];
const STEPS_PER_S = 250;

interface Arena {
  readonly world: World;
  readonly robot: Chassis;
  readonly blocks: readonly BlockHandle[];
}

/** A small arena with two walls, five loose blocks, a fixed one and a robot between them. */
function createArena(): Arena {
  const { world, robot } = createRig({ xMm: 300, yMm: 300, headingRad: 0 }, testChassis(), SIZE);
  for (const wall of WALLS) world.addWall(wall);
  const blocks = SIDES_MM.map((side, i) =>
    world.addBlock({
      atMm: { x: 420 + 65 * (i % 3), y: 300 + 90 * Math.floor(i / 3) },
      sizeMm: { x: side, y: side },
      angleRad: i / 2,
      fixed: i === FIXED,
    }),
  );
  return { world, robot, blocks };
}

const between = (rng: Rng, from: number, to: number): number => from + rng.unit() * (to - from);
const anywhere = (rng: Rng) => ({
  xMm: between(rng, 0, SIZE.widthMm),
  yMm: between(rng, 0, SIZE.heightMm),
  headingRad: between(rng, -3, 3),
});

/** Random actions, every 0.1 … 0.9 s: drive, swing, lift and, if the hand tool may, put things elsewhere. */
function actAtRandom({ robot, blocks }: Arena, rng: Rng, hand: boolean): () => void {
  const claw = robot.addGripper(TEST_CLAW);
  const fork = robot.addFork(TEST_FORK);
  let next = 0;
  const aim = { swing: OPEN_RAD, height: 0 };
  const now = { swing: OPEN_RAD, height: 0 };
  const toward = (from: number, to: number, most: number): number => from + Math.min(Math.max(to - from, -most), most);
  return () => {
    if (next-- <= 0) {
      next = Math.floor(between(rng, 20, 220));
      const left = between(rng, -0.35, 0.65);
      robot.setDuty(0, left);
      robot.setDuty(1, rng.unit() < 0.4 ? left : between(rng, -0.35, 0.65));
      if (rng.unit() < 0.5)
        aim.swing = [0, 0, OPEN_RAD, between(rng, 0, OPEN_RAD)][Math.floor(between(rng, 0, 4))] ?? 0;
      if (rng.unit() < 0.4) aim.height = rng.unit() < 0.5 ? 0 : UP_MM;
      if (hand && rng.unit() < 0.1) blocks[Math.floor(between(rng, 0, blocks.length))]?.place(anywhere(rng));
      if (hand && rng.unit() < 0.05) robot.place(anywhere(rng));
    }
    now.swing = toward(now.swing, aim.swing, 0.02);
    now.height = toward(now.height, aim.height, 0.5);
    claw.setSwing(now.swing);
    fork.setHeightMm(now.height);
  };
}

/** How deep blocks are inside walls, inside each other or outside the arena, in mm. */
function deepestOverlapMm(blocks: readonly BlockHandle[]): number {
  const solids = WALLS.map(wallCorners);
  let deepest = 0;
  blocks.forEach((block, i) => {
    const side = SIDES_MM[i] ?? 0;
    const { xMm: x, yMm: y, headingRad: angle } = block.pose();
    const outline: Vec[] = turned(rectangleCorners({ x: side, y: side }), { x, y, angle });
    for (const solid of solids) deepest = Math.max(deepest, -gapBetween(outline, solid).gap);
    for (const corner of outline) {
      deepest = Math.max(deepest, -corner.x, corner.x - SIZE.widthMm, -corner.y, corner.y - SIZE.heightMm);
    }
    solids.push(outline);
  });
  return deepest;
}

/** Drives at random and returns all poses five times a second, the greatest overlap and the number of grips. */
function roam(seed: number, seconds: number, hand: boolean) {
  const arena = createArena();
  const act = actAtRandom(arena, createRng(seed), hand);
  const numbers: number[] = [];
  let overlapMm = 0;
  let held = 0;
  for (let step = 0; step < seconds * STEPS_PER_S; step++) {
    act();
    arena.world.step();
    const poses = [arena.robot, ...arena.blocks].map((body) => body.pose());
    for (const { xMm, yMm, headingRad } of poses) {
      const isInside = xMm > 0 && xMm < SIZE.widthMm && yMm > 0 && yMm < SIZE.heightMm && Number.isFinite(headingRad);
      if (!isInside && !hand) throw new Error(`At step ${step} something is at ${xMm}, ${yMm}, ${headingRad}.`);
    }
    if (step % 50 === 0) numbers.push(...poses.flatMap(({ xMm, yMm, headingRad }) => [xMm, yMm, headingRad]));
    if (!hand) overlapMm = Math.max(overlapMm, deepestOverlapMm(arena.blocks));
    if (arena.blocks.some((block) => block.isHeld())) held++;
  }
  return { numbers, overlapMm, held };
}

describe('a robot with claw and fork that does anything for 2 minutes', () => {
  it.each([2, 3, 7])(
    'leaves no block in a wall, in another one or outside (seed %i): never deeper than 3 mm',
    (seed) => {
      const { overlapMm, held } = roam(seed, 120, false);
      expect(overlapMm).toBeLessThan(3);
      expect(held).toBeGreaterThan(250);
    },
  );

  it.each([4, 5])('stays in the arena though the hand puts robot and blocks anywhere (seed %i)', (seed) => {
    const { numbers } = roam(seed, 120, true);
    for (let i = 0; i < numbers.length; i += 3) {
      expect(numbers[i]).toBeGreaterThan(-60);
      expect(numbers[i]).toBeLessThan(SIZE.widthMm + 60);
      expect(numbers[i + 1]).toBeGreaterThan(-60);
      expect(numbers[i + 1]).toBeLessThan(SIZE.heightMm + 60);
      expect(numbers[i + 2]).not.toBeNaN();
    }
  });

  it('does the same again to the last bit', () => {
    expect(hashOf(roam(6, 60, true).numbers)).toBe(hashOf(roam(6, 60, true).numbers));
  });
});
