import { expect, it } from 'vitest';

import { courseIds } from './course-ids';
import { readyCourses } from './ready-courses';

it('the ids of the ready courses are known without the courses', () => {
  expect([...courseIds].sort()).toEqual(readyCourses.map(({ id }) => id).sort());
});
