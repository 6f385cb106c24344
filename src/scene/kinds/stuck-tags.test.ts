import { describe, expect, it } from 'vitest';
import type { SceneObject } from '../scene';
import { carriedPose, carriersOf, movedTags } from './stuck-tags';

const tag = (x: number, y: number, flat = false): SceneObject => ({
  ...{ type: 'tag', id: 'tag', at: [x, y], number: 7, side: 60, angle: 180 },
  ...(flat ? { flat: true } : {}),
});
const block: SceneObject = { type: 'block', id: 'block', at: [500, 300], size: [100, 60], angle: 90 };

describe('a tag that is stuck to a block', () => {
  it('is carried by it, up to 15 mm before it, whichever stands first in the course', () => {
    for (const objects of [
      [tag(470, 300), block],
      [block, tag(456, 330)],
    ])
      expect(carriersOf(objects).get('tag')?.id).toBe('block');
    expect(carriersOf([tag(454, 300), block]).size).toBe(0);
  });

  it('is carried by nothing if it lies, or stands at a block that is fixed', () => {
    expect(carriersOf([tag(470, 300, true), block]).size).toBe(0);
    const fixed: SceneObject = { type: 'fixed-block', id: 'block', at: [500, 300], size: [100, 60], angle: 90 };
    expect(carriersOf([tag(470, 300), fixed]).size).toBe(0);
  });

  it('is where the course has it while the block is where it was, and turns with it', () => {
    const objects = [tag(470, 300), block];
    const carrier = carriersOf(objects).get('tag')!;
    const still = carriedPose(carrier, { xMm: 500, yMm: 300, headingRad: Math.PI / 2 });
    expect([still.xMm, still.yMm, still.headingRad].map((value) => Math.round(value * 1e6) / 1e6)).toEqual([
      470,
      300,
      Math.round(Math.PI * 1e6) / 1e6,
    ]);
    const { tag: turned } = movedTags(objects, { block: { xMm: 800, yMm: 400, headingRad: Math.PI } });
    expect([turned!.xMm, turned!.yMm].map(Math.round)).toEqual([800, 370]);
    expect(Math.round((turned!.headingRad * 180) / Math.PI)).toBe(270);
    expect(movedTags(objects, {})).toEqual({});
  });
});
