import type { Course } from '#catalogue/course';

import { shownLanguage } from '../../../kit/i18n';

/** What a course says about itself, in the chosen language. */
export const courseText = (course: Course): string => course.texts[shownLanguage()].text;

/** What a course asks for, in the chosen language. */
export const courseTask = (course: Course): string => course.texts[shownLanguage()].task;
