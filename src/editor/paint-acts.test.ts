import { describe, expect, it } from 'vitest';

import { applyEdit } from '#scene/edit';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { painted, selectedPaintable, withInfrared } from './paint-acts';

const box = { size: [40, 40], angle: 0 } as const;
const objects: readonly SceneObject[] = [
  { id: 'b', type: 'block', at: [100, 100], ...box },
  { id: 'p', type: 'paper', at: [200, 100], ...box, color: 'green', infrared: 0.1 },
  { id: 's', type: 'spikes', at: [300, 100], ...box },
  { id: 'l', type: 'fixed-block', at: [400, 100], ...box, lock: true },
];
const scene: Scene = { ...defaultScene(), objects };
const all = { ids: ['b', 'p', 's', 'l'], robot: false };
const after = (edit: ReturnType<typeof painted>): readonly SceneObject[] =>
  edit ? applyEdit(scene, edit).objects : [];

describe('the paint of what is selected', () => {
  it('is that of lines, fields, walls and blocks that are not locked', () => {
    expect(selectedPaintable(scene, all).map(({ id }) => id)).toEqual(['b', 'p']);
  });

  it('becomes a colour with its usual infrared', () => {
    const [block, paper, ...rest] = after(painted(scene, all, 'red'));
    expect([block, paper]).toEqual([
      { ...objects[0], color: 'red' },
      { id: 'p', type: 'paper', at: [200, 100], ...box, color: 'red' },
    ]);
    expect(rest).toEqual(objects.slice(2));
  });

  it('is taken from a thing, never from a sheet', () => {
    const red = applyEdit(scene, painted(scene, all, 'red')!);
    const bare = applyEdit(red, painted(red, all, null)!).objects;
    expect(bare[0]).toEqual(objects[0]);
    expect(bare[1]).toMatchObject({ color: 'red' });
    expect(painted(scene, { ids: ['b'], robot: false }, null)).toBeNull();
  });

  it('has an infrared of its own only where there is a colour, and the usual one again', () => {
    const [block, paper] = after(withInfrared(scene, all, 0.7));
    expect([block, paper]).toEqual([objects[0], { ...objects[1], infrared: 0.7 }]);
    expect(after(withInfrared(scene, all, null))[1]).not.toHaveProperty('infrared');
  });
});
