import { computed, watch, type ComputedRef } from 'vue';

import type { CheckResult, Reason } from '#check/result';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { mainReason, visibleTask } from '#check/task/visible';

import { CheckRun, type CheckPorts } from '../../run/check-run';
import type { RunParts } from '../../run/parts';
import type { WorkParts } from '../../work/model/parts';

/**
 * State of a task that asks for more than the goals of its course. `live`: only the run's own verdict is shown;
 * `checking`: the run has come far enough, but the check is not over; `lacking`: something is missing.
 */
export type CheckedState = 'live' | 'checking' | 'passed' | 'lacking';

/** The result of a pupil's program in a teacher's task, checked beside the run as the teacher will. */
export interface Checked {
  /** The task as pupils know it; `null`: it asks for nothing but the goals of its course. */
  readonly task: ComputedRef<ClassTask | null>;
  readonly state: ComputedRef<CheckedState>;
  /** The result; `null`: it is not shown yet. */
  readonly result: ComputedRef<CheckResult | null>;
  /** The first unmet check. */
  readonly reason: ComputedRef<Reason | null>;
}

/**
 * Checks the program again from the start of each run, in a worker of its own, and shows the result when the run itself
 * has come as far. The goals of the course then count as reached only if all other checks are met.
 */
export function createChecked(
  { work, run }: Pick<WorkParts, 'work'> & Pick<RunParts, 'run'>,
  ports?: CheckPorts,
): Checked {
  const check = new CheckRun(ports);
  const project = computed(() => work.work.value.project);
  const task = computed(() => {
    const read = taskOf(project.value);
    const isMore = 'task' in read && read.task.checks.some(({ type }) => type !== 'goals');
    return isMore ? visibleTask(read.task) : null;
  });
  /** True if the course's own goals count: a task may ask for something else in a course with targets. */
  const asksGoals = computed(() => task.value?.checks.some(({ type }) => type === 'goals') === true);
  const begin = (): void => void (task.value !== null && check.run(task.value, project.value));
  function clear(): void {
    check.stop();
    check.result.value = null;
  }
  watch(run.phase, (phase) => (phase === 'starting' ? begin() : phase === 'ready' && clear()), { flush: 'sync' });
  watch(work.openings, clear);
  if (run.isActive.value) begin();

  const live = computed(() => run.snapshot.value?.verdict?.state ?? 'open');
  const found = check.result;
  /**
   * True if the result may be shown: the run has reached the goals or, without goals, the time of the check, or is
   * over. Of a moment of the past the same is asked: the end of the run is not known there.
   */
  const isTime = computed(() => {
    const isEarlier = run.look.isEarlier.value;
    if (live.value === 'passed' || (run.hasEnded.value && !isEarlier)) return true;
    if (asksGoals.value || run.present.value === null) return false;
    const { atMs } = found.value?.worlds[0] ?? { atMs: null };
    return (!run.isActive.value && !isEarlier) || (atMs !== null && run.nowUs.value >= atMs * 1000);
  });
  const state = computed<CheckedState>(() => {
    const isDecided = asksGoals.value && (live.value === 'failed' || live.value === 'helped');
    if (task.value === null || isDecided || !isTime.value) return 'live';
    if (found.value === null) return check.isRunning.value ? 'checking' : 'live';
    return found.value.passed ? 'passed' : 'lacking';
  });
  const isTold = computed(() => state.value === 'passed' || state.value === 'lacking');
  const result = computed(() => (isTold.value ? found.value : null));
  return {
    ...{ task, state, result },
    reason: computed(() => task.value && result.value && mainReason(task.value, result.value)),
  };
}
