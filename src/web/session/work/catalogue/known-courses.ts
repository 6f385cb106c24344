import type { Course } from '#catalogue/course';

import { arrival } from '../../../kit/state/arrival';

/** The ready courses; `null` until `ready-courses.ts` is loaded. */
export const knownCourses = arrival<readonly Course[]>();
