import { describe, expect, it } from 'vitest';
import { boxAround, movingWindow, unionOf } from './moving-window';

const canvas = { widthPx: 700, heightPx: 500 };

describe('the window of the moving things', () => {
  it('is 128 px wide around something of 100 px', () => {
    const content = boxAround({ x: 300, y: 200 }, 50);
    expect(movingWindow(content, canvas, 1, null)).toEqual({ left: 236, top: 136, width: 128, height: 128 });
  });

  it('stays where it is while the robot drives 10 px in it, and follows it after 20 px', () => {
    const before = movingWindow(boxAround({ x: 300, y: 200 }, 50), canvas, 1, null);
    expect(movingWindow(boxAround({ x: 310, y: 200 }, 50), canvas, 1, before)).toEqual(before);
    expect(movingWindow(boxAround({ x: 320, y: 200 }, 50), canvas, 1, before)).toEqual({ ...before, left: 256 });
  });

  it('stays on the canvas at its lower right corner', () => {
    const window = movingWindow(boxAround({ x: 690, y: 490 }, 50), canvas, 1, null);
    expect(window).toEqual({ left: 700 - 64, top: 500 - 64, width: 64, height: 64 });
  });

  it('starts on a whole pixel of a screen with 1.25 pixels per px', () => {
    const { left } = movingWindow(boxAround({ x: 301, y: 200 }, 50), canvas, 1.25, null);
    expect(left * 1.25).toBeCloseTo(Math.round(left * 1.25), 9);
    expect(left).toBeLessThanOrEqual(251);
  });

  it('keeps its size while it is at most twice as large as needed, and shrinks after that', () => {
    const before = { left: 0, top: 0, width: 320, height: 640 };
    const window = movingWindow(boxAround({ x: 300, y: 200 }, 90), canvas, 1, before);
    expect([window.width, window.height]).toEqual([320, 192]);
  });

  it('is never larger than the canvas', () => {
    expect(movingWindow(boxAround({ x: 300, y: 200 }, 9000), canvas, 1, null)).toEqual({
      left: 0,
      top: 0,
      width: 700,
      height: 500,
    });
  });
});

describe('boxes', () => {
  it('around two places 100 px apart are 120 px wide together', () => {
    expect(unionOf([boxAround({ x: 0, y: 0 }, 10), boxAround({ x: 100, y: 0 }, 10)])).toEqual({
      left: -10,
      top: -10,
      width: 120,
      height: 20,
    });
  });
});
