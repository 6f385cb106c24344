import { isUnread } from '#check/report/texts';
import type { CheckResult } from '#check/result';

/** True of a hand-in whose run has to be looked at. */
export const needsRun = (result: CheckResult): boolean =>
  !result.passed && !isUnread(result) && !isForOtherTask(result);

/** True of a hand-in that belongs to another task. */
export const isForOtherTask = ({ remarks }: CheckResult): boolean => remarks.some(({ code }) => code === 'other-task');
