import { describe, expect, it } from 'vitest';

import { fittingSize, sizeLimits } from './fitting-size';

describe('the size of the task on the projector', () => {
  it('goes with the picture: as large on the wall, however many pixels that is', () => {
    expect(sizeLimits(1280, 720)).toEqual({ least: 23, most: 36 });
    expect(sizeLimits(1920, 1080)).toEqual({ least: 34, most: 54 });
  });

  it('is that of a page on a phone', () => expect(sizeLimits(390, 844)).toEqual({ least: 16, most: 20 }));

  it.each([
    [36, 100],
    [36, 36],
    [30, 30],
    [23, 23],
    [23, 5],
  ])('is %i px where up to %i px fit', (size, room) =>
    expect(fittingSize({ least: 23, most: 36 }, (px) => px <= room)).toBe(size),
  );
});
