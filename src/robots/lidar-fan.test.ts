import { describe, expect, it } from 'vitest';

import { eyeLevelCells, fanOf, nearestOfFan } from './lidar-fan';
import { lidarOf } from './testing/lidar-of';

describe('the fan of a lidar', () => {
  it('is row 3 of eight, and row 1 of four', () => {
    expect(eyeLevelCells(8)).toEqual([24, 25, 26, 27, 28, 29, 30, 31]);
    expect(eyeLevelCells(4)).toEqual([4, 5, 6, 7]);
  });

  it('opens by 26.25° to each side: its outer rays are 49 mm aside at 100 mm', () => {
    const rays = fanOf(lidarOf({ row: [100, 100, 100, 100, 100, 100, 100, 100] }));
    expect(rays.map(({ perMm }) => Math.round(100 * perMm.y))).toEqual([49, 34, 20, 7, -7, -20, -34, -49]);
    expect(rays.every(({ perMm }) => perMm.x === 1)).toBe(true);
  });

  it('meets a wall straight ahead at one depth in all rays, whichever way it looks', () => {
    const up = lidarOf({ row: [200, 200, 200, 200], size: 4, headingRad: Math.PI / 2 });
    for (const { perMm } of fanOf(up)) expect(up.fromMm.y + 200 * perMm.y).toBeCloseTo(200, 9);
  });
});

describe('the nearest thing ahead of a lidar', () => {
  it('is where the ray with the least depth ends: 180 mm ahead, 89 mm to the right', () => {
    const nearest = nearestOfFan(lidarOf({ row: [420, 440, null, 460, 470, 320, 230, 180] }));
    expect(nearest?.depthMm).toBe(180);
    expect(nearest?.hitMm.x).toBeCloseTo(180, 9);
    expect(nearest?.hitMm.y).toBeCloseTo(-88.8, 1);
  });

  it('is nothing where no ray meets anything, though the floor is seen below', () => {
    expect(nearestOfFan(lidarOf({ row: [null, null, null, null, null, null, null, null] }))).toBeNull();
  });
});
