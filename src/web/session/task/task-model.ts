import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';

import { hintsAllowed } from '#check/task/chosen-level';
import { shownLanguage } from '../../kit/i18n';
import { useFirstMatch } from '../../kit/use-first-match';
import type { CardForm } from '../layout/layout-model';
import type { RunParts } from '../run/parts';
import { firstCourse } from '../work/catalogue/first-course';
import { knownCourses } from '../work/catalogue/known-courses';
import type { Course } from '#catalogue/course';
import type { Scene } from '#scene/scene';
import type { WorkParts } from '../work/model/parts';
import { isSameArena } from '../work/catalogue/same-arena';
import type { Checked } from './checked/checked';
import { goalsInWords } from './goals';
import type { OwnHintState } from './own-hint/own-levels';
import { createHandIn, type HandInModel } from './hand-in';
import { createKeptStars, type KeptStars } from './kept-stars';
import { hasWords, taskText, type ShownText } from '../work/catalogue/task-text';

/** The task of the open course as a card. */
export interface TaskModel {
  /** The text of the card. */
  readonly text: ComputedRef<ShownText>;
  /** True if there is anything to read. */
  readonly hasText: ComputedRef<boolean>;
  /** True if the card is unfolded. */
  readonly isOpen: Readonly<Ref<boolean>>;
  /** True if what stands in the card’s place is unfolded. */
  readonly isUnfolded: Readonly<Ref<boolean>>;
  /** The form of the card; `null`: there is none, because there is nothing to do or nobody has asked for it. */
  readonly card: ComputedRef<CardForm | null>;
  /** True while a drive takes the place of the card where there is room for one alone, unless the card was asked for. */
  readonly givesWay: ComputedRef<boolean>;
  /** True from the opening of a task until its card has taken the keys and said what there is to do. */
  readonly isNew: ShallowRef<boolean>;
  /** Number of hints asked for since the course was opened. */
  readonly hints: ShallowRef<number>;
  /** The hint to the pupil's own program. */
  readonly own: OwnHintState;
  /** The ready course that is open, changed or not. */
  readonly ready: ComputedRef<Course | null>;
  /** The best results in this browser. */
  readonly stars: KeptStars;
  /** The state of the teacher's checks besides the goals of the course; `null`: nothing has shown it yet. */
  readonly checked: ShallowRef<Checked | null>;
  readonly handIn: HandInModel;
  /** Unfolds the card. */
  open(): void;
  /** Unfolds it as that of a task that was just opened. */
  present(): void;
  /** Folds it to its title line; one that only a request has opened goes. */
  close(): void;
}

/**
 * Makes the card's model. A task that has goals, or was written by somebody, always has its card, which unfolds when it
 * is opened; the text of a ready course without goals is shown on request alone.
 *
 * @param isOwnPage false in the frame of another page: there the card opens only on request
 * @param store storage for the stars; `null`: they last as long as the page is open
 */
export function createTask(
  { work, run, settings }: WorkParts & Pick<RunParts, 'run'>,
  isOwnPage: boolean,
  store: Storage | null,
): TaskModel {
  const isAsked = shallowRef(false);
  const own = { fails: shallowRef(0), level: shallowRef(0), most: shallowRef(4) };
  const [hints, isNew] = [shallowRef(0), shallowRef(false)];
  const { givesWay, isWanted, isTiny } = useWay(run);
  const isUnfolded = computed(() => settings.current.value.showCard && (!isTiny.value || isWanted.value));
  const ready = computed(() => {
    const id = work.work.value.project.course;
    return id === null ? null : ((knownCourses.value ?? [firstCourse]).find((course) => course?.id === id) ?? null);
  });
  const hasGoals = computed(() => goalsInWords(work.scene.value, null).length > 0);
  const text = computed(() => withHints(textOf(work.scene.value, ready.value, hasGoals.value), work));
  const hasText = computed(() => hasWords(text.value) || isForTask(work));
  const isKept = computed(() => {
    const { course, task } = work.work.value.project;
    return isOwnPage && (course === null || task !== undefined || hasGoals.value);
  });
  const isOpen = computed(() => hasText.value && (isKept.value ? isUnfolded.value : isAsked.value));
  const show = (isShown: boolean): void => {
    isAsked.value = isShown;
    if (isKept.value) settings.change({ showCard: isShown });
  };
  watch([work.openings, work.arrivals], () => {
    hints.value = own.fails.value = own.level.value = 0;
    isAsked.value = isWanted.value = false;
    isNew.value = isKept.value;
    if (isKept.value) show(true);
  });
  const stars = createKeptStars(store);
  keepStars(run, work, ready, stars);
  return {
    text,
    hasText,
    ready,
    stars,
    ...{ isOpen, isUnfolded },
    card: computed(() => (isOpen.value ? 'open' : isKept.value && hasText.value ? 'folded' : null)),
    givesWay,
    isNew,
    ...{ hints, own },
    checked: shallowRef(null),
    handIn: createHandIn({ work }),
    open() {
      isWanted.value = true;
      show(true);
    },
    present() {
      isNew.value = true;
      show(true);
    },
    close() {
      isWanted.value = false;
      if (!isTiny.value) show(false);
    },
  };
}

/** True if the work was made for a task that has a card without words, too: it was handed out, or its line is scored. */
const isForTask = ({ work, scene }: WorkParts['work']): boolean =>
  work.value.project.task !== undefined || scene.value.league !== undefined;

/** Goals that were drawn on a floor without any are a task of their own: the floor's words do not speak of it. */
function textOf(scene: Scene, ready: Course | null, hasGoals: boolean): ShownText {
  if (ready !== null && hasGoals && goalsInWords(ready.scene, null).length === 0)
    return taskText({ ...scene, ...withoutWordsOf(ready.scene, scene) }, null, shownLanguage());
  return taskText(scene, ready, shownLanguage());
}

/** The text with as many hints as the chosen level allows. */
const withHints = ({ hints, ...words }: ShownText, { work }: WorkParts['work']): ShownText => ({
  ...words,
  hints: hints.slice(0, hintsAllowed(work.value.project.task)),
});

/**
 * When a drive takes the card's place, and a very low window, which has no room for text and course; `isWanted`: the card
 * was asked for since the present run began.
 */
function useWay(run: RunParts['run']) {
  const isWanted = shallowRef(false);
  watch(run.isActive, () => (isWanted.value = false));
  const isTiny = useFirstMatch([[true, '(max-height: 439px)']], false);
  return {
    givesWay: computed(() => run.isActive.value && !run.isOver.value && !isWanted.value && run.past.value === null),
    isWanted,
    isTiny,
  };
}

/** Name and description of a course, as far as they are not those of the one that it was drawn on. */
const withoutWordsOf = (first: Scene, { name, description }: Scene): Pick<Scene, 'name' | 'description'> => ({
  name: name === first.name ? '' : name,
  description: description === first.description ? '' : description,
});

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
    const verdict = run.present.value?.verdict; // whoever looks back wins nothing again
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
