import { describe, expect, it } from 'vitest';
import { lidarOf } from '#robots/testing/lidar-of';
import { defaultScene, type SceneObject } from '#scene/scene';
import { arranged } from '../picture/arranged';
import { lowThingsOf, lowUnder } from './low-things';

/** A block of 60 × 60 mm at a place; a height makes it high or low. */
const block = (id: string, x: number, y: number, more: object = {}): SceneObject => ({
  ...{ type: 'block', id, at: [x, y], size: [60, 60], angle: 0 },
  ...more,
});
const lidar = lidarOf({ row: [400, 400, 400, 400, null, null, 150, 150] });

/** Ids of the low things of these under the rays. */
function under(objects: readonly SceneObject[]): readonly string[] {
  const { blocks } = arranged({ ...defaultScene(), objects }, null);
  return lowUnder(lidar, lowThingsOf(objects), blocks).map(({ id }) => id);
}

describe('the low things under a fan', () => {
  it('are those that say to be lower than 100 mm', () => {
    expect(under([block('usual', 300, 50), block('low', 300, 60, { height: 60 }), block('high', 300, 70, { height: 100 })])).toEqual(['low']); // prettier-ignore
  });

  it('are nearer than the wall behind them, within the fan, and within 45 cm where it meets nothing', () => {
    const low = { height: 30 };
    expect(under([block('before', 390, 100, low), block('behind', 410, 100, low)])).toEqual(['before']);
    expect(under([block('aside', 100, 90, low), block('back', -100, 0, low)])).toEqual([]);
    expect(under([block('open', 440, -40, low), block('far', 460, -40, low)])).toEqual(['open']);
  });

  it('are where they were pushed to', () => {
    const objects = [block('pushed', 300, 50, { height: 60 })];
    const pushed = { pose: { xMm: 350, yMm: 80, headingRad: Math.PI / 4 } };
    const { blocks } = arranged({ ...defaultScene(), objects }, { robot: null, blocks: { pushed: pushed.pose } });
    const [thing] = lowUnder(lidar, lowThingsOf(objects), blocks);
    expect(thing?.atMm).toEqual({ x: 350, y: 80 });
    expect(thing?.upMm).toBeCloseTo(42.4, 1);
  });

  it('say their height in the middle, of a wall, too', () => {
    const wall = { type: 'wall', id: 'w', from: [100, -50], to: [100, 50], thickness: 8, height: 40 } as SceneObject;
    expect(lowUnder(lidar, lowThingsOf([wall]), [])).toEqual([
      { id: 'w', atMm: { x: 100, y: 0 }, upMm: 4, heightMm: 40 },
    ]);
  });
});
