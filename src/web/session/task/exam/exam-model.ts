import { computed, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';

import { HAND_IN_VERSION } from '#check/hand-in/hand-in';
import { handInCode } from '#check/hand-in/hand-in-code';
import { begunAt } from '#check/task/exam';
import { examIn } from '#check/task/read-task';

import { lateModel, type WithLate } from '../../../kit/state/late-models';
import { isHandedOut } from '../../work/model/task-locks';
import type { WorkParts } from '../../work/model/parts';

/** The state of an exam: `none` where the open task is none; nothing is written before it began and after it is over. */
export type ExamState = 'none' | 'waiting' | 'running' | 'over';

/** The exam of the open task. Its begin goes with the work, over a reload, too. */
export interface ExamModel {
  readonly state: ComputedRef<ExamState>;
  readonly minutes: ComputedRef<number>;
  /** Time left in whole seconds. */
  readonly leftS: ComputedRef<number>;
  /** The code of the program as it is now. */
  readonly code: ComputedRef<string>;
  begin(): void;
}

/** The exam of this page. */
export const examOf = lateModel((app: WithLate & Pick<WorkParts, 'work'>) => createExam(app));

function createExam({ work }: Pick<WorkParts, 'work'>): ExamModel {
  const project = computed(() => work.work.value.project);
  const exam = computed(() => (isHandedOut(project.value) ? examIn(project.value.task) : null));
  const begunMs = computed(() => begunAt(project.value.handIn));
  const nowMs = shallowRef(Date.now());
  const leftMs = computed(() => {
    if (exam.value === null || begunMs.value === null) return 0;
    return Math.max(0, begunMs.value + exam.value.minutes * 60_000 - nowMs.value);
  });
  const state = computed((): ExamState => {
    if (exam.value === null) return 'none';
    if (begunMs.value === null) return 'waiting';
    return leftMs.value > 0 ? 'running' : 'over';
  });
  let timer: ReturnType<typeof setInterval> | undefined;
  watch(
    [state, begunMs],
    () => {
      clearInterval(timer);
      nowMs.value = Date.now();
      if (state.value === 'running') timer = setInterval(() => (nowMs.value = Date.now()), 500);
    },
    { immediate: true },
  );
  onScopeDispose(() => clearInterval(timer));
  return {
    state,
    minutes: computed(() => exam.value?.minutes ?? 0),
    leftS: computed(() => Math.ceil(leftMs.value / 1000)),
    code: computed(() => handInCode(project.value)),
    begin() {
      if (state.value !== 'waiting') return;
      nowMs.value = Date.now();
      work.setHandIn({ version: HAND_IN_VERSION, ...project.value.handIn, begunMs: nowMs.value });
    },
  };
}
