import type { Course } from '#catalogue/course';

import { shownLanguage } from '../../../kit/i18n';

/** A course's task in the chosen language. */
export const courseTask = (course: Course): string => course.texts[shownLanguage()].task;
