import { describe, expect, it } from 'vitest';
import type { Point, Scene, Wall } from '../scene';
import { mazeLimits, randomMaze, type MazeWish } from './maze';

const words = { name: 'M', description: '' };
const wishOf = (seed: number): MazeWish => ({
  seed,
  columns: 2 + (seed % 7),
  rows: 2 + (seed % 5),
  cellMm: 200 + 25 * (seed % 5),
});
const wallsOf = (scene: Scene): Wall[] => scene.objects.filter((object) => object.type === 'wall');

/** True if a wall lies between two neighbouring places: asked of the drawing, not of how it was made. */
function isBlocked(walls: readonly Wall[], from: Point, to: Point): boolean {
  const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  return walls.some((wall) => {
    const [x1, x2] = [Math.min(wall.from[0], wall.to[0]), Math.max(wall.from[0], wall.to[0])];
    const [y1, y2] = [Math.min(wall.from[1], wall.to[1]), Math.max(wall.from[1], wall.to[1])];
    return x >= x1 - 1 && x <= x2 + 1 && y >= y1 - 1 && y <= y2 + 1;
  });
}

/** Walks through all cells that can be reached from the robot's start: how many cells, how many openings, how far each is. */
function explore(scene: Scene, cellMm: number) {
  const walls = wallsOf(scene);
  const far = new Map([[scene.robot.at.join(), 0]]);
  const queue: Point[] = [scene.robot.at];
  let openings = 0;
  for (const at of queue)
    for (const [dx, dy] of [
      [cellMm, 0],
      [0, cellMm],
      [-cellMm, 0],
      [0, -cellMm],
    ] as const) {
      const next: Point = [at[0] + dx, at[1] + dy];
      if (next[0] < 0 || next[1] < 0 || next[0] > scene.size[0] || next[1] > scene.size[1]) continue;
      if (isBlocked(walls, at, next)) continue;
      openings += 1;
      if (far.has(next.join())) continue;
      far.set(next.join(), far.get(at.join())! + 1);
      queue.push(next);
    }
  return { far, openings: openings / 2 };
}

describe('a random maze', () => {
  it('is the same for the same seed, and another for another', () => {
    const wish = { seed: 7, columns: 6, rows: 5, cellMm: 250 };
    expect(randomMaze(wish, words)).toEqual(randomMaze(wish, words));
    const mazes = Array.from({ length: 50 }, (_, seed) => JSON.stringify(randomMaze({ ...wish, seed }, words)));
    expect(new Set(mazes).size).toBe(50);
  });

  it('has exactly one way from each cell to each other, with 300 seeds in many sizes', () => {
    for (let seed = 0; seed < 300; seed += 1) {
      const wish = wishOf(seed);
      const { far, openings } = explore(randomMaze(wish, words), wish.cellMm);
      expect(far.size, `seed ${String(seed)}`).toBe(wish.columns * wish.rows); // every cell is reached …
      expect(openings, `seed ${String(seed)}`).toBe(far.size - 1); // … and no way leads round in a circle
    }
  });

  it('has its target, with a black line across, in the cell that is farthest from the start', () => {
    for (let seed = 0; seed < 300; seed += 1) {
      const wish = wishOf(seed);
      const scene = randomMaze(wish, words);
      const { far } = explore(scene, wish.cellMm);
      const target = scene.objects.find(({ type }) => type === 'target');
      if (target?.type !== 'target') throw new Error('There is no target.');
      expect(far.get(target.at.join())).toBe(Math.max(...far.values()));
      const line = scene.objects.find(({ type }) => type === 'stroke');
      if (line?.type !== 'stroke') throw new Error('There is no line.');
      for (const [x, y] of line.points)
        expect(Math.max(Math.abs(x - target.at[0]), Math.abs(y - target.at[1]))).toBeLessThan(wish.cellMm / 2);
    }
  });

  it('lets the robot look into the open at its start', () => {
    for (let seed = 0; seed < 300; seed += 1) {
      const wish = wishOf(seed);
      const scene = randomMaze(wish, words);
      const { at, heading } = scene.robot;
      const ahead = { 0: [1, 0], 90: [0, 1], 180: [-1, 0], 270: [0, -1] }[heading];
      if (ahead === undefined) throw new Error(`The robot heads for ${String(heading)}°.`);
      const next: Point = [at[0] + ahead[0]! * wish.cellMm, at[1] + ahead[1]! * wish.cellMm];
      expect(isBlocked(wallsOf(scene), at, next), `seed ${String(seed)}`).toBe(false);
    }
  });

  it('joins walls in a row: no wall ends where another in line with it begins', () => {
    for (let seed = 0; seed < 50; seed += 1) {
      const walls = wallsOf(randomMaze({ seed, columns: 8, rows: 6, cellMm: 200 }, words));
      const isLevel = ({ from, to }: Wall): boolean => from[1] === to[1];
      for (const wall of walls)
        for (const other of walls)
          expect(isLevel(wall) === isLevel(other) && wall.to.join() === other.from.join()).toBe(false);
    }
  });

  it('refuses cells that are too narrow and mazes that are too large, in words', () => {
    const wish = { seed: 1, columns: 4, rows: 4, cellMm: 250 };
    expect(() => randomMaze({ ...wish, cellMm: 199 }, words)).toThrow('200 to 300 mm wide, not 199');
    expect(() => randomMaze({ ...wish, columns: 31 }, words)).toThrow('2 to 30 cells a side, not 31 × 4');
    expect(() => randomMaze({ ...wish, rows: 1.5 }, words)).toThrow(RangeError);
    const largest = randomMaze({ seed: 1, columns: 30, rows: 30, cellMm: mazeLimits.cellMm.max }, words);
    expect(largest.size).toEqual([9000, 9000]);
    expect(largest.objects.length).toBeLessThan(2000);
  });
});
