import { describe, expect, it } from 'vitest';
import type { Point, Stroke } from '#scene/scene';
import { distanceMm, toVec } from '../plane';
import { roundedRectangle } from './curves';
import { cornerRadius, withCornerRadius } from './round-corners';
import { inWholeMm } from './whole-mm';

const line = (...points: Point[]): Stroke => ({ type: 'stroke', id: 's1', points, width: 20, color: 'black' });
const angle = line([0, 0], [400, 0], [400, 300]);
const square = line([0, 0], [600, 0], [600, 600], [0, 600], [0, 0]);

describe('the corners of a line', () => {
  it('are sharp at first, and may become as round as their sides allow', () => {
    expect(cornerRadius(angle)).toEqual({ mm: 0, mostMm: 300 });
    expect(cornerRadius(square)).toEqual({ mm: 0, mostMm: 300 });
    expect(cornerRadius(line([0, 0], [400, 0], [400, 300], [0, 300]))).toEqual({ mm: 0, mostMm: 150 });
  });

  it.each([5, 10, 20, 30, 47, 50, 75, 100, 150, 200])(
    'become arcs of %i mm, within a millimetre, that touch both sides',
    (radiusMm) => {
      const { points } = withCornerRadius(angle, radiusMm);
      const centre = { x: 400 - radiusMm, y: radiusMm };
      const arc = points.slice(1, -1);
      expect(arc.length).toBeGreaterThan(2);
      for (const point of arc) expect(Math.abs(distanceMm(toVec(point), centre) - radiusMm)).toBeLessThan(1);
      expect([points[0], arc[0], arc.at(-1), points.at(-1)].filter((point) => point !== undefined)).toEqual([
        ...[[0, 0], [400 - radiusMm, 0]],
        ...[[400, radiusMm], [400, 300]],
      ]); // prettier-ignore
    },
  );

  it.each([10, 20, 30, 47, 50, 75, 100, 150, 200])(
    'of %i mm are found again, and can be changed or made sharp',
    (mm) => {
      for (const stroke of [angle, square]) {
        const round = withCornerRadius(stroke, mm);
        expect(cornerRadius(round)?.mm).toBe(mm);
        expect(cornerRadius(withCornerRadius(round, 60))?.mm).toBe(60);
        expect(withCornerRadius(round, 0).points).toHaveLength(stroke.points.length);
        for (const point of withCornerRadius(round, 0).points)
          expect(Math.min(...stroke.points.map((own) => distanceMm(toVec(own), toVec(point))))).toBeLessThan(2);
      }
    },
  );

  it('of any angle keep it: 30 to 165 degrees, to both sides', () => {
    for (let degrees = -165; degrees <= 165; degrees += 15) {
      if (Math.abs(degrees) < 45) continue;
      const rad = (degrees * Math.PI) / 180;
      const end: Point = [Math.round(600 + 600 * Math.cos(rad)), Math.round(700 + 600 * Math.sin(rad))];
      const bent = line([0, 700], [600, 700], end);
      const most = cornerRadius(bent)?.mostMm ?? 0;
      const mm = Math.min(60, most);
      const round = withCornerRadius(bent, mm);
      expect(round.points[0]).toEqual([0, 700]);
      expect(round.points.at(-1)).toEqual(end);
      expect(cornerRadius(round)?.mm, `${degrees} degrees`).toBe(mm);
    }
  });

  it('are all changed, those of a closed line once round, which stays closed', () => {
    const { points } = withCornerRadius(square, 100);
    expect(points[0]).toEqual(points.at(-1));
    expect(Math.min(...points.map((point) => distanceMm(toVec(point), { x: 0, y: 0 })))).toBeGreaterThan(40);
    expect(cornerRadius(withCornerRadius(square, 300))?.mostMm).toBeGreaterThanOrEqual(299);
  });

  it.each<[string, Stroke]>([
    ['a straight line', line([0, 0], [400, 0])],
    ['a line through three places on one', line([0, 0], [200, 0], [400, 0])],
    ['a gentle curve', line([0, 0], [100, 10], [200, 30], [300, 60])],
    ['a line that turns back', line([0, 0], [400, 0], [0, 1])],
    ['corners with sides too short for any radius', line([0, 0], [6, 0], [6, 6], [0, 6])],
    ['a line of very many points', line(...Array.from({ length: 500 }, (_, i): Point => [i, i % 2]))],
  ])('are none of %s', (_, stroke) => {
    expect(cornerRadius(stroke)).toBeNull();
  });

  it('leave other points of the line where they are', () => {
    const wavy = line([0, 0], [100, 12], [200, 0], [500, 0], [500, 400]);
    expect(withCornerRadius(wavy, 50).points.slice(0, 4)).toEqual([[0, 0], [100, 12], [200, 0], [450, 0]]); // prettier-ignore
  });

  it.each([30, 60, 100])(
    'of the pen’s rounded rectangle have its radius of %i mm, and become those of a rectangle',
    (mm) => {
      const bounds = { minX: 100, minY: 150, maxX: 900, maxY: 600 };
      const points = roundedRectangle(bounds, mm).flatMap(inWholeMm);
      const drawn = line(...points, ...points.slice(0, 1));
      expect(cornerRadius(drawn)?.mm).toBe(mm);
      expect(withCornerRadius(drawn, 0).points).toHaveLength(5);
    },
  );

  it('of a cut corner stay two corners', () => {
    expect(cornerRadius(line([0, 0], [300, 0], [400, 100], [400, 400]))?.mm).toBe(0);
  });
});
