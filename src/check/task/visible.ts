import type { CheckResult, Reason } from '../result';
import type { ClassTask } from './task';

/** The task as pupils know it: without the solution, and without hidden worlds or how many of them are wanted. */
export function visibleTask(task: ClassTask): ClassTask {
  const [first, ...others] = task.worlds;
  return { ...task, worlds: [first, ...others.filter(({ hidden }) => !hidden)], least: null, solution: null };
}

/** Why something is not passed: what a run has shown first, else what is asked of the program itself; `null`: it is. */
export function mainReason({ checks }: ClassTask, { checks: found, worlds }: CheckResult): Reason | null {
  const seen = worlds.find(({ reason }) => reason !== null)?.reason;
  const lacking = found.find(({ passed }, place) => !passed && checks[place]?.needed === true);
  return seen ?? lacking?.reason ?? null;
}
