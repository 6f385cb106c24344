import type { ShallowRef } from 'vue';

import { mostHints, USUAL_HINT, type MostHint } from '#check/task/most-hint';

import type { WorkParts } from '../../work/model/parts';

/** The hint to the pupil's own program: when there is one, and how much of it was asked for. */
export interface OwnHintState {
  /** Number of runs since the task was opened that did not reach it. */
  readonly fails: ShallowRef<number>;
  /** Number of levels asked for. */
  readonly level: ShallowRef<number>;
  /** Number of levels that there are, as far as known. */
  readonly most: ShallowRef<number>;
}

/** Number of runs without success after which there is a hint to the program. */
const FAILS = 2;

/** Number of levels of the hint to the program that there are now: as many as the task allows, in an exam none. */
export function ownLevels(own: OwnHintState, { work }: Pick<WorkParts, 'work'>): number {
  const { hint = USUAL_HINT, exam } = work.work.value.project.task ?? {};
  if (own.fails.value < FAILS || exam !== undefined) return 0;
  return Math.min(own.most.value, Math.max(0, mostHints.indexOf(hint as MostHint)));
}
