import { describe, expect, it } from 'vitest';

import { applyEdit } from '#scene/edit';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { clearAll } from './clear-all';

const wall: SceneObject = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 };
const scene: Scene = {
  ...defaultScene(),
  name: 'Closed line',
  description: 'Follow the line.',
  size: [800, 600],
  task: { seconds: 30, noTouch: true },
  objects: [wall],
};

describe('clearing all', () => {
  it('takes the task and the rules of a ready course along, which tell of what is gone, and leaves its name', () =>
    expect(applyEdit(scene, clearAll(true))).toEqual({
      ...scene,
      description: '',
      task: { seconds: null, noTouch: false },
      objects: [],
    }));

  it('leaves what an author has written of a course of their own', () =>
    expect(applyEdit(scene, clearAll(false))).toEqual({ ...scene, objects: [] }));

  it('takes the picture of the floor along, also where nothing else is there', () => {
    const background: Scene['background'] = { at: [0, 0], size: [80, 60], cells: [8, 6], levels: '', picture: '' };
    expect(applyEdit({ ...scene, background }, clearAll(false))).toEqual({ ...scene, objects: [] });
    expect(applyEdit({ ...scene, background, objects: [] }, clearAll(false))).toEqual({ ...scene, objects: [] });
  });

  it('does not score a line any more whose tiles are gone', () => {
    const scored = { ...scene, league: { rules: 'line-2025', tiles: [{ at: [150, 150], heading: 0 }] } } as const;
    expect(applyEdit(scored, clearAll(false, true))).toEqual({ ...scene, objects: [] });
  });
});
