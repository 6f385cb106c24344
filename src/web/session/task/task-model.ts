import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';

import { shownLanguage } from '../../kit/i18n';
import type { RunParts } from '../run/parts';
import { firstCourse } from '../work/catalogue/first-course';
import { knownCourses } from '../work/catalogue/known-courses';
import type { Course } from '#catalogue/course';
import type { WorkParts } from '../work/model/parts';
import { isSameArena } from '../work/catalogue/same-arena';
import type { Checked } from './checked/checked';
import { goalsInWords } from './goals';
import { createHandIn, type HandInModel } from './hand-in';
import { createKeptStars, type KeptStars } from './kept-stars';
import { hasWords, taskText, type ShownText } from '../work/catalogue/task-text';

/** The task of the open course as a card. */
export interface TaskModel {
  /** The text of the card. */
  readonly text: ComputedRef<ShownText>;
  /** True if there is anything to read: then there is a card. */
  readonly hasText: ComputedRef<boolean>;
  readonly isOpen: Readonly<Ref<boolean>>;
  /** Number of hints asked for since the course was opened. */
  readonly hints: ShallowRef<number>;
  /** The ready course that is open, changed or not. */
  readonly ready: ComputedRef<Course | null>;
  /** The best results in this browser. */
  readonly stars: KeptStars;
  /** The state of the teacher's checks besides the goals of the course; `null`: nothing has shown it yet. */
  readonly checked: ShallowRef<Checked | null>;
  readonly handIn: HandInModel;
  open(): void;
  close(): void;
}

/**
 * Makes the card's model. The card opens with each newly opened course that has a text, a ready one only if it has
 * goals, and closes when a run starts.
 *
 * @param isOwnPage false in the frame of another page: there the card opens only on request
 * @param store storage for the stars; `null`: they last as long as the page is open
 */
export function createTask(
  { work, run }: Pick<WorkParts, 'work'> & Pick<RunParts, 'run'>,
  isOwnPage: boolean,
  store: Storage | null,
): TaskModel {
  const isOpen = shallowRef(false);
  const hints = shallowRef(0);
  const ready = computed(() => {
    const id = work.work.value.project.course;
    return id === null ? null : ((knownCourses.value ?? [firstCourse]).find((course) => course?.id === id) ?? null);
  });
  const text = computed(() => taskText(work.scene.value, ready.value, shownLanguage()));
  const hasText = computed(() => hasWords(text.value) || work.work.value.project.task !== undefined);
  /** True if the course has goals; without one, the card of a ready course opens only on request. */
  const hasGoals = computed(() => goalsInWords(work.scene.value, null).length > 0);
  watch([work.openings, work.arrivals], () => {
    hints.value = 0;
    isOpen.value = isOwnPage && hasText.value && (ready.value === null || hasGoals.value);
  });
  watch(run.isActive, (isActive) => {
    if (isActive) isOpen.value = false;
  });
  const stars = createKeptStars(store);
  keepStars(run, work, ready, stars);
  return {
    text,
    hasText,
    ready,
    stars,
    isOpen: computed(() => isOpen.value && hasText.value),
    hints,
    checked: shallowRef(null),
    handIn: createHandIn({ work }),
    open: () => void (isOpen.value = true),
    close: () => void (isOpen.value = false),
  };
}

/**
 * Stores the stars that a run has won and its program, in a ready course that is unchanged and with the robot of its
 * mission. A run out of a file does not count.
 */
function keepStars(
  run: RunParts['run'],
  work: WorkParts['work'],
  ready: ComputedRef<Course | null>,
  stars: KeptStars,
): void {
  const won = computed(() => {
    const verdict = run.snapshot.value?.verdict;
    return verdict?.state === 'passed' ? (verdict.stars ?? 0) : 0;
  });
  watch(won, (count) => {
    const course = ready.value;
    if (count === 0 || course === null || run.recording.value.isBrought) return;
    if (!isSameArena(course.scene, work.scene.value)) return;
    const robot = run.snapshot.value?.robot?.type;
    if (course.mission !== undefined && course.mission.robot !== robot) return;
    stars.keep(course.id, count);
    const { setup } = run.recording.value;
    const timeMs = run.snapshot.value?.verdict?.atMs ?? 0;
    void import('../work/programs/own-programs').then(({ filesOfRun, keepBest }) => {
      if (setup !== null)
        keepBest(work, course.id, { atMs: Date.now(), files: filesOfRun(setup), stars: count, timeMs });
    });
  });
}
