import { describe, expect, it } from 'vitest';

import { courses } from '#catalogue/courses';

import { matchView } from './match-view';

const viewOf = (course: string) => matchView(courses.find(({ id }) => id === course)!.scene);

describe('what is shown of a match', () => {
  it('is the ring with some room beside it, and of a race the whole arena', () => {
    expect(viewOf('sumo')).toEqual({ minX: 180, minY: 180, maxX: 1320, maxY: 1320 });
    expect(viewOf('lead')).toMatchObject({ minX: 0, minY: 0 });
  });

  it('does not reach beyond the arena', () => {
    const { minX, minY } = viewOf('clear-the-ring');
    expect(Math.min(minX, minY)).toBeGreaterThanOrEqual(0);
  });
});
