import { describe, expect, it } from 'vitest';
import { tagAt, tagsOnMovers, type Shifted } from '#scene/kinds/stuck-tags';
import { defaultScene, type Block, type SceneObject } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
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
    expect(shown(scene, { blocks: {} })).toBe(scene);
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

  it('has a tag where the hand has put its block before the run', () => {
    const [block, tag] = objects;
    const lay = block as Block;
    const put: SceneObject & Shifted = { ...lay, at: [800, 300], angle: 90, lay };
    const now = createStillScene()({ ...scene, objects: [put, tag!] }, null).objects[1];
    expect(now?.type === 'tag' && [...now.at, now.angle].map(Math.round)).toEqual([800, 270, 270]);
  });

  it('leaves a tag on a moving obstacle to what moves, and stays the same one while that moves', () => {
    const mover: SceneObject = { type: 'mover', id: 'mover', at: [900, 400], to: [1100, 400], size: [50, 50], angle: 0, speed: 100, spiked: false }; // prettier-ignore
    const tag: SceneObject = { type: 'tag', id: 'tag', at: [880, 400], number: 7, side: 40, angle: 180 };
    const moving = { ...scene, objects: [mover, tag] };
    const shown = createStillScene();
    const before = shown(moving, null);
    expect(before.objects).toEqual([mover]);
    const state: Pick<Snapshot, 'blocks' | 'movers'> = { blocks: {}, movers: { mover: { xMm: 1000, yMm: 400, headingRad: 0 } } }; // prettier-ignore
    expect(shown(moving, state)).toBe(before);
    const [one] = tagsOnMovers(moving.objects);
    expect(one && tagAt(one, state.movers['mover']!).at).toEqual([980, 400]);
    expect(one && tagAt(one, null)).toBe(tag);
  });
});
