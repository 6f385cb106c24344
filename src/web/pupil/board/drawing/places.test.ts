import { describe, expect, it } from 'vitest';
import * as calliope from './calliope-places';
import * as microbit from './microbit-places';

/** The narrowest board the page shows, in px, and the least size of what a finger hits. */
const NARROWEST_PX = 180;
const FINGER_PX = 44;

/** Half the size of what is drawn, in units: within the area of another key nothing of it may lie. */
const boards = [
  { name: 'micro:bit', width: 260, places: microbit, half: 15 },
  { name: 'Calliope mini', width: 252, places: calliope, half: 14 },
];

describe.each(boards)('what a finger hits on the $name', ({ width, places, half }) => {
  const keys = [...places.BUTTONS, places.LOGO, ...places.PINS].map(({ key, x, y, hitX, hitY }) => ({
    ...{ key, x, y },
    left: hitX,
    top: hitY,
    right: hitX + places.HIT,
    bottom: hitY + places.HIT,
  }));

  it('is at least 44 px wide and high on a board of 180 px', () => {
    expect((places.HIT * NARROWEST_PX) / width).toBeGreaterThanOrEqual(FINGER_PX);
  });

  it('holds the key itself, and no part of another key', () => {
    for (const area of keys)
      for (const { key, x, y } of keys) {
        const inside = x > area.left && x < area.right && y > area.top && y < area.bottom;
        expect([area.key, key, inside]).toEqual([area.key, key, area.key === key]);
        const beside =
          x + half <= area.left || x - half >= area.right || y + half <= area.top || y - half >= area.bottom;
        if (area.key !== key) expect([area.key, key, beside]).toEqual([area.key, key, true]);
      }
  });

  it('never belongs to two keys', () => {
    for (const one of keys)
      for (const other of keys) {
        if (one.key === other.key) continue;
        const apart =
          one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top;
        expect([one.key, other.key, apart]).toEqual([one.key, other.key, true]);
      }
  });
});
