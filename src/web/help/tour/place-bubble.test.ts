import { describe, expect, it } from 'vitest';

import { placeBubble, type Box } from './place-bubble';

const view = { width: 1000, height: 800 };
const bubble = { width: 300, height: 200 };
const boxAt = (left: number, top: number, width: number, height: number): Box => ({ left, top, width, height });
const covers = (target: Box): boolean => {
  const { left, top } = placeBubble(target, bubble, view);
  return (
    left < target.left + target.width &&
    target.left < left + bubble.width &&
    top < target.top + target.height &&
    target.top < top + bubble.height
  );
};

describe('the bubble of the tour', () => {
  it('stands below a button of the bar', () => {
    const { left, top } = placeBubble(boxAt(400, 8, 120, 44), bubble, view);
    expect(top).toBeGreaterThan(52);
    expect(left).toBe(310);
  });

  it('stands above what fills the foot, and beside what is as high as the window', () => {
    expect(placeBubble(boxAt(0, 590, 1000, 210), bubble, view).top).toBeLessThan(390);
    expect(placeBubble(boxAt(0, 60, 400, 740), bubble, view).left).toBeGreaterThan(400);
    expect(placeBubble(boxAt(600, 60, 400, 740), bubble, view).left).toBeLessThan(300);
  });

  it('covers nothing that it points at, wherever there is room for both', () => {
    for (const left of [0, 300, 870])
      for (const top of [0, 350, 750]) expect(covers(boxAt(left, top, 120, 44)), `${left} ${top}`).toBe(false);
  });

  it('leaves the beginning of what fills a phone in sight', () => {
    const phone = { width: 390, height: 844 };
    const { top } = placeBubble(boxAt(0, 108, 390, 676), { width: 360, height: 200 }, phone);
    expect(top).toBe(844 - 200 - 8);
  });

  it('is always in the window', () => {
    for (const target of [boxAt(-50, -50, 40, 40), boxAt(990, 790, 80, 80), boxAt(0, 0, 1000, 800), null]) {
      const { left, top } = placeBubble(target, bubble, view);
      expect(left).toBeGreaterThanOrEqual(8);
      expect(top).toBeGreaterThanOrEqual(8);
      expect(left + bubble.width).toBeLessThanOrEqual(view.width);
      expect(top + bubble.height).toBeLessThanOrEqual(view.height);
    }
  });

  it('begins in the window where it is larger than the window', () => {
    expect(placeBubble(null, { width: 400, height: 300 }, { width: 320, height: 240 })).toEqual({ left: 8, top: 8 });
  });
});
