import { describe, expect, it } from 'vitest';
import type { Mover } from '#scene/scene';
import { moverSprite, spriteCorner, wayWindow } from './mover-sprite';
import { toPx } from '../view/view-transform';

const mover: Mover = { type: 'mover', id: 'm', at: [200, 300], to: [500, 300], size: [60, 80], angle: 0, speed: 100, spiked: false }; // prettier-ignore

describe('the canvas of a moving obstacle', () => {
  it('has room for it however it is turned, and for its shadow: 116 px for 60 × 80 mm at 1 px per mm', () => {
    const sprite = moverSprite(mover, 1);
    expect(sprite.sidePx).toBe(116);
    expect(toPx(sprite.view, { x: 200, y: 300 })).toEqual({ x: 58, y: 58 });
  });

  it('lies around where the obstacle is', () => {
    const view = { pxPerMm: 1, leftPx: 0, bottomPx: 900 };
    const sprite = moverSprite(mover, 1);
    expect(spriteCorner(sprite, view, mover, null)).toEqual({ x: 142, y: 542 });
    expect(spriteCorner(sprite, view, mover, { xMm: 250, yMm: 310, headingRad: 0 })).toEqual({ x: 192, y: 532 });
  });

  it('covers all of its way, but nothing out of sight', () => {
    const view = { pxPerMm: 1, leftPx: 0, bottomPx: 900 };
    const sight = { left: 0, top: 0, width: 1200, height: 900 };
    expect(wayWindow(mover, view, sight, 1)).toEqual({ left: 142, top: 542, width: 416, height: 116 });
    expect(wayWindow(mover, view, { ...sight, left: 300 }, 1)).toMatchObject({ left: 300, width: 258 });
    expect(wayWindow(mover, view, { ...sight, left: 700 }, 1)).toMatchObject({ width: 0 });
  });
});
