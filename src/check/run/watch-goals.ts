import { usOf } from '#core/seconds';
import { reasonCode, type Reason } from '../result';
import type { Scene } from '#scene/scene';
import { Approach } from './approach';
import { failedAt, HELD, metAt, OPEN, type Standing, type Watcher } from './watcher';
import type { Verdict } from '#simulation/task/verdict';

/** Watches the goals and rules of the course. */
export function watchGoals(course: Scene): Watcher {
  const approach = course.task.robots === undefined ? new Approach(course) : null;
  let standing: Standing = OPEN;
  let verdict: Verdict | null = null;
  return {
    step: (run) => {
      if (standing !== OPEN) return;
      approach?.step(run);
      if (!run.isJudged) return;
      ({ verdict } = run);
      standing = verdict?.state === 'passed' ? metAt(run.nowUs) : failedAt(run.nowUs);
    },
    end: (run) => {
      verdict ??= run.verdict;
    },
    standing: () => standing,
    reason: () => reasonOf(verdict, approach, course.task.seconds),
  };
}

/** @param seconds the time of the course; `null`: it has none */
function reasonOf(verdict: Verdict | null, approach: Approach | null, seconds: number | null): Reason {
  if (verdict?.state === 'helped') return { code: 'helped', params: {} };
  const reached = reachedIn(verdict);
  const { reason = null, by = null } = verdict ?? {};
  const { nearestMm = null, leftUs = null } = approach ?? {};
  const way = {
    ...(leftUs !== null && { left: Math.round(leftUs / 100_000) / 10 }),
    ...(nearestMm !== null && { near: Math.ceil(nearestMm / 10) }),
  };
  if (reason === null) return { code: 'open', params: { ...reached, ...way } };
  const late = reason === 'time' && { ...(seconds !== null && { allowed: seconds }), ...way };
  return { code: reasonCode(reason), params: { by: by ?? '', ...reached, ...late } };
}

/** Number of goals reached, and of all goals. */
function reachedIn(verdict: Verdict | null): Reason['params'] {
  if (verdict === null) return { done: 0, of: 0 };
  const { checkpoints, targets, blocks } = verdict;
  return {
    done: checkpoints.passed + targets.reached + blocks.delivered,
    of: checkpoints.of + targets.of + blocks.of,
  };
}

/** Watches that the task's robots have at most so many touches. */
export function watchTouches(most: number): Watcher {
  let [touches, failedUs]: [number, number | null] = [0, null];
  return {
    step: (run) => {
      ({ touches } = run);
      if (touches > most) failedUs ??= run.nowUs;
    },
    standing: () => (failedUs === null ? HELD : failedAt(failedUs)),
    reason: () => ({ code: 'touches', params: { count: touches, most } }),
  };
}

/** Watches that all that has to be reached is not reached before this time. */
export function watchEarly(seconds: number): Watcher {
  let failedUs: number | null = null;
  return {
    clock: (nowUs, reachedUs) => {
      if (reachedUs !== null && reachedUs < usOf(seconds)) failedUs ??= nowUs;
    },
    standing: (): Standing => (failedUs === null ? HELD : failedAt(failedUs)),
    reason: () => ({ code: 'early', params: { seconds } }),
  };
}

/** Watches that not more time passes before all that has to be reached is reached. */
export function watchTime(seconds: number): Watcher {
  let failedUs: number | null = null;
  return {
    clock: (nowUs, reachedUs) => {
      const isLate = reachedUs === null ? nowUs >= usOf(seconds) : reachedUs > usOf(seconds);
      if (isLate) failedUs ??= nowUs;
    },
    standing: (): Standing => (failedUs === null ? HELD : failedAt(failedUs)),
    reason: () => ({ code: 'slow', params: { seconds } }),
  };
}
