import { computed, onBeforeUnmount, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import type { CheckResult } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { isSame } from '#core/same';

import { CheckRun } from '../../session/run/check-run';
import type { TroubleKey } from '../../session/run/worker/firmware-trouble';

/** The model solution's run in all worlds of a task. */
export interface SolutionRun {
  /** The newest result, perhaps of the task before its last change; `null`: there is none, or no solution. */
  readonly result: Readonly<ShallowRef<CheckResult | null>>;
  /** True until the result is that of the task as it is now. */
  readonly isOld: ComputedRef<boolean>;
  /** Reason for which nothing can be run; `null`: it can. */
  readonly failure: Readonly<ShallowRef<TroubleKey | null>>;
}

/** After a change that goes on, such as typing, only its end is run. Chosen, in ms. */
const SETTLED_MS = 500;

/** Runs the model solution of a task whenever something has changed, as long as its page is open. */
export function useSolutionRun(task: () => ClassTask | null): SolutionRun {
  const run = new CheckRun();
  const shown = shallowRef<CheckResult | null>(null);
  const waits = shallowRef(false);
  let timer: ReturnType<typeof setTimeout> | undefined;
  async function start(now: ClassTask): Promise<void> {
    waits.value = false;
    await run.run(now, now.solution && { ...now.project, files: now.solution });
    if (run.result.value !== null) shown.value = run.result.value;
  }
  watch(
    task,
    (now, before) => {
      if (before !== undefined && isSame(now, before)) return;
      clearTimeout(timer);
      run.stop();
      waits.value = now !== null && now.solution !== null;
      if (now === null || now.solution === null) shown.value = null;
      else timer = setTimeout(() => void start(now), before === undefined ? 0 : SETTLED_MS);
    },
    { immediate: true },
  );
  onBeforeUnmount(() => {
    clearTimeout(timer);
    run.stop();
  });
  return { result: shown, isOld: computed(() => waits.value || run.isRunning.value), failure: run.failure };
}
