// @vitest-environment happy-dom
import { EditorView } from '@codemirror/view';
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import CodeLoading from './CodeLoading.vue';
import CodePane from './CodePane.vue';

/** The pane of a project with these files, and the editor in it. */
async function pane(
  files: Readonly<Record<string, string>>,
  prepare: (page: ReturnType<typeof createPage>) => void = () => undefined,
) {
  const page = createPage();
  const list = Object.entries(files).map(([name, text]) => ({ name, text }));
  page.work.openProject({ files: list, scene: page.work.scene.value, course: null }, null);
  prepare(page);
  const mounted = mountOn(page, CodePane);
  await flushPromises();
  await nextTick();
  const view = EditorView.findFromDOM(mounted.get<HTMLElement>('.cm-editor').element);
  if (view === null) throw new Error('There is no editor.');
  const wrong = () => [...view.dom.querySelectorAll('.cm-wrongLine')].map((it) => it.textContent);
  const cursorLine = () => view.state.doc.lineAt(view.state.selection.main.head).number;
  const type = (at: number, insert: string) =>
    view.dispatch({ changes: { from: at, insert }, userEvent: 'input.type' });
  return { page, mounted, view, wrong, cursorLine, type };
}
const three = 'eins\nzwei\ndrei\n';

describe('the pane of the program', () => {
  beforeAll(() => import('./CodeEditor.vue'));

  it('is called the program, and the editor says how the keyboard leaves it', async () => {
    const { mounted, view } = await pane({ 'main.py': three });
    expect(mounted.attributes('aria-label')).toBe('Programm');
    expect(view.contentDOM.getAttribute('aria-label')).toBe(
      'Programm main.py. F1 erklärt ein Wort. Esc, dann Tab führt weiter.',
    );
    expect(view.contentDOM.getAttribute('spellcheck')).toBe('false');
  });

  it('shows the program to read while the editor is still on its way', () => {
    const page = createPage();
    const text = 'from microbit import *\n  display.show(1)\n';
    page.work.openProject({ files: [{ name: 'main.py', text }], scene: page.work.scene.value, course: null }, null);
    expect(mountOn(page, CodeLoading).element.textContent).toBe(text);
  });

  it('keeps what is typed in the work', async () => {
    const { page, type } = await pane({ 'main.py': three });
    type(4, '!');
    expect(page.work.open.value.text).toBe('eins!\nzwei\ndrei\n');
  });

  it('shows what comes from elsewhere: a link, undone steps, a host', async () => {
    const { page, view } = await pane({ 'main.py': three });
    page.work.setText('main.py', 'neu\n');
    await nextTick();
    expect(view.state.doc.toString()).toBe('neu\n');
  });

  it('shows the file whose tab is chosen, and keeps the cursor of the other one', async () => {
    const { page, view, cursorLine } = await pane({ 'main.py': three, 'helfer.py': 'x = 1\n' });
    view.dispatch({ selection: { anchor: view.state.doc.line(3).from } });
    named('helfer.py', '[role="tab"]').click();
    await nextTick();
    expect(view.state.doc.toString()).toBe('x = 1\n');
    page.work.show('main.py');
    await nextTick();
    expect(view.state.doc.toString()).toBe(three);
    expect(cursorLine()).toBe(3);
  });

  it('runs with Ctrl+Enter', async () => {
    const { page, view } = await pane({ 'main.py': three });
    view.contentDOM.dispatchEvent(
      new KeyboardEvent('keydown', { key: 'Enter', ctrlKey: true, bubbles: true, cancelable: true }),
    );
    expect(page.run.phase.value).toBe('starting');
    expect(page.work.open.value.text).toBe(three);
  });

  it('speaks another language at once, with the same text and cursor', async () => {
    const { page, view } = await pane({ 'main.py': three });
    view.dispatch({ selection: { anchor: 7 } });
    page.settings.change({ language: 'fr' });
    await nextTick();
    await nextTick();
    expect(view.state.doc.toString()).toBe(three);
    expect(view.state.selection.main.head).toBe(7);
  });
});

describe('a line that is wrong', () => {
  beforeAll(() => import('./CodeEditor.vue'));

  it('is marked until it is mended; a change elsewhere leaves the mark', async () => {
    const { page, wrong, type } = await pane({ 'main.py': three });
    page.jump.wrong.value = { file: 'main.py', line: 2, device: 0 };
    await nextTick();
    expect(wrong()).toEqual(['zwei']);
    type(0, '# ');
    expect(wrong()).toEqual(['zwei']);
    type(8, 'X');
    expect(wrong()).toEqual([]);
  });

  it('moves with its text', async () => {
    const { page, wrong, type } = await pane({ 'main.py': three });
    page.jump.wrong.value = { file: 'main.py', line: 3, device: 0 };
    await nextTick();
    type(0, '\n\n');
    expect(wrong()).toEqual(['drei']);
  });

  it('is marked in another file once that file is shown', async () => {
    const { page, wrong } = await pane({ 'main.py': three, 'helfer.py': 'x = 1\ny = 2\n' });
    page.jump.wrong.value = { file: 'helfer.py', line: 2, device: 0 };
    await nextTick();
    expect(wrong()).toEqual([]);
    page.work.show('helfer.py');
    await nextTick();
    expect(wrong()).toEqual(['y = 2']);
  });

  it('loses its mark with the next run', async () => {
    const { page, wrong } = await pane({ 'main.py': three });
    page.jump.wrong.value = { file: 'main.py', line: 2, device: 0 };
    await nextTick();
    void page.run.start();
    await nextTick();
    expect(wrong()).toEqual([]);
  });

  it('is marked as changed, apart from what is wrong, until it is typed in', async () => {
    const { page, view, wrong, type } = await pane({ 'main.py': three });
    const changed = () => [...view.dom.querySelectorAll('.cm-changedLine')].map((it) => it.textContent);
    page.jump.wrong.value = { file: 'main.py', line: 2, device: 0 };
    page.jump.changed.value = [1, 3].map((line) => ({ file: 'main.py', line, device: 0 }));
    await nextTick();
    expect([changed(), wrong()]).toEqual([['eins', 'drei'], ['zwei']]);
    type(0, '!');
    expect(changed()).toEqual(['drei']);
    page.jump.changed.value = [];
    await nextTick();
    expect(changed()).toEqual([]);
  });

  it('beyond the end of the file marks nothing', async () => {
    const { page, wrong } = await pane({ 'main.py': three });
    page.jump.wrong.value = { file: 'main.py', line: 99, device: 0 };
    await nextTick();
    expect(wrong()).toEqual([]);
  });

  it('is jumped to: the cursor stands there, the wish is done', async () => {
    const { page, cursorLine } = await pane({ 'main.py': three, 'helfer.py': 'x = 1\ny = 2\n' });
    page.jump.to({ file: 'helfer.py', line: 2 });
    await nextTick();
    await nextTick();
    expect(page.work.open.value.name).toBe('helfer.py');
    expect(cursorLine()).toBe(2);
    expect(page.jump.target.value).toBeNull();
  });

  it('beyond the end is jumped to as the last', async () => {
    const { page, cursorLine } = await pane({ 'main.py': three });
    page.jump.to({ file: 'main.py', line: 99 });
    await nextTick();
    await nextTick();
    expect(cursorLine()).toBe(4);
  });

  it('is jumped to when the editor comes if it was wished for before', async () => {
    const { page, cursorLine } = await pane({ 'main.py': three }, ({ jump }) => jump.to({ file: 'main.py', line: 3 }));
    expect(cursorLine()).toBe(3);
    expect(page.jump.target.value).toBeNull();
  });
});

describe('what is hidden beside the program', () => {
  beforeAll(() => import('./CodeEditor.vue'));
  const has = (name: string): boolean => document.querySelector(`[aria-label="${name}"]`) !== null;

  it('can be brought back from here', async () => {
    const { page } = await pane({ 'main.py': '' }, ({ settings }) =>
      settings.change({ showBoard: false, showArena: false }),
    );
    named('Mikrocomputer zeigen').click();
    named('Arena zeigen').click();
    expect(page.settings.current.value).toMatchObject({ showBoard: true, showArena: true });
    await nextTick();
    expect([has('Mikrocomputer zeigen'), has('Arena zeigen')]).toEqual([false, false]);
  });

  it('is not offered on a phone, where each has its tab', async () => {
    setWindow(390, 800);
    await pane({ 'main.py': '' }, ({ settings }) => settings.change({ showBoard: false, showArena: false }));
    expect([has('Mikrocomputer zeigen'), has('Arena zeigen')]).toEqual([false, false]);
  });
});
