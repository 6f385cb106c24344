import { describe, expect, it } from 'vitest';
import type { SceneObject } from '#scene/scene';
import { heightLabels } from './height-labels';

const block: SceneObject = { type: 'block', id: 'b', at: [300, 200], size: [60, 40], angle: 0 };
const wall: SceneObject = { type: 'wall', id: 'w', from: [0, 100], to: [400, 100], thickness: 10 };
const label: SceneObject = { type: 'label', id: 'l', at: [0, 0], text: 'A', height: 30, angle: 0 };

describe('heights in the picture', () => {
  it('are said of things that were made lower than 10 cm, and of no others', () => {
    const things = [block, wall, label, { ...block, id: 'high', height: 100 }, { ...block, id: 'low', height: 99 }];
    expect(heightLabels(things, {})).toMatchObject([{ id: 'low', heightMm: 99 }]);
    expect(heightLabels([{ ...block, height: 60 }], {})).toMatchObject([{ heightMm: 60 }]);
  });

  it('stand beside a block where it is now, and on the middle of a wall', () => {
    const low = { ...block, height: 30 };
    expect(heightLabels([low, { ...wall, height: 20 }], {})).toEqual([
      { id: 'b', heightMm: 30, atMm: { x: 300, y: 200 }, halfMm: 20 },
      { id: 'w', heightMm: 20, atMm: { x: 200, y: 100 }, halfMm: 0 },
    ]);
    const pushed = { b: { xMm: 500, yMm: 300, headingRad: Math.PI / 2 } };
    expect(heightLabels([low], pushed)[0]?.atMm).toEqual({ x: 500, y: 300 });
    expect(heightLabels([low], pushed)[0]?.halfMm).toBeCloseTo(30, 9);
  });
});
