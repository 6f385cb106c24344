import { describe, expect, it } from 'vitest';
import { lidarOf } from '#robots/testing/lidar-of';
import { unionOf } from '../view/moving-window';
import { fanBoxes, placeFan } from './draw-fan';

const view = { pxPerMm: 0.5, leftPx: 50, bottomPx: 400 };
const sight = { left: 0, top: 0, width: 800, height: 800 };

describe('the fan of a lidar on the canvas', () => {
  const fan = placeFan(lidarOf({ row: [400, 400, 400, null, 400, 400, 400, 200] }), view, sight);

  it('goes from the lens to the hits, and 45 cm far where it meets nothing', () => {
    expect(fan.from).toEqual({ x: 50, y: 400 });
    expect(fan.rays.map(({ to }) => Math.round(to.x))).toEqual([250, 250, 250, 275, 250, 250, 250, 150]);
    expect(fan.rays.map(({ isHit }) => isHit)).toEqual([true, true, true, false, true, true, true, true]);
  });

  it('has no number for the ray that meets nothing, and the unit at the nearest hit', () => {
    expect(fan.labels.map(({ text }) => text).toSorted()).toEqual(['20 cm', '40', '40', '40', '40', '40', '40']);
    expect(fan.nearest?.x).toBeCloseTo(150, 9);
  });

  it('lies within its areas, with all points and numbers', () => {
    const { left, top, width, height } = unionOf(fanBoxes(fan));
    for (const { box } of fan.labels) {
      expect(box.left).toBeGreaterThan(left);
      expect(box.left + box.width).toBeLessThan(left + width);
      expect(box.top).toBeGreaterThan(top);
      expect(box.top + box.height).toBeLessThan(top + height);
    }
    for (const { to } of fan.rays) expect(to.x + 6).toBeLessThanOrEqual(left + width);
  });
});
