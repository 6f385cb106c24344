import { isSame } from '#core/same';
import { MOST_RUNS } from './values';
import { readVaried, type Base, type Value, type Varied } from './what';

type Problem = { readonly problem: string };

/** The things that vary together: each value of one with each of the others. */
export interface Sweep {
  readonly varied: readonly Varied[];
  /** Number of runs. */
  readonly count: number;
}

/**
 * Reads several `WHAT=VALUES`.
 *
 * @returns or a sentence that begins with the place
 */
export function readSweep(texts: readonly string[], base: Base): Sweep | Problem {
  const varied: Varied[] = [];
  for (const text of texts) {
    const one = readVaried(text, base);
    if ('problem' in one) return one;
    const twice = varied.find(({ what }) => isSame(what, one.what));
    if (twice !== undefined) return { problem: `${one.name}: varies already, as ${twice.name}.` };
    varied.push(one);
  }
  const count = varied.reduce((product, { values }) => product * values.length, 1);
  if (count <= MOST_RUNS) return { varied, count };
  const factors = varied.map(({ name, values }) => `${name} (${values.length})`).join(' × ');
  return { problem: `${factors}: ${count} runs are too many, at most ${MOST_RUNS}.` };
}

/** The values of one run, by its place from 0: the first thing changes slowest. */
export function valuesOf({ varied }: Sweep, place: number): readonly Value[] {
  let rest = place;
  const values: Value[] = [];
  for (const one of varied.toReversed()) {
    values.unshift(one.values[rest % one.values.length] ?? 0);
    rest = Math.floor(rest / one.values.length);
  }
  return values;
}
