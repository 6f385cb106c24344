import { describe, expect, it } from 'vitest';
import type { SceneObject } from '#scene/scene';
import { stroke, wall } from '../testing/desk';
import { kindOf, middleOf } from './index';

const turnedTwice = (object: SceneObject): SceneObject => {
  const once = kindOf(object).turned(object, middleOf(object), 45);
  return kindOf(once).turned(once, middleOf(once), 45);
};

describe('turning by 45° twice', () => {
  it('stands a level wall upright with the same length, for every whole centimetre up to 2 m', () => {
    for (let cm = 1; cm <= 200; cm += 1) {
      const upright = turnedTwice(wall('w', [100, 500], [100 + 10 * cm, 500]));
      const x = 100 + 5 * cm;
      expect(upright).toEqual(wall('w', [x, 500 - 5 * cm], [x, 500 + 5 * cm]));
    }
  });
});

describe('the middle of a stroke', () => {
  it('counts its ink, not its points', () => {
    expect(middleOf(stroke('s', [0, 0], [10, 0], [20, 0], [400, 0]))).toEqual({ x: 200, y: 0 });
    expect(middleOf(stroke('dot', [30, 40]))).toEqual({ x: 30, y: 40 });
  });
});
