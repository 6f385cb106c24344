import type { Course } from '#catalogue/course';

import { shownLanguage } from '../../../kit/i18n';

/** A course's description in the chosen language. */
export const courseText = (course: Course): string => course.texts[shownLanguage()].text;

/** A course's task in the chosen language. */
export const courseTask = (course: Course): string => course.texts[shownLanguage()].task;
