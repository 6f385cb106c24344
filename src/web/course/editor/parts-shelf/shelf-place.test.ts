import { describe, expect, it } from 'vitest';

import { shelfPlace } from './shelf-place';

const box = (left: number, top: number, width: number, height: number) => ({ left, top, width, height });

describe('the place of the shelf', () => {
  it('is at the left of the arena on a laptop, and no wider than 420 px', () => {
    const panes = box(8, 68, 1350, 692);
    expect(shelfPlace(box(660, 68, 698, 692), panes)).toEqual(box(8, 68, 420, 692));
    expect(shelfPlace(box(360, 68, 998, 692), panes)).toEqual(box(8, 68, 344, 692));
  });

  it('is above the arena on a tablet that is held upright', () => {
    expect(shelfPlace(box(8, 440, 804, 500), box(8, 68, 804, 1104))).toEqual(box(8, 68, 804, 364));
  });

  it('is over the lower part of the arena on a phone, and narrow where the arena is alone on a wide screen', () => {
    expect(shelfPlace(box(0, 60, 390, 724), box(0, 60, 390, 784))).toEqual(box(0, 490, 390, 354));
    expect(shelfPlace(box(0, 0, 1300, 700), box(0, 0, 1300, 700))).toEqual(box(0, 406, 650, 294));
  });
});
