import { describe, expect, it } from 'vitest';
import { boxAround, movingWindow, patientWindow, unionOf, type PxBox } from './moving-window';

const canvas = { widthPx: 700, heightPx: 500 };

describe('the window of the moving things', () => {
  it('is 192 px wide around something of 130 px, which is in its middle', () => {
    const content = boxAround({ x: 300, y: 200 }, 65);
    expect(movingWindow(content, canvas, 1, null)).toEqual({ left: 204, top: 104, width: 192, height: 192 });
  });

  it('always has room for 32 px: around something of 120 px it is 192 px wide, too', () => {
    const { width } = movingWindow(boxAround({ x: 300, y: 200 }, 60), canvas, 1, null);
    expect(width).toBe(192);
  });

  const driving = (from: PxBox, xs: readonly number[]): PxBox[] => {
    const places = [from];
    for (const x of xs) places.push(movingWindow(boxAround({ x, y: 200 }, 65), canvas, 1, places.at(-1) ?? null));
    return places;
  };

  it('stays where it is while the robot drives 30 px in it, then goes ahead of it', () => {
    const before = movingWindow(boxAround({ x: 300, y: 200 }, 65), canvas, 1, null);
    const [, stays, goes, still] = driving(before, [330, 332, 382]);
    expect(stays).toEqual(before);
    expect(goes).toEqual({ ...before, left: 257 });
    expect(still).toEqual(goes);
  });

  it('goes ahead of a robot that drives back, too', () => {
    const before = movingWindow(boxAround({ x: 300, y: 200 }, 65), canvas, 1, null);
    const [, goes, still] = driving(before, [268, 218]);
    expect(goes).toEqual({ ...before, left: 150 });
    expect(still).toEqual(goes);
  });

  it('stays on the canvas at its lower right corner', () => {
    const window = movingWindow(boxAround({ x: 690, y: 490 }, 50), canvas, 1, null);
    expect(window).toEqual({ left: 700 - 128, top: 500 - 128, width: 128, height: 128 });
  });

  it('starts on a whole pixel of a screen with 1.25 pixels per px', () => {
    const { left } = movingWindow(boxAround({ x: 301, y: 200 }, 50), canvas, 1.25, null);
    expect(left * 1.25).toBeCloseTo(Math.round(left * 1.25), 9);
    expect(left).toBeLessThanOrEqual(251);
  });

  it('keeps its size while it is at most twice as large as needed, and shrinks after that', () => {
    const before = { left: 0, top: 0, width: 320, height: 640 };
    const window = movingWindow(boxAround({ x: 300, y: 200 }, 90), canvas, 1, before);
    expect([window.width, window.height]).toEqual([320, 256]);
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

describe('a window that shrinks late', () => {
  const [small, large] = [boxAround({ x: 300, y: 200 }, 40), boxAround({ x: 300, y: 200 }, 240)];

  it('keeps its size while somebody jumps between a short cone and a long one', () => {
    const window = patientWindow();
    let place: PxBox | null = null;
    const widths = new Set<number>();
    for (let picture = 0; picture < 100; picture += 1) {
      place = window(picture % 10 === 0 ? large : small, canvas, 1, place);
      widths.add(place.width);
    }
    expect([...widths]).toEqual([512]);
  });

  it('is small again half a second after the last long cone', () => {
    const window = patientWindow();
    let place = window(large, canvas, 1, null);
    for (let picture = 0; picture < 30; picture += 1) place = window(small, canvas, 1, place);
    expect(place.width).toBe(512);
    expect(window(small, canvas, 1, place).width).toBe(128);
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
