import type { Scene } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { firstCourse } from '../../work/catalogue/first-course';
import { knownCourses } from '../../work/catalogue/known-courses';

/** What a course asks for: a ready one in the pupil's language, else as its author has written. `id`: of a ready one. */
export function courseTask(scene: Scene, id: string | null): string {
  const course = (knownCourses.value ?? [firstCourse]).find((one) => one?.id === id);
  return course?.texts[shownLanguage()].task ?? scene.description;
}
