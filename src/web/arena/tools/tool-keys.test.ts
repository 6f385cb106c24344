import { describe, expect, it } from 'vitest';
import { usualToolOptions } from '#editor/tools/tool-options';
import { nothingSelected, type Selection } from '#editor/tools/tool';
import { applyEdit } from '#scene/edit';
import { defaultScene, type Block, type Scene } from '#scene/scene';
import { Clipboard } from '../../course-editor/state/clipboard';
import { createSelectionKeys } from './tool-keys';

const block: Block = { type: 'block', id: 'b', at: [300, 300], size: [50, 50], angle: 0 };

function keysOverArena(selection: Selection = { ids: ['b'], robot: false }, clipboard = new Clipboard()) {
  const now = { scene: { ...defaultScene(), objects: [block] } as Scene, selection, steps: 0, copies: 0 };
  const keys = createSelectionKeys({
    context: () => ({ scene: now.scene, selection: now.selection, options: usualToolOptions, footprint: [] }),
    commit(edit, select) {
      now.scene = applyEdit(now.scene, edit);
      now.selection = select ?? now.selection;
      now.steps += 1;
    },
    select: (chosen) => (now.selection = chosen),
    clipboard,
    copied: () => (now.copies += 1),
    changed: () => undefined,
  });
  const blocks = (): unknown => now.scene.objects.map((object) => (object.type === 'block' ? object.at : null));
  return { keys, now, blocks };
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

  it('copy it, and paste it further away each time', () => {
    const { keys, now, blocks } = keysOverArena();
    keys.keyDown('c', false, true);
    expect(now.copies).toBe(1); // is said: nothing is to be seen of it
    keys.keyDown('v', false, true);
    keys.keyDown('v', false, true);
    expect(blocks()).toEqual([
      [300, 300],
      [320, 280],
      [340, 260],
    ]);
    expect(new Set(now.scene.objects.map(({ id }) => id)).size).toBe(3);
    expect(now.selection.ids).toEqual([now.scene.objects[2]?.id]);
  });

  it('paste into another course what was copied in this one, and have nothing to paste before', () => {
    const clipboard = new Clipboard();
    expect(keysOverArena(nothingSelected).keys.keyDown('v', false, true)).toBe(false);
    keysOverArena(undefined, clipboard).keys.keyDown('c', false, true);
    const other = keysOverArena(nothingSelected, clipboard);
    expect(other.keys.keyDown('v', false, true)).toBe(true);
    expect(other.blocks()).toEqual([
      [300, 300],
      [320, 280],
    ]);
  });

  it('are left to the page where nothing is selected', () => {
    const { keys, now } = keysOverArena(nothingSelected);
    const used = ['Delete', 'ArrowLeft', 'q'].map((key) => keys.keyDown(key, false, false));
    expect([used, now.steps]).toEqual([[false, false, false], 0]);
  });
});
