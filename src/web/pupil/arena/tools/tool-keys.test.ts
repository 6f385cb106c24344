import type { Vec } from '#core/geometry';
import { describe, expect, it } from 'vitest';
import { shallowRef, type ShallowRef } from 'vue';
import { clipText } from '#editor/clip-text';
import { usualToolOptions } from '#editor/tools/tool-options';
import { nothingSelected, type Selection } from '#editor/tools/tool';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type Block, type Mover, type Scene } from '#scene/scene';
import { Clipboard } from '../../../course/editor/state/clipboard';
import { createSelectionActs } from '../../../course/editor/state/selection-acts';
import { createSelectionKeys } from './tool-keys';

const block: Block = { type: 'block', id: 'b', at: [300, 300], size: [50, 50], angle: 0 };

function keysOverArena(selection: Selection = { ids: ['b'], robot: false }) {
  const now = {
    scene: { ...defaultScene(), objects: [block] } as Scene,
    selection,
    steps: 0,
    told: 0,
    pointed: null as { at: Vec; reachMm: number } | null,
  };
  const commit = (edit: SceneEdit, select?: Selection): boolean => {
    now.scene = applyEdit(now.scene, edit);
    now.selection = select ?? now.selection;
    now.steps += 1;
    return true;
  };
  const context = () => ({ scene: now.scene, selection: now.selection, options: usualToolOptions, footprint: [] });
  const acts = createSelectionActs(
    {
      selection: { get value() { return now.selection; } } as ShallowRef<Selection>, // prettier-ignore
      select: (chosen) => (now.selection = chosen),
      commit,
      choose: () => undefined,
      clipboard: new Clipboard(),
      pointer: shallowRef(null),
      tell: () => (now.told += 1),
    },
    context,
  );
  const keys = createSelectionKeys({ context, commit, acts, pointed: () => now.pointed, changed: () => undefined });
  const blocks = (): unknown => now.scene.objects.map((object) => (object.type === 'block' ? object.at : null));
  return { keys, acts, now, blocks };
}

describe('keys on what is selected', () => {
  it('move it by 10 mm, by 1 mm with Shift; all arrows until they are let go are one step', () => {
    const { keys, now, blocks } = keysOverArena();
    for (let i = 0; i < 5; i += 1) keys.keyDown('ArrowRight', false, false);
    keys.keyDown('ArrowUp', true, false);
    expect(now.steps).toBe(0);
    keys.keyUp('ArrowUp');
    expect([blocks(), now.steps]).toEqual([[[350, 301]], 1]);
  });

  it('group it with Ctrl+G and dissolve the group with Shift; alone, G is no key of theirs', () => {
    const { keys, now } = keysOverArena({ ids: ['b', 'c'], robot: false });
    now.scene = { ...now.scene, objects: [block, { ...block, id: 'c', at: [500, 300] }] };
    const groups = () => now.scene.objects.map(({ group }) => group);
    expect(keys.keyDown('g', false, true)).toBe(true);
    expect(groups()).toEqual(['group-1', 'group-1']);
    keys.keyDown('G', true, true);
    expect([groups(), now.steps]).toEqual([[undefined, undefined], 2]);
    expect(keys.keyDown('g', false, false)).toBe(false);
  });

  it('turn it by 45°', () => {
    const { keys, now } = keysOverArena();
    keys.keyDown('q', false, false);
    expect(now.scene.objects[0]).toMatchObject({ angle: 45 });
    keys.keyDown('E', false, false);
    expect(now.scene.objects[0]).toMatchObject({ angle: 0 });
  });

  it('delete it, and then select nothing', () => {
    const { keys, now } = keysOverArena();
    expect(keys.keyDown('Delete', false, false)).toBe(true);
    expect([now.scene.objects, now.selection]).toEqual([[], nothingSelected]);
  });

  it('delete a stop alone while it is pointed at, as long as two are left', () => {
    const way: Mover = {
      ...{ ...block, type: 'mover', to: [600, 300], speed: 100, spiked: false },
      stops: [[600, 600]],
    };
    const { keys, now } = keysOverArena();
    now.scene = { ...now.scene, objects: [way] };
    now.pointed = { at: { x: 602, y: 301 }, reachMm: 12 };
    keys.keyDown('Delete', false, false);
    const { stops: _, ...straight } = way;
    expect([now.scene.objects, now.selection.ids]).toEqual([[{ ...straight, to: [600, 600] }], ['b']]);
    now.pointed = { at: { x: 600, y: 600 }, reachMm: 12 };
    keys.keyDown('Delete', false, false);
    expect(now.scene.objects).toEqual([]);
  });

  it('duplicate it beside itself; again and again it goes on in the same direction', () => {
    const { keys, now, blocks } = keysOverArena();
    for (let i = 0; i < 3; i += 1) keys.keyDown('d', false, true);
    expect(blocks()).toEqual([
      [300, 300],
      [360, 300],
      [420, 300],
      [480, 300],
    ]);
    expect([now.selection.ids, now.steps]).toEqual([[now.scene.objects[3]?.id], 3]);
  });

  it('copy it, which is told as nothing is to be seen of it, and paste it beside', () => {
    const { acts, now, blocks } = keysOverArena();
    acts.copy();
    expect([now.told, now.steps]).toEqual([1, 0]);
    acts.paste();
    acts.paste();
    expect(blocks()).toEqual([
      [300, 300],
      [360, 300],
      [420, 300],
    ]);
  });

  it('paste what a text of another window holds, and nothing of any other text', () => {
    const { acts, now } = keysOverArena(nothingSelected);
    expect(acts.pasteText('import microbit')).toBe(false);
    expect(acts.pasteText(clipText({ objects: [{ ...block, at: [700, 600] }] }))).toBe(true);
    expect(now.scene.objects[1]).toEqual({ ...block, id: 'block-1', at: [700, 600] });
  });

  it('are left to the page where nothing is selected', () => {
    const { keys, now } = keysOverArena(nothingSelected);
    const used = ['Delete', 'ArrowLeft', 'q'].map((key) => keys.keyDown(key, false, false));
    expect([used, now.steps]).toEqual([[false, false, false], 0]);
  });
});
