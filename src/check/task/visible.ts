import type { CheckResult, Reason } from '../result';
import type { ClassTask } from './task';

/** The task as pupils know it: without the solution, and without hidden worlds or how many of them are wanted. */
export function visibleTask(task: ClassTask): ClassTask {
  const [first, ...others] = task.worlds;
  return { ...task, worlds: [first, ...others.filter(({ hidden }) => !hidden)], least: null, solution: null };
}

/** Why a hand-in has not passed: the first reason of a run, else that of a needed check; `null`: there is none. */
export function mainReason({ checks }: ClassTask, { checks: found, worlds }: CheckResult): Reason | null {
  const seen = worlds.find(({ reason }) => reason !== null)?.reason;
  const lacking = found.find(({ passed }, place) => !passed && checks[place]?.needed === true);
  return seen ?? lacking?.reason ?? null;
}
