import { describe, expect, it } from 'vitest';
import { centreBox, radiusLabel } from './draw-centre';

describe('the mark of the centre of rotation', () => {
  it('says the radius in whole cm, below 10 cm to the mm', () => {
    expect([0, 34.6, 99.4, 99.6, 151].map(radiusLabel)).toEqual([
      'r = 0 cm',
      'r = 3.5 cm',
      'r = 9.9 cm',
      'r = 10 cm',
      'r = 15 cm',
    ]);
  });

  it('lies between itself and the middle of the axle, with room for its label', () => {
    const view = { pxPerMm: 1, leftPx: 0, bottomPx: 1000 };
    const box = centreBox({ atMm: { x: 300, y: 400 }, radiusMm: 200 }, { xMm: 500, yMm: 400, headingRad: 1 }, view);
    expect(box.left).toBeLessThan(300 - 40);
    expect(box.left + box.width).toBeGreaterThanOrEqual(500);
    expect(box.top + box.height).toBeGreaterThan(600 + 40);
  });
});
