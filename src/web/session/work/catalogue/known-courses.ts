import type { Course } from '#catalogue/course';

import { arrival } from '../../../kit/state/arrival';

/** The courses whose names are here: they come with ready-courses.ts. */
export const knownCourses = arrival<readonly Course[]>();
