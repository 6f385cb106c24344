import { describe, expect, it } from 'vitest';
import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import type { BlockHandle } from './shapes';
import { createWorld } from './world';

const WALL_AT_MM = 1000;
const SECONDS = 2.5;
/** Each takes a twentieth of a second: 80 by default, 4,000 in `npm run fuzz`. */
const TRIALS = Math.min(Math.ceil(fuzzRuns * 0.08), 4_000);
const between = (rng: Rng, from: number, to: number): number => from + rng.unit() * (to - from);

/** A mover that goes over a wall from edge to edge, with blocks in its path; the blocks that are behind the wall at the end. */
function trial(seed: number): readonly BlockHandle[] {
  const rng = createRng(seed);
  const world = createWorld({ widthMm: 1500, heightMm: 1000 });
  const thicknessMm = [2, 3, 5, 10][seed % 4] ?? 2;
  world.addWall({ fromMm: { x: WALL_AT_MM, y: 0 }, toMm: { x: WALL_AT_MM, y: 1000 }, thicknessMm });
  const stops = [
    { atMm: { x: 600, y: 500 }, waitS: 0 },
    { atMm: { x: 1100, y: between(rng, 450, 550) }, waitS: 0 },
  ];
  world.addMover({
    sizeMm: { x: between(rng, 40, 200), y: between(rng, 40, 200) },
    angleRad: between(rng, 0, 3),
    goes: { stops, loops: false, phaseS: 0 },
    speedMmPerS: between(rng, 200, 500),
    spinRadPerS: between(rng, -1, 1),
  });
  const blocks = Array.from({ length: 1 + Math.floor(3 * rng.unit()) }, (_, i) =>
    world.addBlock({
      atMm: { x: 760 + 70 * i, y: between(rng, 460, 540) },
      sizeMm: { x: between(rng, 5, 60), y: between(rng, 5, 60) },
      angleRad: between(rng, 0, 3),
      fixed: false,
    }),
  );
  for (let step = 0; step < SECONDS * 250; step++) world.step();
  return blocks.filter((block) => block.pose().xMm > WALL_AT_MM);
}

describe('a wall from edge to edge', () => {
  it(
    `lets no block through, whatever a moving obstacle presses against it: ${TRIALS} random trials`,
    { timeout: 60_000 + TRIALS * 300 },
    () => {
      const through: number[] = [];
      for (let seed = 1; seed <= TRIALS; seed++) if (trial(seed).length > 0) through.push(seed);
      expect(through).toEqual([]);
    },
  );
});
