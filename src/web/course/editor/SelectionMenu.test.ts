// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { changing } from '#editor/edits';
import { noLocks } from '#check/task/task';
import type { SceneObject } from '#scene/scene';

import { editingPage, samples } from '../../app/testing/editing';
import { mountOn } from '../../app/testing/mount-on';
import SelectionMenu from './SelectionMenu.vue';
import type { TaskLocks } from '../../session/work/model/task-locks';
import type { MenuPlace } from './state/course-editor-model';
import WordsField from './WordsField.vue';

const menu = () => document.querySelector<HTMLElement>('[data-testid="selection-menu"]');
const entry = (name: string) => document.querySelector<HTMLElement>(`[data-testid="menu-${name}"]`);

async function opened(ids: readonly string[], on: MenuPlace['on'] = 'things') {
  const page = await editingPage([samples.wall, samples.block, { ...samples.block, id: 'other', at: [900, 700] }]);
  page.editor.choose('select');
  page.editor.select({ ids, robot: false });
  mountOn(page, SelectionMenu, {});
  const host = document.createElement('button');
  document.body.append(host);
  const fit = vi.fn();
  const open = async () => {
    page.editor.menu.value = { xPx: 100, yPx: 100, atMm: { x: 500, y: 600 }, on, host, fit };
    await vi.waitFor(() => expect(entry('paste')).not.toBeNull());
  };
  await open();
  const choose = async (name: string) => {
    if (entry(name) === null) await open();
    entry(name)!.click();
    await nextTick();
  };
  return { ...page, host, fit, open, choose };
}

it('is only for looking where the open task locks the course', async () => {
  const { work, ...page } = await opened(['block']);
  work.locks.task.value = { locks: { ...noLocks, course: true }, hasTool: (tool: string) => tool === 'hand' } as unknown as TaskLocks; // prettier-ignore
  for (const on of ['things', 'floor'] as const) {
    page.editor.menu.value = { xPx: 1, yPx: 1, atMm: { x: 500, y: 600 }, on, host: page.host, fit: page.fit };
    await vi.waitFor(() => expect(entry('fit')).not.toBeNull());
    expect([...document.querySelectorAll('[data-testid^="menu-"]')]).toEqual([entry('fit')]);
  }
});

describe('the menu of what is selected', () => {
  it('is a menu with a name, entered by the keyboard, which goes back where it came from', async () => {
    const { host } = await opened(['block']);
    expect([menu()?.getAttribute('role'), menu()?.getAttribute('aria-label')]).toEqual(['menu', 'Menü der Auswahl']);
    await vi.waitFor(() => expect(document.activeElement).toBe(entry('cut')));
    document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));
    await vi.waitFor(() => expect(document.activeElement).toBe(host));
  });

  it('copies, duplicates, removes, each as one step', async () => {
    const { choose, ids, steps } = await opened(['block']);
    await choose('copy');
    expect(steps()).toBe(0);
    await choose('duplicate');
    expect([ids().length, steps()]).toEqual([4, 1]);
    await choose('remove');
    expect([ids(), steps()]).toEqual([['wall', 'block', 'other'], 2]);
  });

  it('aligns, mirrors and orders; every small picture has a name', async () => {
    const { choose, object, ids, open } = await opened(['block', 'other']);
    await choose('left');
    expect(object('block', 'other').at[0]).toBe(samples.block.at[0]);
    await open();
    expect(entry('spreadX')?.getAttribute('aria-disabled')).toBe('true');
    await choose('back');
    expect(ids()).toEqual(['block', 'other', 'wall']);
    await open();
    const named = [...document.querySelectorAll('.cell')].map((cell) => cell.getAttribute('aria-label'));
    expect([named.length, named.every((name) => name !== null && name.length > 5)]).toEqual([15, true]);
  });

  it('groups, and dissolves what is a group', async () => {
    const { choose, object, open, steps } = await opened(['block', 'other']);
    await choose('group');
    expect([object('block', 'block').group, object('block', 'other').group, steps()]).toEqual([
      'group-1',
      'group-1',
      1,
    ]);
    await open();
    expect(entry('group')).toBeNull();
    await choose('ungroup');
    expect([object('block', 'block').group, steps()]).toEqual([undefined, 2]);
  });

  it('locks; what is locked can be unlocked and copied, and nothing else', async () => {
    const { choose, object, open, ids } = await opened(['block']);
    await choose('lock');
    expect(object('block', 'block').lock).toBe(true);
    await open();
    const names = [...menu()!.querySelectorAll('[role="menuitem"]')].map((item) => item.getAttribute('data-testid'));
    expect(names).toEqual(['menu-unlock', 'menu-copy', 'menu-paste', 'menu-duplicate', 'menu-keep']);
    await choose('unlock');
    expect([object('block', 'block').lock, ids()]).toEqual([undefined, ['wall', 'block', 'other']]);
  });

  it('has the points of what has some, and of nothing else', async () => {
    const { choose, editor, object } = await opened(['block']);
    expect(entry('points')).toBeNull();
    const corners = [[0, 0], [50, 0], [0, 50]] as const; // prettier-ignore
    editor.commit(changing([{ ...object('block', 'block'), corners }])!);
    await nextTick();
    await choose('points');
    expect(editor.tool.value).toBe('points');
  });

  it('pastes on the floor, selects all, shows the whole arena', async () => {
    const { choose, fit, editor, ids, object } = await opened(['block'], 'floor');
    expect(entry('cut')).toBeNull();
    editor.clipboard.take({ objects: [samples.block] }, '');
    await choose('paste');
    await vi.waitFor(() => expect(ids()).toHaveLength(4));
    expect(object('block', ids()[3]!).at).toEqual([500, 600]);
    await choose('selectAll');
    expect(editor.selection.value.ids).toHaveLength(4);
    await choose('fit');
    expect(fit).toHaveBeenCalledOnce();
  });
});

describe('the words of a label in their place', () => {
  const label: SceneObject = { type: 'label', id: 'l', at: [300, 300], text: 'Start', height: 30, angle: 0 };

  it('are taken with Enter as one step, and not with Escape', async () => {
    const page = await editingPage([label]);
    mountOn(page, WordsField, {});
    const write = async (text: string, key: string) => {
      page.editor.words.value = { id: 'l', xPx: 300, yPx: 300, host: null };
      await nextTick();
      await nextTick();
      const field = document.querySelector<HTMLInputElement>('[data-testid="words-field"]')!;
      expect(document.activeElement).toBe(field);
      field.value = text;
      field.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
      await nextTick();
      return page.object('label', 'l').text;
    };
    expect(await write('Ziel', 'Escape')).toBe('Start');
    expect([await write('Ziel', 'Enter'), page.steps()]).toEqual(['Ziel', 1]);
    expect(await write('  ', 'Enter')).toBe('Ziel');
  });
});
