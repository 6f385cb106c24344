import { describe, expect, it } from 'vitest';

import { projectOf } from './course';
import { readyCourseOf, withStart } from './starts';

describe('a ready course as a task for a class', () => {
  it.each(['closed-line', 'forward-maqueen-lite'])('has boards that feel the arena, as pupils have it: %s', (id) => {
    const course = readyCourseOf(id)!;
    expect(withStart(projectOf(course, 'de'), course).settings?.arenaSenses).toBe(true);
  });
});
