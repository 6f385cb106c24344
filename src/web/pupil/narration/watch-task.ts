import type { Verdict } from '#simulation/task/verdict';
import type { Moment } from './moment';
import type { News, Watcher } from './news';

/**
 * Finds out what the robot touches and reaches. What decides the task is left to the verdict, which has words of its
 * own for it.
 *
 * @param numbers the numbers of the course's checkpoints, in the order in which they count
 */
export function watchTask(numbers: () => readonly number[]): Watcher {
  let before: Moment | null = null;
  return (seen) => {
    const last = before;
    before = seen;
    if (last === null || isDecided(last, seen)) return [];
    const touch: readonly News[] = seen.touches > last.touches ? [{ topic: 'touch', seen }] : [];
    if (last.verdict === null || seen.verdict === null) return touch;
    return [...touch, ...reached(last.verdict, seen.verdict, seen)];
  };

  function reached(last: Verdict, now: Verdict, seen: Moment): readonly News[] {
    const news: News[] = [];
    const { passed } = now.checkpoints;
    if (passed > last.checkpoints.passed)
      news.push({ topic: 'checkpoint', number: numbers()[passed - 1] ?? passed, seen });
    if (now.targets.reached > last.targets.reached)
      news.push({ topic: 'target', done: now.targets.reached, of: now.targets.of, seen });
    if (now.blocks.delivered > last.blocks.delivered)
      news.push({ topic: 'block', done: now.blocks.delivered, of: now.blocks.of, seen });
    return news;
  }
}

/** True if the task was decided between two moments. */
export const isDecided = (last: Moment, now: Moment): boolean =>
  last.verdict?.state === 'open' && now.verdict !== null && now.verdict.state !== 'open';
