import { describe, expect, it } from 'vitest';

import { placeMenu } from './place-menu';

const VIEW = { width: 400, height: 800 };
const MENU = { width: 200, height: 300 };
/** A button of 44 px with its corner there. */
const button = (left: number, top: number) => ({ left, top, right: left + 44, bottom: top + 44 });

describe('where a menu lies', () => {
  it('is 6 px below its button, in line with its left edge', () => {
    expect(placeMenu(button(50, 10), MENU, VIEW, 'bottom')).toEqual({ left: 50, top: 60, maxHeight: 776 });
    expect(placeMenu(button(50, 10), MENU, VIEW, 'bottom start')).toMatchObject({ left: 50 });
  });

  it('is in line with its right edge at its end', () => {
    expect(placeMenu(button(300, 10), MENU, VIEW, 'bottom end')).toMatchObject({ left: 144, top: 60 });
  });

  it('is 6 px above the button where it shall be there', () => {
    expect(placeMenu(button(50, 700), MENU, VIEW, 'top start')).toMatchObject({ left: 50, top: 394 });
  });

  it('is on the other side where there is not enough room', () => {
    expect(placeMenu(button(50, 600), MENU, VIEW, 'bottom')).toMatchObject({ top: 294 });
    expect(placeMenu(button(50, 100), MENU, VIEW, 'top')).toMatchObject({ top: 150 });
  });

  it('is in line with the other edge where only that leaves it in the window', () => {
    expect(placeMenu(button(300, 10), MENU, VIEW, 'bottom')).toMatchObject({ left: 144 });
    expect(placeMenu(button(20, 10), MENU, VIEW, 'bottom end')).toMatchObject({ left: 20 });
  });

  it('stays 12 px off the sides of the window', () => {
    expect(placeMenu(button(356, 10), MENU, VIEW, 'bottom')).toMatchObject({ left: 188 });
    expect(placeMenu(button(0, 10), MENU, VIEW, 'bottom end')).toMatchObject({ left: 12 });
  });

  it('goes over the button where neither side has room, and is no higher than the window', () => {
    expect(placeMenu(button(50, 300), { width: 200, height: 600 }, VIEW, 'bottom')).toMatchObject({ top: 188 });
    const long = placeMenu(button(50, 10), { width: 200, height: 5000 }, VIEW, 'bottom');
    expect(long).toMatchObject({ top: 12, maxHeight: 776 });
  });
});
