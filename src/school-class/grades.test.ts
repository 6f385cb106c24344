import { describe, expect, it } from 'vitest';

import { gradeOf, usualScale, type Scale, type SystemId } from './grades';

const grades = (scale: Scale, of: number): readonly (number | null)[] =>
  Array.from({ length: of + 1 }, (_, points) => gradeOf(scale, points, of));

describe('grades', () => {
  it.each<[SystemId, readonly number[]]>([
    ['ch6', [1, 2.5, 3.5, 5, 6]],
    ['de6', [6, 4.5, 3.5, 2, 1]],
    ['de15', [0, 4, 8, 11, 15]],
    ['fr20', [0, 5, 10, 15, 20]],
    ['it10', [0, 2.5, 5, 7.5, 10]],
  ])('of %s rise evenly from no points to four of four, half steps to the better one', (system, those) =>
    expect(grades(usualScale(system), 4)).toEqual(those),
  );

  it('of Switzerland are halves: 8 of 16 is 3.5, 18 of 20 is 5.5, 19 of 20 is 6', () => {
    const scale = usualScale('ch6');
    expect([gradeOf(scale, 8, 16), gradeOf(scale, 18, 20), gradeOf(scale, 19, 20)]).toEqual([3.5, 5.5, 6]);
  });

  it.each<[SystemId, number]>([
    ['ch6', 4],
    ['de6', 4],
    ['de15', 5],
    ['fr20', 10],
    ['it10', 6],
  ])('of %s are %d at the threshold, whatever share it is', (system, pass) => {
    for (const passPercent of [10, 50, 60, 90])
      expect(gradeOf({ ...usualScale(system), passPercent }, passPercent, 100)).toBe(pass);
  });

  it('rise evenly on both sides of a threshold', () =>
    expect(grades({ system: 'ch6', passPercent: 50, step: 0.1 }, 10)).toEqual([
      1, 1.6, 2.2, 2.8, 3.4, 4, 4.4, 4.8, 5.2, 5.6, 6,
    ]));

  it('are none where there are no points to have, and no better than the best', () => {
    expect(gradeOf(usualScale('ch6'), 0, 0)).toBeNull();
    expect(gradeOf(usualScale('ch6'), 7, 4)).toBe(6);
  });
});
