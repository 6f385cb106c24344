import { describe, expect, it } from 'vitest';

import { placeMenu } from './place-menu';

const view = { width: 1000, height: 600 };
/** A button of 44 px with its corner at 500, 100. */
const button = { left: 500, right: 544, top: 100, bottom: 144 };
const at = (left: number, top: number) => ({ left, right: left + 44, top, bottom: top + 44 });
const menu = { width: 300, height: 200 };

describe('placeMenu', () => {
  it('puts a menu 6 px below its button, in line with its left edge', () =>
    expect(placeMenu(button, menu, view, 'bottom')).toEqual({ left: 500, top: 150, maxHeight: 438 }));

  it('puts it in line with the right edge where it shall end', () =>
    expect(placeMenu(button, menu, view, 'bottom end').left).toBe(544 - 300));

  it('puts it 6 px above its button where it shall be above', () =>
    expect(placeMenu(at(500, 400), menu, view, 'top start')).toEqual({ left: 500, top: 400 - 6 - 200, maxHeight: 382 }));

  it('puts it on the other side if there is more room', () => {
    expect(placeMenu(at(500, 500), menu, view, 'bottom').top).toBe(500 - 6 - 200);
    expect(placeMenu(button, menu, view, 'top').top).toBe(150);
  });

  it('lets it scroll, 12 px from the edge of the window, if no side has room', () => {
    const { top, maxHeight } = placeMenu(button, { width: 300, height: 900 }, view, 'bottom');
    expect({ top, end: top + maxHeight }).toEqual({ top: 150, end: 588 });
    const above = placeMenu(at(500, 500), { width: 300, height: 900 }, view, 'bottom');
    expect({ top: above.top, end: above.top + above.maxHeight }).toEqual({ top: 12, end: 494 });
  });

  it('lets it cover its button in a low window, where it would have less than 240 px', () => {
    const low = { width: 800, height: 360 };
    expect(placeMenu(at(100, 150), menu, low, 'bottom')).toEqual({ left: 100, top: 148, maxHeight: 336 });
    expect(placeMenu(at(100, 150), { width: 300, height: 700 }, low, 'bottom').top).toBe(12);
  });

  it('is in line with the other edge where only that leaves it in the window', () => {
    expect(placeMenu(at(50, 100), menu, view, 'bottom end').left).toBe(50);
    expect(placeMenu(at(900, 100), menu, view, 'bottom').left).toBe(944 - 300);
  });

  it('stays in a narrow window, 12 px from its edge', () => {
    const phone = { width: 390, height: 844 };
    expect(placeMenu(at(150, 8), menu, phone, 'bottom').left).toBe(390 - 12 - 300);
    expect(placeMenu(at(150, 8), menu, phone, 'bottom end').left).toBe(12);
    expect(placeMenu(at(150, 8), { width: 380, height: 100 }, phone, 'bottom').left).toBe(12);
  });
});
