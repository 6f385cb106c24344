import { describe, expect, it } from 'vitest';

import { dayNumber, dayOf, weekOf } from './day';

describe('a day of the calendar', () => {
  it('is as many days after 1 January of year 1 as JavaScript’s calendar says', () => {
    const first = Date.UTC(2000, 0, 1) - dayNumber('2000-01-01')! * 86_400_000;
    for (let ms = Date.UTC(1899, 11, 28); ms < Date.UTC(2105, 0, 4); ms += 86_400_000)
      expect(dayNumber(new Date(ms).toISOString().slice(0, 10))).toBe((ms - first) / 86_400_000);
  });

  it.each([
    '2026-02-29',
    '2100-02-29',
    '2026-13-01',
    '2026-00-10',
    '2026-04-31',
    '0000-01-01',
    '2026-1-1',
    'today',
    '',
  ])('is none if it is %j', (day) => expect(dayNumber(day)).toBeNull());

  it('is written with its year first, whatever its numbers', () =>
    expect([dayOf(2026, 11, 30), dayOf(987, 1, 2)]).toEqual(['2026-11-30', '0987-01-02']));

  // ISO 8601: week 1 has the year's first Thursday.
  it.each([
    ['2026-11-30', 2026, 49],
    ['2026-01-01', 2026, 1],
    ['2027-01-03', 2026, 53],
    ['2027-01-04', 2027, 1],
    ['2024-12-30', 2025, 1],
    ['2021-01-03', 2020, 53],
    ['2023-01-01', 2022, 52],
  ])('%s lies in week %i of year, number %i', (day, year, week) => expect(weekOf(day)).toEqual({ year, week }));
});
