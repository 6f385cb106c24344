import type { CheckResult, WorldResult } from '#check/result';
import type { ClassTask, WorldVariant } from '#check/task/task';

/** A world of a task with its place and what came out there. */
export interface Failed {
  readonly place: number;
  readonly world: WorldVariant;
  readonly result: WorldResult | null;
}

/** The first world in which a program does not pass; the first of all if only its text is wrong. */
export function failedIn({ worlds }: ClassTask, result: CheckResult): Failed {
  const place = Math.max(0, result.worlds.findIndex(({ passed }) => !passed)); // prettier-ignore
  return { place, world: worlds[place] ?? worlds[0], result: result.worlds[place] ?? null };
}
