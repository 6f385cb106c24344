import { describe, expect, it } from 'vitest';

import { filmTimes, firstStretch, stripForm, stripTimes, withEnd } from './stretch';

const seconds = (from: number, to: number) => ({ fromUs: from * 1e6, toUs: to * 1e6 });

describe('a stretch of a run', () => {
  it('is at first ten seconds around the moment that is looked at', () => {
    expect(firstStretch(20e6, 60e6)).toEqual(seconds(15, 25));
    expect(firstStretch(2e6, 60e6)).toEqual(seconds(0, 10));
    expect(firstStretch(59e6, 60e6)).toEqual(seconds(50, 60));
  });

  it('is all of a run of seven seconds', () => expect(firstStretch(3e6, 7e6)).toEqual(seconds(0, 7)));

  it('has ends that stay within the run and do not pass each other', () => {
    expect(withEnd(seconds(2, 5), 'fromUs', -3e6, 9e6)).toEqual(seconds(0, 5));
    expect(withEnd(seconds(2, 5), 'fromUs', 8e6, 9e6)).toEqual(seconds(4.8, 5));
    expect(withEnd(seconds(2, 5), 'toUs', 1e6, 9e6)).toEqual(seconds(2, 2.2));
    expect(withEnd(seconds(2, 5), 'toUs', 12e6, 9e6)).toEqual(seconds(2, 9));
  });
});

describe('a strip', () => {
  it('has its first picture at the beginning, its last at the end, the others evenly between', () => {
    expect(stripTimes(seconds(1, 4), 4)).toEqual([1e6, 2e6, 3e6, 4e6]);
    expect(stripTimes(seconds(0, 1), 4)).toEqual([0, 340_000, 660_000, 1e6]); // moments of the tape: every 20 ms
  });

  it.each([
    [4, 4, 1],
    [5, 3, 2],
    [6, 3, 2],
    [7, 4, 2],
    [9, 3, 3],
    [12, 4, 3],
  ])('of %i pictures has %i in a row, and %i rows', (count, columns, rows) =>
    expect(stripForm(count)).toEqual({ columns, rows }),
  );
});

describe('a film', () => {
  it('has a picture every 80 ms, and the last one at the end', () => {
    expect(filmTimes(seconds(1, 1.24))).toEqual([1_000_000, 1_080_000, 1_160_000, 1_240_000]);
    expect(filmTimes(seconds(0, 0.2))).toEqual([0, 80_000, 160_000, 200_000]);
  });
});
