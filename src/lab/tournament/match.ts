import type { Verdict } from '#simulation/task/verdict';
import type { Outcome, OutcomeReason } from '../outcome';

/** The programs of a match, by their places in the order in which they were given. */
export interface Pairing {
  /** Stands at the first start. */
  readonly a: number;
  /** Stands at the second start; `null`: the course is for one robot. */
  readonly b: number | null;
  readonly seed: number;
}

/** Why somebody has not won: the judge's reasons for one robot, too. */
export type MatchReason = OutcomeReason | 'caught' | 'beaten';

/** The result of a match, as plain data. */
export interface MatchResult {
  /** In a course for one robot `b`: it has not passed. */
  readonly winner: 'a' | 'b' | 'draw';
  /** Simulated time of the decision; `null`: there was none. */
  readonly atMs: number | null;
  /** Why the other one has not won, or why nobody has; `null`: one robot that has passed. */
  readonly reason: MatchReason | null;
  /** The fingerprint of its run; left out: it was stuck. */
  readonly traceHash?: string;
}

/** A match that was played. */
export interface Match extends Pairing, MatchResult {}

/** The result of a run of two robots, or of one that is alone. */
export function resultOfRun(
  { outcome, verdict }: { readonly outcome: Outcome; readonly verdict: Verdict | null },
  isAlone: boolean,
): MatchResult {
  const { atMs, reason, traceHash } = outcome;
  // A run that was stuck has none.
  const hash = traceHash ? { traceHash } : {};
  if (isAlone) return { winner: outcome.passed === true ? 'a' : 'b', atMs, reason, ...hash };
  const [a, b] = verdict?.robots ?? [];
  if (verdict === null || a === undefined || b === undefined)
    return { winner: 'draw', atMs: null, reason: reason ?? 'open', ...hash };
  const lead = ranks[a.state] - ranks[b.state] || timeOf(b) - timeOf(a) || 0;
  if (lead === 0) return { winner: 'draw', atMs, reason: reason ?? (verdict.atMs === null ? 'open' : 'time'), ...hash };
  const loser = lead > 0 ? b : a;
  return {
    winner: lead > 0 ? 'a' : 'b',
    atMs,
    reason: loser.reason ?? reason ?? (loser.state === 'open' ? 'open' : 'beaten'),
    ...hash,
  };
}

/** A robot that is out comes after one that was still on its way. */
const ranks = { passed: 2, open: 1, failed: 0 } as const;

/** Only among those that have passed the time counts. */
const timeOf = ({ state, atMs }: Verdict['robots'][number]): number => (state === 'passed' ? (atMs ?? 0) : 0);
