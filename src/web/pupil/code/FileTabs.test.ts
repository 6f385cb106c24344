// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { byId } from '../../app/testing/find';
import { mountOn, named } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import FileList from './FileList.vue';
import FileTabs from './FileTabs.vue';

/** The tabs of a project with these files; the first is open. */
function tabs(...names: readonly string[]) {
  const page = createPage();
  const files = names.map((name) => ({ name, text: `# ${name}` }));
  page.work.openProject({ files, scene: page.work.scene.value, course: null }, null);
  mountOn(page, FileTabs);
  return { page };
}
const tab = (name: string) => named(name, '[role="tab"]');
const selected = () =>
  [...document.querySelectorAll('[role="tab"][aria-selected="true"]')].map((it) => it.textContent?.trim());

describe('the tabs of the files', () => {
  it('are one for each file; the open one is marked and the only stop of the Tab key', () => {
    tabs('main.py', 'helfer.py');
    named('Dateien', '[role="tablist"]');
    expect([...document.querySelectorAll('[role="tab"]')].map((it) => it.textContent?.trim())).toEqual([
      'main.py',
      'helfer.py',
    ]);
    expect(selected()).toEqual(['main.py']);
    expect([tab('main.py').tabIndex, tab('helfer.py').tabIndex]).toEqual([0, -1]);
    expect(tab('main.py').getAttribute('aria-controls')).toBe('editor-panel');
  });

  it('open their file with a click', async () => {
    const { page } = tabs('main.py', 'helfer.py');
    tab('helfer.py').click();
    await nextTick();
    expect(page.work.open.value.text).toBe('# helfer.py');
    expect(selected()).toEqual(['helfer.py']);
  });

  it('are walked through with the arrow keys, round and round, and keep the focus', async () => {
    tabs('main.py', 'a.py', 'b.py');
    const arrow = async (key: string) => {
      document
        .querySelector('[role="tab"][aria-selected="true"]')
        ?.dispatchEvent(new KeyboardEvent('keydown', { key }));
      await flushPromises();
      await nextTick();
    };
    await arrow('ArrowRight');
    expect(selected()).toEqual(['a.py']);
    expect(document.activeElement).toBe(tab('a.py'));
    await arrow('ArrowLeft');
    await arrow('ArrowLeft');
    expect(selected()).toEqual(['b.py']);
    await arrow('ArrowRight');
    expect(selected()).toEqual(['main.py']);
  });

  it('ask for the name of a new file, which is then open and empty', async () => {
    const { page } = tabs('main.py');
    mountOn(page, FileList);
    byId('new-file').click();
    await vi.dynamicImportSettled();
    const question = page.dialogs.current.value;
    if (question?.kind !== 'name') throw new Error('A file name should be asked for.');
    expect(question).toMatchObject({ title: 'code.newTitle' });
    question.done('fahren.py');
    await nextTick();
    expect(selected()).toEqual(['fahren.py']);
    expect(page.work.open.value).toEqual({ name: 'fahren.py', text: '' });
  });

  it('have a menu that says for which file it is', async () => {
    tabs('main.py', 'helfer.py');
    named('Datei main.py: umbenennen oder löschen');
    tab('helfer.py').click();
    await nextTick();
    named('Datei helfer.py: umbenennen oder löschen');
  });
});
