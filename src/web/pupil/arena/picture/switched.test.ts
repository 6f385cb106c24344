import { describe, expect, it } from 'vitest';
import { defaultScene, type SceneObject } from '#scene/scene';
import { createStillScene } from './switched';

const objects: readonly SceneObject[] = [
  { type: 'block', id: 'block', at: [500, 300], size: [60, 60], angle: 0 },
  { type: 'tag', id: 'tag', at: [470, 300], number: 7, side: 60, angle: 180 },
  { type: 'lamp', id: 'lamp', at: [100, 100], height: 260, brightness: 40, on: 'hand' },
];
const scene = { ...defaultScene(), objects };

describe('the still picture of a run', () => {
  it('is the course itself while nothing of it has changed', () => {
    const shown = createStillScene();
    expect(shown(scene, null)).toBe(scene);
    expect(shown(scene, { blocks: {}, movers: {} })).toBe(scene);
  });

  it('has a lamp as it is switched, and a tag where its block is; the same one until that changes', () => {
    const shown = createStillScene();
    const state = { switched: { lamp: true }, blocks: { block: { xMm: 800, yMm: 300, headingRad: Math.PI / 2 } } };
    const now = shown(scene, state);
    expect(now.objects[2]).toMatchObject({ isOn: true });
    const tag = now.objects[1];
    expect(tag?.type === 'tag' && [...tag.at, tag.angle].map(Math.round)).toEqual([800, 270, 270]);
    expect(shown(scene, { ...state })).toBe(now);
  });
});
