import { computed, shallowRef, type ComputedRef } from 'vue';

import type { CourseChanges } from '#scene/edit';
import type { Scene, TaskCard, TaskText } from '#scene/scene';

import { shownLanguage } from '../../../kit/i18n';
import { courseName } from '../../../session/work/catalogue/first-course';
import { useWork } from '../../../session/work/model/parts';
import { useCourseEditor } from '../state/parts';
import { courseTask } from './course-task';
import { cardOf, firstLanguage, withWords, wordsIn, type WordsPart } from './task-changes';

/** The words of the open course's task, in the language in which they are being written. */
export interface TaskWords {
  readonly scene: ComputedRef<Scene>;
  readonly card: ComputedRef<TaskCard>;
  readonly language: ComputedRef<string>;
  readonly now: ComputedRef<Omit<TaskText, 'language'>>;
  /** With the one that has been asked for but not written yet. */
  readonly hints: ComputedRef<readonly string[]>;
  /** The name of the course; empty if it has none: what the page calls such a course is not its name. */
  nameNow(): string;
  /** Gives the course a name of its own: a ready one becomes the author's own course, with the words that are shown. */
  rename(name: string): void;
  choose(language: string): void;
  change(changes: CourseChanges): void;
  write(part: WordsPart): void;
  addHint(): void;
  /** An empty hint goes. */
  setHint(at: number, hint: string): void;
}

export function useTaskWords(): TaskWords {
  const { work } = useWork();
  const { editor } = useCourseEditor();
  const { scene } = work;
  const courseId = computed(() => work.work.value.project.course);
  const shown = computed(() => courseTask(scene.value, courseId.value));
  const chosen = shallowRef<string | null>(null);
  const language = computed(() => chosen.value ?? firstLanguage(scene.value, shownLanguage()));
  const now = computed(() => wordsIn(scene.value, language.value, shownLanguage(), shown.value));
  const hasBlank = shallowRef(false);
  const hints = computed(() => (hasBlank.value ? [...now.value.hints, ''] : now.value.hints));
  const nameNow = (): string =>
    courseId.value === null && scene.value.name === '' ? '' : courseName(scene.value, courseId.value);
  /** The words of a ready course that an author's own takes along: the empty arena has none of a task. */
  const taken = (): string => (courseId.value === 'empty' ? '' : shown.value);
  function change(changes: CourseChanges): void {
    if (Object.keys(changes).length > 0) editor.apply({ type: 'course', changes });
  }
  function write(part: WordsPart): void {
    const { description, ...changes } = withWords(scene.value, language.value, shownLanguage(), part);
    if (description === undefined || description === shown.value) change(changes);
    else change({ ...changes, description, name: nameNow() }); // reworded, it becomes the pupil's own course, which keeps its name
  }
  return {
    ...{ scene, language, now, hints, nameNow, change, write },
    card: computed(() => cardOf(scene.value)),
    rename: (name) => change(courseId.value === null ? { name } : { name, description: taken() }),
    choose(next) {
      chosen.value = next;
      hasBlank.value = false;
    },
    addHint: () => (hasBlank.value = true),
    setHint(at, hint) {
      const next = hints.value.map((old, index) => (index === at ? hint : old)).filter((one) => one !== '');
      hasBlank.value = false;
      if (next.join('\n') !== now.value.hints.join('\n')) write({ hints: next });
    },
  };
}
