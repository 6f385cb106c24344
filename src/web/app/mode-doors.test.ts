// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import EditorMenu from '../course/editor/EditorMenu.vue';
import { allTools } from '../course/editor/palette/tool-list';
import { useSelectionActs } from '../course/editor/state/use-selection-acts';
import { useEditorKeys } from '../course/editor/use-editor-keys';
import { appSimulator } from '../exchange/host/app-simulator';
import { ARENA_MODES, type ArenaMode } from '../session/mode/mode-model';
import { editingPage, keyOn, samples, type EditingPage } from './testing/editing';
import { byId } from './testing/find';
import { mountOn } from './testing/mount-on';
import { show, startRun } from './testing/run';

beforeEach(() => {
  document.body.replaceChildren();
  sessionStorage.clear();
  localStorage.clear();
});

/** A page with a run, on which something was drawn, taken back and is selected as far as the mode allows it. */
async function inMode(mode: ArenaMode): Promise<EditingPage> {
  const page = await editingPage([samples.stroke, samples.block, samples.wall]);
  const { editor } = page;
  editor.commit({ type: 'remove', ids: [samples.stroke.id] });
  editor.commit({ type: 'remove', ids: [samples.wall.id] });
  editor.undo();
  await startRun(page);
  await show(page, { timeUs: 1_000_000 });
  page.run.pause();
  page.mode.enter(mode);
  await nextTick();
  expect(page.mode.current.value).toBe(mode);
  editor.choose('select');
  editor.select({ ids: [samples.block.id, samples.wall.id], robot: false });
  return page;
}

const added = { type: 'add', objects: [{ ...samples.target, id: 'new' }] } as const;
const acts = (act: (does: ReturnType<typeof useSelectionActs>) => void) => (page: EditingPage) =>
  act(useSelectionActs(page));
/** A key, with all keys of the editor listening, as if the page had forgotten to take them away. */
const key =
  (name: string, more: KeyboardEventInit = {}) =>
  async (page: EditingPage): Promise<void> => {
    page.scope.run(() => useEditorKeys(page));
    await keyOn(document.body, name, more);
    await vi.dynamicImportSettled();
    page.scope.stop();
  };
function paste(page: EditingPage): Promise<void> {
  const given = useSelectionActs(page);
  given.copy();
  given.paste();
  return nextTick();
}
async function clear(page: EditingPage): Promise<void> {
  mountOn(page, EditorMenu);
  byId('editor-clear').click();
  await nextTick();
}

/** Every way in which a pupil changes the course. */
const WAYS: Readonly<Record<string, (page: EditingPage) => unknown>> = {
  'an edit of a tool': ({ editor }) => editor.commit(added),
  undo: ({ editor }) => editor.undo(),
  redo: ({ editor }) => editor.redo(),
  'mirroring the selection': acts((does) => does.mirror('x')),
  'aligning the selection': acts((does) => does.align('left')),
  'turning the selection': acts((does) => does.turn(45)),
  'grouping the selection': acts((does) => does.group()),
  'locking the selection': acts((does) => does.lock()),
  'doubling the selection': acts((does) => does.duplicate()),
  'removing the selection': acts((does) => does.remove()),
  'pasting what was copied': paste,
  'the key Delete': key('Delete'),
  'Ctrl+Z': key('z', { ctrlKey: true }),
  'Ctrl+Y': key('y', { ctrlKey: true }),
  'Ctrl+D': key('d', { ctrlKey: true }),
  'Ctrl+G': key('g', { ctrlKey: true }),
  'the entry that clears the course': clear,
};

describe.each(ARENA_MODES)('in the mode %s', (mode) => {
  it.each(Object.entries(WAYS))('%s changes the course if it is built, and only then', async (_, way) => {
    const page = await inMode(mode);
    const before = page.scene();
    await way(page);
    await vi.dynamicImportSettled();
    await nextTick();
    expect(page.scene() !== before).toBe(mode === 'build');
  });

  it.each(allTools)(
    'the tool %s can be taken if something is built, and only then; the hand is always there',
    async (tool) => {
      const page = await inMode(mode);
      page.editor.choose(tool);
      expect(page.editor.tool.value).toBe(mode === 'build' ? tool : 'hand');
    },
  );

  it('a picture that is dropped or pasted opens its window where something can be built, and changes nothing by itself', async () => {
    const page = await inMode(mode);
    const before = page.scene();
    expect(page.panels.offer(new Blob(['picture']))).toBe(true);
    expect([page.panels.shown.value, page.mode.current.value]).toEqual(
      mode === 'lookBack' ? [null, 'lookBack'] : ['background', 'build'],
    );
    expect(page.scene()).toBe(before);
  });

  it('a host may edit the present, not the past', async () => {
    const page = await inMode(mode);
    const before = page.scene();
    const said = appSimulator(page).edit(added);
    expect([said === null, page.scene() !== before]).toEqual(mode === 'lookBack' ? [false, false] : [true, true]);
  });

  it.each(ARENA_MODES)('a host that enters the mode %s changes no course', async (wished) => {
    const page = await inMode(mode);
    const before = page.scene();
    const simulator = appSimulator(page);
    expect([simulator.enterMode(wished), simulator.mode()]).toEqual([null, wished]);
    expect(page.scene()).toBe(before);
  });

  it('windows on the course open if something is built, and only then; that for printing always does', async () => {
    const page = await inMode(mode);
    for (const panel of ['parts', 'list', 'course', 'background'] as const) {
      page.panels.open(panel);
      expect(page.panels.shown.value).toBe(mode === 'build' ? panel : null);
    }
    page.panels.open('print');
    expect(page.panels.shown.value).toBe('print');
  });
});
