import { describe, expect, it } from 'vitest';
import { carriedTags, tagAt, type Shifted } from '#scene/kinds/stuck-tags';
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
    const still = { ...scene, objects: objects.filter(({ type }) => type !== 'tag') };
    expect(shown(still, null)).toBe(still);
    expect(shown(still, {})).toBe(still);
  });

  it('has a lamp as it is switched, and stays the same one while a block with a tag is pushed', () => {
    const shown = createStillScene();
    const pushed = (xMm: number): Pick<Snapshot, 'blocks' | 'switched'> => ({
      switched: { lamp: true },
      blocks: { block: { xMm, yMm: 300, headingRad: Math.PI / 2 } },
    });
    const now = shown(scene, pushed(500));
    expect(now.objects.map(({ type }) => type)).toEqual(['block', 'lamp']);
    expect(now.objects[1]).toMatchObject({ isOn: true });
    for (const xMm of [501, 502, 800]) expect(shown(scene, pushed(xMm))).toBe(now);
    const [one] = carriedTags(scene.objects);
    const tag = one && tagAt(one, pushed(800).blocks['block']!);
    expect(tag && [...tag.at, tag.angle].map(Math.round)).toEqual([800, 270, 270]);
  });

  it('leaves a tag where the hand has put its block before the run', () => {
    const [block, tag] = objects;
    const lay = block as Block;
    const put: SceneObject & Shifted = { ...lay, at: [800, 300], angle: 90, lay };
    const [one] = carriedTags([put, tag!]);
    const now = one && tagAt(one, null);
    expect(now && [...now.at, now.angle].map(Math.round)).toEqual([800, 270, 270]);
  });

  it('leaves a tag on a moving obstacle to what moves, and stays the same one while that moves', () => {
    const mover: SceneObject = { type: 'mover', id: 'mover', at: [900, 400], to: [1100, 400], size: [50, 50], angle: 0, speed: 100, spiked: false }; // prettier-ignore
    const tag: SceneObject = { type: 'tag', id: 'tag', at: [880, 400], number: 7, side: 40, angle: 180 };
    const moving = { ...scene, objects: [mover, tag] };
    const shown = createStillScene();
    const before = shown(moving, null);
    expect(before.objects).toEqual([mover]);
    const state: Pick<Snapshot, 'blocks' | 'movers' | 'switched'> = { switched: {}, blocks: {}, movers: { mover: { xMm: 1000, yMm: 400, headingRad: 0 } } }; // prettier-ignore
    expect(shown(moving, state)).toBe(before);
    const [one] = carriedTags(moving.objects);
    expect(one && tagAt(one, state.movers['mover']!).at).toEqual([980, 400]);
    expect(one && tagAt(one, null)).toBe(tag);
  });
});
