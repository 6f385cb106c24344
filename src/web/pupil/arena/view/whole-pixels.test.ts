import { describe, expect, it, vi } from 'vitest';
import { putPicture, shiftToWholePixels } from './whole-pixels';

/** A canvas with `ratio` pixels per CSS px, whose corner is 10.25 of them left of the arena's. */
const canvasWith = (ratio: number) => ({
  getTransform: () => ({ a: ratio, b: 0, c: 0, d: ratio, e: -10.25, f: 0 }),
  setTransform: vi.fn(),
  translate: vi.fn(),
  drawImage: vi.fn(),
});
const asContext = (fake: ReturnType<typeof canvasWith>): CanvasRenderingContext2D =>
  fake as unknown as CanvasRenderingContext2D;
const picture = { width: 40, height: 20 } as HTMLCanvasElement;

describe('on whole pixels', () => {
  it.each([1, 1.25, 2])('a place lies on one after the shift, at %s pixels per px', (ratio) => {
    const canvas = canvasWith(ratio);
    shiftToWholePixels(asContext(canvas), { x: 33.4, y: 20.7 });
    const [x = NaN, y = NaN] = canvas.translate.mock.calls[0] as number[];
    const pixels = [ratio * (33.4 + x) - 10.25, ratio * (20.7 + y)];
    for (const pixel of pixels) expect(pixel).toBeCloseTo(Math.round(pixel), 9);
    for (const shift of [x, y]) expect(Math.abs(shift)).toBeLessThanOrEqual(0.5 / ratio);
  });

  it('a picture is put with its middle there, pixel for pixel, and what follows is drawn as before', () => {
    const canvas = canvasWith(2);
    putPicture(asContext(canvas), picture, { x: 33.4, y: 20.7 });
    expect(canvas.drawImage.mock.calls).toEqual([[picture, 37, 31]]);
    expect(canvas.setTransform.mock.calls).toEqual([[1, 0, 0, 1, 0, 0], [{ a: 2, b: 0, c: 0, d: 2, e: -10.25, f: 0 }]]);
  });
});
