import type { Scene } from '#scene/scene';

import { shownLanguage } from '../../../kit/i18n';
import { firstCourse } from '../../../session/work/catalogue/first-course';
import { knownCourses } from '../../../session/work/catalogue/known-courses';

/**
 * The task of a course: in the pupil's language if it is ready-made, otherwise as its author wrote it. `id`: of a
 * ready-made course.
 */
export function courseTask(scene: Scene, id: string | null): string {
  const course = (knownCourses.value ?? [firstCourse]).find((one) => one?.id === id);
  return course?.texts[shownLanguage()].task ?? scene.description;
}
