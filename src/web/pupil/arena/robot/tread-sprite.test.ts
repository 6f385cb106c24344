// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { TreadShelf } from './tread-sprite';

const tyre = { x: -40, y: -20, width: 12, height: 40 };

function drawn(shelf: TreadShelf, turnRad: number, pixelsPerMm = 1): HTMLCanvasElement {
  const drawImage = vi.fn();
  shelf.draw({ drawImage } as unknown as CanvasRenderingContext2D, tyre, turnRad, pixelsPerMm);
  const [picture, ...place] = drawImage.mock.calls[0] as [HTMLCanvasElement, ...number[]];
  expect(place).toEqual([-41, -21, 14, 42]);
  return picture;
}

describe('a tyre that turns', () => {
  const shelf = new TreadShelf();
  const mark = (2 * Math.PI) / 24;

  it('looks the same again one mark further, forwards and backwards', () => {
    expect(drawn(shelf, mark * 7.52)).toBe(drawn(shelf, mark * 0.52));
    expect(drawn(shelf, mark * -3.48)).toBe(drawn(shelf, mark * 0.52));
  });

  it('looks otherwise a tenth of a mark further', () => {
    expect(drawn(shelf, mark * 0.1)).not.toBe(drawn(shelf, 0));
  });

  it('is painted finer when it is shown larger', () => {
    expect(drawn(shelf, 0, 2).width).toBeGreaterThan(1.9 * drawn(shelf, 0).width);
  });
});
