import { describe, expect, it } from 'vitest';
import { within, zoomed } from './span';

describe('the stretch of time that is shown', () => {
  it('is halved around the place that is pointed at', () =>
    expect(zoomed([0, 10], [0, 10], 5, 0.5)).toEqual([2.5, 7.5]));
  it('keeps that place where it is', () => expect(zoomed([0, 10], [0, 10], 2, 0.5)).toEqual([1, 6]));
  it('is the whole where that is asked for', () => expect(zoomed([2, 8], [0, 10], 5, 2)).toBeNull());
  it('is never shorter than 0.1 s', () => expect(zoomed([5, 5.1], [0, 10], 5.05, 0.1)).toEqual([5, 5.1]));
  it('does not leave the whole', () => {
    expect(within([-2, 3], [0, 10])).toEqual([0, 5]);
    expect(within([8, 12], [0, 10])).toEqual([6, 10]);
  });
});
