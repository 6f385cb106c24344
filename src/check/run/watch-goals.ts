import { goalReason, type Reason } from '../result';
import { failedAt, HELD, metAt, OPEN, type Standing, type Watcher } from './watcher';
import type { Verdict } from '#simulation/task/verdict';

/** Watches the goals and rules of the course. */
export function watchGoals(): Watcher {
  let verdict: Verdict | null = null;
  return {
    glance: (now) => {
      verdict = now.verdict;
    },
    standing: () => {
      if (verdict === null || verdict.atMs === null) return OPEN;
      const atUs = verdict.atMs * 1000;
      return verdict.state === 'passed' ? metAt(atUs) : failedAt(atUs);
    },
    reason: () => reasonOf(verdict),
  };
}

function reasonOf(verdict: Verdict | null): Reason {
  if (verdict?.state === 'helped') return { code: 'helped', params: {} };
  const reached = reachedIn(verdict);
  const { reason = null, by = null } = verdict ?? {};
  return reason === null
    ? { code: 'open', params: reached }
    : { code: goalReason(reason), params: { by: by ?? '', ...reached } };
}

/** What was reached, and of how much. */
function reachedIn(verdict: Verdict | null): Reason['params'] {
  if (verdict === null) return { done: 0, of: 0 };
  const { checkpoints, targets, blocks } = verdict;
  return {
    done: checkpoints.passed + targets.reached + blocks.delivered,
    of: checkpoints.of + targets.of + blocks.of,
  };
}

/** Watches that the first robot touches nothing more often than that. */
export function watchTouches(most: number): Watcher {
  let [touches, failedUs]: [number, number | null] = [0, null];
  return {
    glance: (now) => {
      ({ touches } = now);
      if (touches > most) failedUs ??= now.timeUs;
    },
    standing: () => (failedUs === null ? HELD : failedAt(failedUs)),
    reason: () => ({ code: 'touches', params: { count: touches, most } }),
  };
}

/** Watches that not more time passes before all that has to be reached is reached. */
export function watchTime(seconds: number): Watcher {
  let failedUs: number | null = null;
  return {
    glance: ({ timeUs, reachedUs }) => {
      if ((reachedUs ?? timeUs) > seconds * 1_000_000) failedUs ??= timeUs;
    },
    standing: (): Standing => (failedUs === null ? HELD : failedAt(failedUs)),
    reason: () => ({ code: 'slow', params: { seconds } }),
  };
}
