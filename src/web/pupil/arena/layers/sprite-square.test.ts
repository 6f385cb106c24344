import { describe, expect, it } from 'vitest';
import type { Mover } from '#scene/scene';
import { spritePlace, wayWindow } from './sprite-place';
import { spriteSquare } from './sprite-square';
import { toPx } from '../view/view-transform';

const mover: Mover = { type: 'mover', id: 'm', at: [200, 300], to: [500, 300], size: [60, 80], angle: 0, speed: 100, spiked: false }; // prettier-ignore

describe('the canvas of a moving obstacle', () => {
  it('has room for it however it is turned, and for its shadow: 116 px for 60 × 80 mm at 1 px per mm', () => {
    const sprite = spriteSquare(mover, 1);
    expect(sprite.sidePx).toBe(116);
    expect(toPx(sprite.view, { x: 200, y: 300 })).toEqual({ x: 58, y: 58 });
  });

  it('lies where the obstacle is, turned as far as that has turned', () => {
    const view = { pxPerMm: 1, leftPx: 0, bottomPx: 900 };
    expect(spritePlace(view, mover, null)).toEqual({ x: 200, y: 600, turnedRad: 0 });
    const pose = { xMm: 250, yMm: 310, headingRad: 2 };
    expect(spritePlace(view, mover, pose)).toEqual({ x: 250, y: 590, turnedRad: 2 });
  });

  it('covers all of its way, but nothing out of sight', () => {
    const view = { pxPerMm: 1, leftPx: 0, bottomPx: 900 };
    const sight = { left: 0, top: 0, width: 1200, height: 900 };
    expect(wayWindow(mover, view, sight, 1)).toEqual({ left: 142, top: 542, width: 416, height: 116 });
    expect(wayWindow({ ...mover, stops: [[500, 500]] }, view, sight, 1)).toMatchObject({ top: 342, height: 316 });
    expect(wayWindow(mover, view, { ...sight, left: 300 }, 1)).toMatchObject({ left: 300, width: 258 });
    expect(wayWindow(mover, view, { ...sight, left: 700 }, 1)).toMatchObject({ width: 0 });
  });
});
