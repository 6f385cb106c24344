import { shallowRef } from 'vue';

import type { Course } from '#catalogue/course';

/** The courses whose names are here: set by ready-courses.ts once it is there; `null` as long as it has not come. */
export const knownCourses = shallowRef<readonly Course[] | null>(null);
