import { describe, expect, it } from 'vitest';
import { inkBox } from './ink-layer';

describe('the small canvas with the newest piece of a line', () => {
  const view = { pxPerMm: 2, leftPx: 0, bottomPx: 1000 };
  const path = [
    { x: 0, y: 0 },
    { x: 100, y: 100 },
    { x: 120, y: 90 },
  ];

  it('covers this piece only, with half its width and 4 px around', () => {
    expect(inkBox({ path, width: 20, color: 'black' }, 1, view)).toEqual({
      left: 176,
      top: 776,
      width: 88,
      height: 68,
    });
  });

  it('is empty when there is nothing new', () => {
    expect(inkBox({ path, width: 20, color: 'black' }, 3, view)).toMatchObject({ width: 0, height: 0 });
  });
});
