import { describe, expect, it } from 'vitest';
import {
  backingRatio,
  fitView,
  followView,
  panView,
  placeView,
  resizeView,
  toMm,
  toPx,
  zoomLimits,
  zoomPercent,
  zoomView,
  type ArenaSize,
} from './view-transform';

const arena: ArenaSize = [1200, 900];
const canvas = { widthPx: 868, heightPx: 654 }; // 800 px and 600 px are left for the arena

describe('the view of the arena', () => {
  it('shows the whole arena of 1200 mm on 800 px, with room for the rulers', () => {
    const view = fitView(arena, canvas);
    expect(view.pxPerMm).toBeCloseTo(2 / 3, 6);
    expect(toPx(view, { x: 0, y: 0 })).toEqual({ x: 42, y: 618 });
    const corner = toPx(view, { x: 1200, y: 900 });
    expect(corner.x).toBeCloseTo(842);
    expect(corner.y).toBeCloseTo(18);
  });

  it('takes the smaller room on a phone of 390 px', () => {
    const view = fitView(arena, { widthPx: 390, heightPx: 480 });
    expect(view.pxPerMm).toBeCloseTo(346 / 1200, 6);
  });

  it('leads from mm to px and back to the same place', () => {
    const view = zoomView(fitView(arena, canvas), 3, { x: 300, y: 200 }, arena, canvas);
    const back = toMm(view, toPx(view, { x: 123, y: 456 }));
    expect(back.x).toBeCloseTo(123, 6);
    expect(back.y).toBeCloseTo(456, 6);
  });

  it('keeps the place under the pointer when it zooms in by 2', () => {
    const before = fitView(arena, canvas);
    const pointer = { x: 400, y: 300 };
    const after = zoomView(before, 2, pointer, arena, canvas);
    expect(toMm(after, pointer).x).toBeCloseTo(toMm(before, pointer).x, 6);
    expect(toMm(after, pointer).y).toBeCloseTo(toMm(before, pointer).y, 6);
    expect(zoomPercent(after, arena, canvas)).toBeCloseTo(200, 6);
  });

  it('zooms out to 50 % at most and keeps the arena in the middle there', () => {
    const view = zoomView(fitView(arena, canvas), 0.01, { x: 0, y: 0 }, arena, canvas);
    expect(zoomPercent(view, arena, canvas)).toBeCloseTo(50, 6);
    expect(toPx(view, { x: 600, y: 450 })).toEqual({ x: 442, y: 318 });
  });

  it('zooms in to 8 px per mm', () => {
    expect(zoomLimits(arena, canvas).max).toBe(8);
    expect(zoomView(fitView(arena, canvas), 1e6, { x: 0, y: 0 }, arena, canvas).pxPerMm).toBe(8);
  });

  it('does not scroll beyond the arena: 10,000 px to the right end at its left edge', () => {
    const zoomed = zoomView(fitView(arena, canvas), 2, { x: 400, y: 300 }, arena, canvas);
    expect(panView(zoomed, { x: 10_000, y: 0 }, arena, canvas).leftPx).toBe(42);
  });

  it('keeps the centre in the centre when the pane gets 200 px narrower', () => {
    const zoomed = zoomView(fitView(arena, canvas), 3, { x: 434, y: 327 }, arena, canvas);
    const narrower = { widthPx: 668, heightPx: 654 };
    const before = toMm(zoomed, { x: 434, y: 327 });
    const after = toMm(resizeView(zoomed, arena, canvas, narrower), { x: 334, y: 327 });
    expect(after.x).toBeCloseTo(before.x, 6);
    expect(after.y).toBeCloseTo(before.y, 6);
  });

  it('draws at the ratio 2 of the screen, but with no more than 5 million pixels', () => {
    expect(backingRatio({ widthPx: 700, heightPx: 500 }, 2)).toBe(2);
    expect(backingRatio({ widthPx: 2000, heightPx: 1250 }, 3)).toBeCloseTo(Math.SQRT2, 6);
  });
});

describe('a place that is to be seen', () => {
  const zoomed = zoomView(fitView(arena, canvas), 4, { x: 42, y: 618 }, arena, canvas); // at the lower left corner

  it('comes into the middle when it is out of sight, at the same zoom', () => {
    const shown = placeView(zoomed, { x: 600, y: 450 }, arena, canvas);
    expect(toPx(shown, { x: 600, y: 450 })).toEqual({ x: 434, y: 327 });
    expect(shown.pxPerMm).toBe(zoomed.pxPerMm);
  });

  it('leaves the picture as it is when it shows already', () => {
    const fit = fitView(arena, canvas);
    expect(placeView(fit, { x: 600, y: 450 }, arena, canvas)).toBe(fit);
  });

  it('shows outside of the arena too, however far, together with the arena', () => {
    for (const x of [-200, -3000]) {
      const shown = placeView(zoomed, { x, y: 450 }, arena, canvas);
      expect(toPx(shown, { x, y: 450 }).x).toBeGreaterThan(0);
      expect(toPx(shown, { x: 1200, y: 450 }).x).toBeLessThan(canvas.widthPx);
    }
  });
});

describe('following the robot', () => {
  const zoomed = zoomView(fitView(arena, canvas), 4, { x: 434, y: 327 }, arena, canvas);

  it('leaves the picture in peace as long as the robot is in the middle third', () => {
    const at = toMm(zoomed, { x: 300, y: 400 });
    expect(followView(zoomed, at, arena, canvas, 1, 1)).toBe(zoomed);
  });

  it('brings a robot at the right edge back to the end of the middle third', () => {
    const at = toMm(zoomed, { x: 800, y: 327 });
    const view = followView(zoomed, at, arena, canvas, 1, 1);
    expect(toPx(view, at).x).toBeCloseTo((868 * 2) / 3, 0);
    expect(toPx(view, at).y).toBe(327);
  });

  it('goes by whole pixels of the screen, a share of the way at a time, and comes to rest', () => {
    const at = toMm(zoomed, { x: 800, y: 327 });
    let view = zoomed;
    let steps = 0;
    for (; steps < 200; steps += 1) {
      const next = followView(view, at, arena, canvas, 0.11, 2);
      if (next === view) break;
      expect(Math.abs((next.leftPx - view.leftPx) * 2) % 1).toBeCloseTo(0, 9);
      view = next;
    }
    expect(steps).toBeGreaterThan(10);
    expect(steps).toBeLessThan(100);
    expect(Math.abs(toPx(view, at).x - (868 * 2) / 3)).toBeLessThan(5);
  });

  it('does not leave the arena behind a robot in its corner', () => {
    let view = zoomed;
    for (let i = 0; i < 100; i += 1) view = followView(view, { x: 0, y: 0 }, arena, canvas, 1, 1);
    expect(view.leftPx).toBe(42);
  });
});
