import { describe, expect, it } from 'vitest';
import { coneBox, distanceLabel, labelPlace, withAlpha } from './draw-cone';

describe('the cone', () => {
  it('reaches 450 px far at 1 px per mm when it meets nothing', () => {
    const cone = { fromMm: { x: 0, y: 0 }, headingRad: 0, openingRad: 0.5, distanceMm: null, hitMm: null };
    const box = coneBox(cone, { pxPerMm: 1, leftPx: 0, bottomPx: 0 });
    expect(box.left + box.width).toBeGreaterThanOrEqual(450);
    expect(box.width).toBeLessThan(470);
    expect(box.height).toBeGreaterThanOrEqual(2 * 450 * Math.sin(0.25));
  });
});

describe('the label of the distance', () => {
  it('says 9 cm for 91 mm', () => expect(distanceLabel(91)).toBe('9 cm'));

  it('lies above the hit point, whichever way the robot looks', () => {
    for (const heading of [0, 1, 2, 3, 4, 5, 6]) expect(labelPlace({ x: 0, y: 0 }, heading).y).toBeLessThanOrEqual(0);
  });
});

describe('a colour', () => {
  it('ends in 1a at 10 %', () => expect(withAlpha('#E06A00', 0.1)).toBe('#E06A001a'));
});
