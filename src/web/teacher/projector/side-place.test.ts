import { describe, expect, it } from 'vitest';

import { sidePlace } from './side-place';

const SQUARE = 4 / 3;

describe('the place of task and timer', () => {
  it('is beside the course on what a projector shows', () => {
    expect(sidePlace(1280, 720, SQUARE)).toEqual({ kind: 'beside', px: 461 });
    expect(sidePlace(1920, 1080, SQUARE)).toEqual({ kind: 'beside', px: 691 });
  });

  it('takes what a course leaves that is narrower than its room', () => {
    expect(sidePlace(1366, 625, SQUARE)).toEqual({ kind: 'beside', px: 618 });
    expect(sidePlace(1920, 1080, 0.5)).toEqual({ kind: 'beside', px: 960 });
  });

  it('is above a course that is much wider than high', () => {
    expect(sidePlace(1280, 720, 3).kind).toBe('above');
  });

  it.each([
    ['a tablet held upright', 820, 1180],
    ['a phone', 390, 844],
    ['a small phone', 320, 568],
  ])('is above the course on %s, and leaves it two fifths of the height', (_, width, height) => {
    const { kind, px } = sidePlace(width, height, SQUARE);
    expect(kind).toBe('above');
    expect(px).toBeGreaterThanOrEqual(200);
    expect(px).toBeLessThanOrEqual(0.6 * height);
  });

  it('is beside the course on a phone held across', () => {
    expect(sidePlace(844, 390, SQUARE)).toEqual({ kind: 'beside', px: 409 });
  });
});
