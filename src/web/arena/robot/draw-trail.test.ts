import { describe, expect, it } from 'vitest';
import { createTrailLayer, piecesOf } from './draw-trail';
import { Trail } from '../../run/trail';

const view = { pxPerMm: 1, leftPx: 0, bottomPx: 1000 };

function trailOf(...xyMm: number[]): Trail {
  const trail = new Trail();
  trail.add(xyMm);
  return trail;
}

describe('the drawing of a trail', () => {
  it('turns mm into px, y upwards in the arena and downwards on the canvas', () => {
    expect(piecesOf(trailOf(10, 20, 30, 40), 0, view)).toEqual([[10, 980, 30, 960]]);
  });

  it('has two pieces when the hand carried the robot once', () => {
    expect(piecesOf(trailOf(0, 0, 10, 0, NaN, NaN, 500, 0), 0, view)).toEqual([
      [0, 1000, 10, 1000],
      [500, 1000],
    ]);
  });

  it('goes on from the third point when the first two are drawn already', () => {
    expect(piecesOf(trailOf(0, 0, 10, 0, 20, 0), 2, view)).toEqual([[20, 1000]]);
  });

  it('draws 100 points within 20 px as 16 or fewer, and reaches the last one', () => {
    const [piece = []] = piecesOf(trailOf(...Array.from({ length: 200 }, (_, i) => (i % 2 ? 0 : i / 10))), 0, view);
    expect(piece.length / 2).toBeLessThanOrEqual(16);
    expect(piece.at(-2)).toBeCloseTo(19.8, 4);
  });

  it('leaves to the moving picture what its own canvas does not show yet', () => {
    const layer = createTrailLayer();
    expect(layer.tail(trailOf(0, 0, 10, 0), view)).toEqual([
      { x: 0, y: 1000 },
      { x: 10, y: 1000 },
    ]);
    expect(layer.tail(trailOf(0, 0, 10, 0, NaN, NaN, 70, 0), view)).toEqual([{ x: 70, y: 1000 }]);
  });
});
