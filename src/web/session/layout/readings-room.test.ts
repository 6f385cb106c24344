import { describe, expect, it } from 'vitest';

import { readingsPx } from './readings-room';

const foot = { distance: true, lidar: false, bumper: false };

describe('the room for readings under the arena', () => {
  it('is enough for the five numbers of a Plus V2 with 413 px, beside a screen 1440 px wide, not for the six of a Plus V1', () => {
    expect(readingsPx({ ...foot, count: 5, digits: 3 })).toBeLessThan(413);
    expect(readingsPx({ ...foot, count: 6, digits: 3 })).toBeGreaterThan(413);
  });

  it('is the same for one digit as for three: the numbers do not come and go as they change', () => {
    expect(readingsPx({ ...foot, count: 2, digits: 1 })).toBe(readingsPx({ ...foot, count: 2, digits: 3 }));
  });

  it('counts the lidar of a Plus V3: five numbers and its distance have room in 413 px', () => {
    expect(readingsPx({ ...foot, distance: false, lidar: true, count: 5, digits: 3 })).toBeLessThan(413);
    expect(readingsPx({ ...foot, lidar: true, count: 5, digits: 3 })).toBeGreaterThan(413);
  });

  it('counts the bumper of a Calli:bot', () => {
    expect(readingsPx({ ...foot, bumper: true, count: 2, digits: 3 })).toBeCloseTo(369.8, 5);
  });
});
