import { describe, expect, it } from 'vitest';

import type { SweepRun } from '#lab/sweep-texts';
import { meaningOf, stretchesOf } from './meaning';

const run = (value: number, atMs: number | null, passed: boolean | null = atMs !== null): SweepRun => ({
  ...{ values: [value], passed, atMs, touches: 0, reason: passed === false ? 'open' : null },
  ...{ xMm: 0, yMm: 0, headingDeg: 0, pathMm: 0, traceHash: '' },
});
const missed = (value: number): SweepRun => run(value, null);

describe('what a curve means', () => {
  it('is where it works, and on which side it is faster', () =>
    expect(meaningOf([missed(1), run(2, 100), run(3, 110), run(4, 130), missed(5)])).toEqual({
      ...{ kind: 'between', from: 2, to: 4, faster: 'smaller' },
    }));

  it('names the longest of several stretches, also on the way down', () =>
    expect(meaningOf([run(9, 5), missed(8), run(7, 130), run(6, 120), run(5, 110)])).toEqual({
      ...{ kind: 'several', from: 5, to: 7, faster: 'smaller' },
    }));

  it('makes no rule of what goes up and down, or hardly changes', () => {
    expect(meaningOf([run(1, 100), run(2, 90), run(3, 110)])?.faster).toBeNull();
    expect(meaningOf([run(1, 1000), run(2, 1001), run(3, 1002)])).toMatchObject({ kind: 'all', faster: null });
  });

  it('says when nothing works, one alone does, or there is nothing to pass', () => {
    expect(meaningOf([missed(1), missed(2)])?.kind).toBe('none');
    expect(meaningOf([missed(1), run(2, 5)])?.kind).toBe('one');
    expect(meaningOf([run(1, 5, null)])?.kind).toBe('free');
    expect(meaningOf([])).toBeNull();
  });

  it('parts the misses by their reasons', () => {
    const touched = { ...missed(2), reason: 'touched' as const };
    expect(stretchesOf([missed(1), touched, run(3, 5), run(4, 6)]).map(({ reason, runs }) => [reason, runs.length])).toEqual([
      ['open', 1],
      ['touched', 1],
      [null, 2],
    ]); // prettier-ignore
  });
});
