import { mostHints, USUAL_HINT, type MostHint } from '#check/task/most-hint';

import type { WorkParts } from '../../work/model/parts';
import type { TaskParts } from '../parts';

/** Number of runs without success after which there is a hint to the program. */
const FAILS = 2;

/** Number of levels of the hint to the program that there are now: as many as the task allows, in an exam none. */
export function ownLevels({ task: { own }, work }: TaskParts & Pick<WorkParts, 'work'>): number {
  const { hint = USUAL_HINT, exam } = work.work.value.project.task ?? {};
  if (own.fails.value < FAILS || exam !== undefined) return 0;
  return Math.min(own.most.value, Math.max(0, mostHints.indexOf(hint as MostHint)));
}
