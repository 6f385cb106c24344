import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';

import { shownLanguage } from '../page/i18n';
import type { RunParts } from '../run/parts';
import { firstCourse } from '../work/catalogue/first-course';
import { knownCourses } from '../work/catalogue/known-courses';
import type { WorkParts } from '../work/model/parts';
import { hasWords, taskText, type ShownText } from './task-text';

/** The task of the open course as a card. */
export interface TaskModel {
  /** What the card says. */
  readonly text: ComputedRef<ShownText>;
  /** Whether there is anything to read: then there is a card. */
  readonly hasText: ComputedRef<boolean>;
  readonly isOpen: Readonly<Ref<boolean>>;
  /** How many hints have been asked for since the course was opened. */
  readonly hints: ShallowRef<number>;
  open(): void;
  close(): void;
}

/**
 * Makes the card's model. The card opens with each other course that has something to read, and goes when a run starts:
 * the program is what is looked at then.
 *
 * @param isOwnPage whether nobody else tells the task: in the frame of another page the card waits to be asked for
 */
export function createTask(
  { work, run }: Pick<WorkParts, 'work'> & Pick<RunParts, 'run'>,
  isOwnPage: boolean,
): TaskModel {
  const isOpen = shallowRef(false);
  const hints = shallowRef(0);
  const ready = computed(() => {
    const id = work.work.value.project.course;
    return id === null ? null : ((knownCourses.value ?? [firstCourse]).find((course) => course?.id === id) ?? null);
  });
  const text = computed(() => taskText(work.scene.value, ready.value, shownLanguage()));
  const hasText = computed(() => hasWords(text.value));
  watch([work.openings, work.arrivals], () => {
    hints.value = 0;
    isOpen.value = isOwnPage && hasText.value;
  });
  watch(run.isActive, (isActive) => {
    if (isActive) isOpen.value = false;
  });
  return {
    text,
    hasText,
    isOpen: computed(() => isOpen.value && hasText.value),
    hints,
    open: () => void (isOpen.value = true),
    close: () => void (isOpen.value = false),
  };
}
