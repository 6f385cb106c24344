import { describe, expect, it } from 'vitest';
import type { Point, Scene } from '../scene';
import { randomTrack, trackLimits, type TrackWish } from './track';

const words = { name: 'T', description: '' };
const SEEDS = 300;
const sizes: readonly Point[] = [
  [1200, 900],
  [1600, 1200],
  [2000, 1400],
];
const wishOf = (seed: number): TrackWish => ({ seed, bends: 5 + (seed % 8), size: sizes[seed % 3]! });

function lineOf(scene: Scene): readonly Point[] {
  const line = scene.objects.find(({ type }) => type === 'stroke');
  if (line?.type !== 'stroke') throw new Error('There is no line.');
  return line.points;
}

const distance = (one: Point, other: Point): number => Math.hypot(one[0] - other[0], one[1] - other[1]);

/** Points every 20 mm along the line. */
function evenly(points: readonly Point[], everyMm = 20): Point[] {
  const even: Point[] = [];
  let left = 0;
  for (const [index, to] of points.slice(1).entries()) {
    const from = points[index]!;
    const length = distance(from, to);
    for (; left < length; left += everyMm) {
      const share = left / length;
      even.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
    }
    left -= length;
  }
  return even;
}

/** Radius of the circle through three points. */
function radius(a: Point, b: Point, c: Point): number {
  const cross = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  return (distance(a, b) * distance(b, c) * distance(c, a)) / (2 * cross);
}

describe('a random track', () => {
  const tracks = Array.from({ length: SEEDS }, (_, seed) => ({
    wish: wishOf(seed),
    scene: randomTrack(wishOf(seed), words),
  }));

  it('is the same for the same seed, and another for another', () => {
    const wish = wishOf(3);
    expect(randomTrack(wish, words)).toEqual(randomTrack(wish, words));
    const made = Array.from({ length: 50 }, (_, seed) => JSON.stringify(randomTrack({ ...wish, seed }, words)));
    expect(new Set(made).size).toBe(50);
  });

  it('is closed, and keeps away from the arena’s edge', () => {
    for (const { wish, scene } of tracks) {
      const points = lineOf(scene);
      expect(points[0]).toEqual(points.at(-1));
      for (const [x, y] of points)
        expect(Math.min(x, y, wish.size[0] - x, wish.size[1] - y)).toBeGreaterThanOrEqual(trackLimits.marginMm - 2);
    }
  });

  it('has no bend tighter than 120 mm, with 300 seeds', () => {
    for (const { wish, scene } of tracks) {
      const even = evenly(lineOf(scene));
      even.forEach((point, index) => {
        // Over 80 mm a point that is rounded to whole mm makes an arc of 120 mm look like one of 106 at worst.
        const [b, c] = [even[(index + 2) % even.length]!, even[(index + 4) % even.length]!];
        expect(radius(point, b, c), `seed ${String(wish.seed)}`).toBeGreaterThan(106);
      });
    }
  });

  it('comes no nearer than 60 mm to itself, edge to edge', () => {
    for (const { wish, scene } of tracks) {
      const even = evenly(lineOf(scene), 20);
      const apart = Math.ceil((Math.PI * trackLimits.radiusMm * 1.1) / 20); // beyond half a circle
      let nearest = Infinity;
      for (let i = 0; i < even.length; i += 1)
        for (let j = i + apart; j <= Math.min(even.length - 1, i + even.length - apart); j += 1)
          nearest = Math.min(nearest, distance(even[i]!, even[j]!));
      expect(nearest - 20, `seed ${String(wish.seed)}`).toBeGreaterThanOrEqual(trackLimits.gapMm);
    }
  });

  it('has the robot on the line, heading along it, with three checkpoints on the way round and the target at the start', () => {
    for (const { wish, scene } of tracks) {
      const points = lineOf(scene);
      const { at, heading } = scene.robot;
      const even = evenly(points, 2);
      expect(Math.min(...even.map((point) => distance(point, at)))).toBeLessThan(3);
      const ahead: Point = [at[0] + 40 * Math.cos((heading * Math.PI) / 180), at[1] + 40 * Math.sin((heading * Math.PI) / 180)]; // prettier-ignore
      expect(Math.min(...even.map((point) => distance(point, ahead))), `seed ${String(wish.seed)}`).toBeLessThan(4);
      const passed = scene.objects.flatMap((object) =>
        object.type === 'checkpoint' || object.type === 'target'
          ? [even.findIndex((point) => distance(point, object.at) < 4) / even.length]
          : [],
      );
      expect(passed).toHaveLength(4);
      expect(passed).not.toContain(-1 / even.length);
      expect(passed[0]! < passed[1]! && passed[1]! < passed[2]!, String(passed)).toBe(true); // in the order of driving
    }
  });

  it('bends both ways: hardly one in a hundred has to be the plain oval', () => {
    const ovals = tracks.filter(({ scene }) => {
      const even = evenly(lineOf(scene), 80);
      const turns = even.slice(2).map((c, index) => {
        const [a, b] = [even[index]!, even[index + 1]!];
        return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
      });
      return turns.every((turn) => turn > -400); // 80 mm of a bend of 400 mm radius make 1,280; rounding at most 160
    });
    expect(ovals.length).toBeLessThanOrEqual(SEEDS / 100);
  });

  it('refuses what it cannot draw, in words', () => {
    const wish: TrackWish = { seed: 1, bends: 8, size: [1200, 900] };
    expect(() => randomTrack({ ...wish, bends: 3 }, words)).toThrow('4 to 14 bends, not 3');
    expect(() => randomTrack({ ...wish, size: [1200, 600] }, words)).toThrow('900 to 4000 mm a side, not 1200 × 600');
  });
});
