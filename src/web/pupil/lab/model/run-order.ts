import type { Sweep } from '#lab/sweep';

/** The coarsest steps leave about so many stretches of a range. Chosen: a first picture within a second. */
const FIRST_STRETCHES = 8;

/** How fine a raster must be to hit a place of so many: 0 is the coarsest. The ends are always hit. */
function fineness(place: number, of: number): number {
  if (place === of - 1) return 0;
  let step = 1;
  while (step * 2 * FIRST_STRETCHES < of) step *= 2;
  let level = 0;
  for (; place % step !== 0; step /= 2) level += 1;
  return level;
}

/**
 * The order in which the runs of a sweep are made: coarse steps first, then between. Robots and chance have no between.
 * The result does not depend on it.
 */
export function runOrder({ varied, count }: Sweep): readonly number[] {
  const levels = varied.map(({ values, what }) =>
    values.map((_, place) => (what.kind === 'seed' ? 0 : fineness(place, values.length))),
  );
  const levelOf = (run: number): number => {
    let [rest, level] = [run, 0];
    for (const of of levels.toReversed()) {
      level = Math.max(level, of[rest % of.length] ?? 0);
      rest = Math.floor(rest / of.length);
    }
    return level;
  };
  return Array.from({ length: count }, (_, run) => ({ run, level: levelOf(run) }))
    .sort((one, other) => one.level - other.level || one.run - other.run)
    .map(({ run }) => run);
}
