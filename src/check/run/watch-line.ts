import { metAt, OPEN, type Standing, type Watcher } from './watcher';

/** Watches that the robot reaches so many tiles of a league's line, the start aside. */
export function watchTiles(count: number): Watcher {
  const reached = new Set<number>();
  let standing: Standing = OPEN;
  let [tile, lacks] = [0, 0];
  return {
    step: ({ nowUs, verdict }) => {
      const points = verdict?.points;
      if (standing !== OPEN || points === undefined) return;
      // After a lack of progress it is put onto a tile, maybe over a section that then does not count.
      if (points.lacks === lacks) for (let next = tile + 1; next <= points.tile; next += 1) reached.add(next);
      ({ tile, lacks } = points);
      if (reached.size >= count) standing = metAt(nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'tiles', params: { done: reached.size, of: count } }),
  };
}

/** Watches that the robot comes to so many points by the rules of a league. */
export function watchScore(least: number): Watcher {
  let standing: Standing = OPEN;
  let score = 0;
  return {
    step: ({ nowUs, verdict }) => {
      if (standing !== OPEN) return;
      score = verdict?.points?.score ?? 0;
      if (score >= least) standing = metAt(nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'score', params: { found: score, least } }),
  };
}
