import { isSame } from '#core/same';
import type { OutcomeReason } from '#lab/outcome';
import type { SweepRun } from '#lab/sweep-texts';

/** Runs side by side that came to the same. */
export interface Stretch {
  readonly passed: boolean | null;
  readonly reason: OutcomeReason | null;
  readonly runs: readonly SweepRun[];
}

/** The stretches of the runs of one thing that varies, in their order. */
export function stretchesOf(runs: readonly SweepRun[]): readonly Stretch[] {
  const stretches: { passed: boolean | null; reason: OutcomeReason | null; runs: SweepRun[] }[] = [];
  for (const run of runs) {
    const last = stretches.at(-1);
    const reason = run.passed === true ? null : run.reason;
    if (last !== undefined && isSame([last.passed, last.reason], [run.passed, reason])) last.runs.push(run);
    else stretches.push({ passed: run.passed, reason, runs: [run] });
  }
  return stretches;
}

/** What the curve of one thing that varies means. */
export interface Meaning {
  /** `free`: the course has no task. */
  readonly kind: 'all' | 'none' | 'one' | 'between' | 'several' | 'free';
  /** The ends of the longest stretch that passes. */
  readonly from: number;
  readonly to: number;
  /** Where the time is shorter within it: at smaller or larger values. `null`: nowhere in particular. */
  readonly faster: 'smaller' | 'larger' | null;
}

/** Reads the curve of one thing that varies; `null`: no run is there yet. */
export function meaningOf(runs: readonly SweepRun[]): Meaning | null {
  if (runs.length === 0) return null;
  const nothing = { from: 0, to: 0, faster: null };
  if (runs.every(({ passed }) => passed === null)) return { kind: 'free', ...nothing };
  const good = stretchesOf(runs).filter(({ passed }) => passed === true);
  const longest = good.reduce<Stretch | null>(
    (best, one) => (best === null || one.runs.length > best.runs.length ? one : best),
    null,
  );
  if (longest === null) return { kind: 'none', ...nothing };
  const ends = [Number(longest.runs[0]?.values[0]), Number(longest.runs.at(-1)?.values[0])];
  const [from, to] = [Math.min(...ends), Math.max(...ends)];
  const isAll = longest.runs.length === runs.length;
  const kind = isAll ? 'all' : good.length > 1 ? 'several' : from === to ? 'one' : 'between';
  return { kind, from, to, faster: fasterAt(longest.runs) };
}

/** Least share by which the time must change over a stretch to be worth a word. */
const WORTH = 0.01;

function fasterAt(runs: readonly SweepRun[]): Meaning['faster'] {
  const inOrder = runs.toSorted((one, other) => Number(one.values[0]) - Number(other.values[0]));
  const times = inOrder.flatMap(({ atMs }) => (atMs === null ? [] : [atMs]));
  const [first, last] = [times[0], times.at(-1)];
  if (times.length < 3 || first === undefined || last === undefined) return null;
  if (Math.abs(last - first) < WORTH * Math.max(first, last)) return null;
  const sign = Math.sign(last - first);
  const isSteady = times.every((time, place) => place === 0 || sign * (time - (times[place - 1] ?? time)) >= 0);
  if (!isSteady) return null;
  return sign > 0 ? 'smaller' : 'larger';
}
