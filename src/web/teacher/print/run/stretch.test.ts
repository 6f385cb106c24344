import { describe, expect, it } from 'vitest';

import { filmed, filmTimes, firstStretch, stripForm, stripTimes, withEnd } from './stretch';

const seconds = (from: number, to: number) => ({ fromUs: from * 1e6, toUs: to * 1e6 });

describe('a stretch of a run', () => {
  it('is at first the whole run, up to the moment at which its task was done', () => {
    expect(firstStretch(60e6, { state: 'passed', atMs: 28_404 })).toEqual(seconds(0, 28.42));
    expect(firstStretch(60e6, { state: 'failed', atMs: 5000 })).toEqual(seconds(0, 60));
    expect(firstStretch(7e6, null)).toEqual(seconds(0, 7));
  });

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
  it('of a longer run is at first of its last half minute', () => {
    expect(filmed(seconds(0, 43))).toEqual(seconds(13, 43));
    expect(filmed(seconds(2, 9))).toEqual(seconds(2, 9));
  });

  it('has a picture every 80 ms, and the last one at the end', () => {
    expect(filmTimes(seconds(1, 1.24))).toEqual([1_000_000, 1_080_000, 1_160_000, 1_240_000]);
    expect(filmTimes(seconds(0, 0.2))).toEqual([0, 80_000, 160_000, 200_000]);
  });
});
