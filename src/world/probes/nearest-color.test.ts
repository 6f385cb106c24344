import { describe, expect, it } from 'vitest';

import { createWorld } from '../world';

const cone = { openingRad: 0.2, rangeMm: 60, heightMm: 20 };

describe('what a colour sensor sees ahead', () => {
  const world = createWorld({ widthMm: 1000, heightMm: 500 });
  const block = { angleRad: 0, fixed: true, sizeMm: { x: 40, y: 40 } };
  world.addBlock({ ...block, atMm: { x: 320, y: 100 }, shares: [0.7, 0.1, 0.1] });
  world.addBlock({ ...block, atMm: { x: 400, y: 100 }, shares: [0, 0, 1] });
  world.addBlock({ ...block, atMm: { x: 320, y: 300 }, heightMm: 15, shares: [0, 0, 1] });
  world.addWall({ fromMm: { x: 350, y: 250 }, toMm: { x: 350, y: 350 }, thicknessMm: 10 });

  it('is the nearest thing within 60 mm and its colour', () => {
    expect(world.colorAhead({ x: 270, y: 100 }, 0, cone)).toEqual({ distanceMm: 30, shares: [0.7, 0.1, 0.1] });
    expect(world.colorAhead({ x: 230, y: 100 }, 0, cone)).toBeNull();
  });

  it('is over what is lower than 20 mm the grey wall behind, which has no colour', () => {
    expect(world.colorAhead({ x: 300, y: 300 }, 0, cone)).toEqual({ distanceMm: 45, shares: [0.47, 0.47, 0.47] });
  });
});
