import { expect, it } from 'vitest';

import { courseIds } from './course-ids';
import { courses } from './courses';

it('the ids of the ready courses are known without the courses', () => {
  expect([...courseIds].sort()).toEqual(courses.map(({ id }) => id).sort());
});
