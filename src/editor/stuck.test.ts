import { describe, expect, it } from 'vitest';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { inverse } from '#scene/inverse';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { nudged, turnedByEighths } from './arrange';
import { copied, duplicated, pasted } from './clipboard';
import { handlesOf } from './handles';
import { removed } from './selection';
import { contextOf, course, drag, mover } from './testing/desk';
import { selectTool } from './tools/select-tool';
import { tagsStuckTo, withStuck } from './stuck';

const tag = (at: Point, more: Partial<SceneObject> = {}): SceneObject =>
  ({ type: 'tag', id: 'tag', at, number: 7, side: 60, angle: 180, ...more }) as SceneObject;
const box = (type: 'block' | 'fixed-block', at: Point, angle = 0): SceneObject => ({
  ...{ type, id: 'box', at, size: [100, 60], angle },
});
const wall = (id: string, from: Point, to: Point): SceneObject => ({ type: 'wall', id, from, to, thickness: 10 });
const selection = { ids: ['box'], robot: false };
const whole = (scene: Scene, edit: SceneEdit | null): Scene => applyEdit(scene, withStuck(scene, edit!));
const tagIn = ({ objects }: Scene): unknown => {
  const found = objects.find(({ id }) => id === 'tag');
  return found?.type === 'tag' ? { at: found.at, angle: found.angle } : undefined;
};
const replaced = (object: SceneObject): SceneEdit => ({ type: 'replace', changes: [{ id: object.id, by: [object] }] });

describe('a tag that is stuck to a thing, while the course is built', () => {
  it.each([box('block', [500, 300]), box('fixed-block', [500, 300]), { ...mover('box', [500, 300], [700, 300]) }])(
    'goes along with a $type that is dragged by the select tool, and back in one step',
    (thing) => {
      const scene = course(...[thing, tag(thing.type === 'mover' ? [475, 300] : [450, 300])]);
      const edit = withStuck(scene, selectTool.edit(drag([500, 300], [600, 350]), contextOf(scene, {}, selection))!);
      const after = applyEdit(scene, edit);
      expect(tagIn(after)).toEqual({ at: [thing.type === 'mover' ? 575 : 550, 350], angle: 180 });
      expect(applyEdit(after, inverse(scene, edit))).toEqual(scene);
    },
  );

  it('goes along with arrow keys, and turns with its block', () => {
    const scene = course(...[box('block', [500, 300]), tag([450, 310])]);
    expect(tagIn(applyEdit(scene, nudged(scene, selection, -10, 1)!))).toEqual({ at: [440, 311], angle: 180 });
    expect(tagIn(whole(scene, turnedByEighths(scene, selection, 2)))).toEqual({ at: [490, 250], angle: 270 });
  });

  it('stays at the side that is drawn out', () => {
    const scene = course(...[box('block', [500, 300]), tag([445, 315])]);
    const handle = handlesOf(scene, selection, []).find(({ side }) => side?.[0] === -1 && side[1] === -1)!;
    const context = contextOf(scene, {}, selection);
    const edit = selectTool.edit(drag([handle.at.x, handle.at.y], [handle.at.x - 100, handle.at.y]), context);
    expect(tagIn(whole(scene, edit))).toEqual({ at: [345, 315], angle: 180 });
  });

  it('is copied with its block, by duplicating and by the clipboard', () => {
    const scene = course(...[box('block', [500, 300]), tag([450, 300])]);
    const twice = applyEdit(scene, duplicated(scene, selection)!.edit);
    expect(twice.objects.map(({ type }) => type)).toEqual(['block', 'tag', 'block', 'tag']);
    const [, , block, copy] = twice.objects as [unknown, unknown, { at: Point }, { at: Point }];
    expect(block.at[0] - copy.at[0]).toBe(50);
    expect(copied(scene, selection)!.objects).toEqual(scene.objects);
    expect(pasted(scene, copied(scene, selection)!)!.selection.ids).toHaveLength(2);
  });

  it('goes with its block, and comes back with it', () => {
    const scene = course(...[tag([450, 300]), box('block', [500, 300])]);
    const edit = withStuck(scene, removed(scene, selection)!);
    expect(applyEdit(scene, edit).objects).toEqual([]);
    expect(applyEdit(applyEdit(scene, edit), inverse(scene, edit))).toEqual(scene);
  });

  it('stays where it is put itself, where it is locked, or where it lies on the floor', () => {
    const moved = box('block', [600, 300]);
    for (const more of [{ lock: true as const }, { flat: true as const }, { at: [430, 300] as Point }]) {
      const scene = course(...[box('block', [500, 300]), tag([450, 300], more)]);
      expect(whole(scene, replaced(moved)).objects[1]).toBe(scene.objects[1]);
    }
    const scene = course(...[box('block', [500, 300]), tag([450, 300])]);
    const both: SceneEdit = { type: 'all', edits: [replaced(tag([440, 300])), replaced(moved)] };
    expect(tagIn(whole(scene, both))).toEqual({ at: [440, 300], angle: 180 });
    expect(withStuck(scene, { type: 'robot', robot: { heading: 10 } })).toEqual({
      type: 'robot',
      robot: { heading: 10 },
    });
  });

  it('goes along with its wall, and stays at another one when that goes', () => {
    const long = wall('box', [100, 500], [500, 500]);
    const scene = course(...[long, wall('other', [500, 500], [500, 900]), tag([300, 495], { angle: 270 })]);
    expect(tagIn(whole(scene, replaced(wall('box', [100, 600], [500, 600]))))).toEqual({ at: [300, 595], angle: 270 });
    expect(tagIn(whole(scene, replaced(wall('box', [100, 500], [300, 500]))))).toEqual({ at: [200, 495], angle: 270 });
    const corner = course(...[...scene.objects.slice(0, 2), tag([490, 502])]);
    expect(tagsStuckTo(corner, ['box'])).toHaveLength(1);
    expect(tagIn(whole(corner, { type: 'remove', ids: ['box'] }))).toEqual({ at: [490, 502], angle: 180 });
    expect(tagIn(whole(scene, { type: 'remove', ids: ['box'] }))).toBeUndefined();
  });
});
