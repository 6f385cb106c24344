// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';

import { downloads } from '../../app/testing/downloads';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import FileList from './FileList.vue';

/** The menu of the file that is open in a project with these files. */
function menu(open: string, ...names: readonly string[]) {
  const page = createPage();
  const files = names.map((name) => ({ name, text: `# ${name}` }));
  page.work.openProject({ files, scene: page.work.scene.value, course: null }, null);
  page.work.show(open);
  mountOn(page, FileList);
  return page;
}
const item = (name: string) => named(name, '[role^="menuitem"]');
const names = ({ work }: ReturnType<typeof createPage>) => work.files.value.map(({ name }) => name);

describe('the menu of a file', () => {
  afterEach(() => void vi.restoreAllMocks());

  it('is called by the file', () => {
    menu('helfer.py', 'main.py', 'helfer.py');
    named('helfer.py', '[role="menu"]');
  });

  it('saves it as a file of its own', () => {
    const page = menu('helfer.py', 'main.py', 'helfer.py');
    const saved = downloads();
    item('Speichern').click();
    expect(saved.map(({ name }) => name)).toEqual(['helfer.py']);
    expect(page.notices.current.value).toMatchObject({ kind: 'ok', key: 'files.saved', values: { file: 'helfer.py' } });
  });

  it('asks for its new name', () => {
    const page = menu('helfer.py', 'main.py', 'helfer.py');
    item('Umbenennen').click();
    const question = page.dialogs.current.value;
    if (question?.kind !== 'name') throw new Error('A file name should be asked for.');
    expect(question).toMatchObject({ title: 'code.renameTitle', values: { file: 'helfer.py' } });
    expect(question.field().own).toBe('helfer.py');
    question.done('fahren.py');
    expect(names(page)).toEqual(['main.py', 'fahren.py']);
    expect(page.work.open.value.text).toBe('# helfer.py');
  });

  it('deletes at once, and brings the file back into its place with what was in it', () => {
    const page = menu('helfer.py', 'main.py', 'helfer.py', 'karte.py');
    item('Löschen').click();
    expect(names(page)).toEqual(['main.py', 'karte.py']);
    expect(page.notices.current.value).toMatchObject({ key: 'notice.fileRemoved', values: { file: 'helfer.py' } });
    page.notices.current.value?.action?.run();
    expect(names(page)).toEqual(['main.py', 'helfer.py', 'karte.py']);
    expect(page.work.open.value).toEqual({ name: 'helfer.py', text: '# helfer.py' });
    expect(page.notices.current.value).toBeNull();
  });

  it('offers it no longer once another file has the name, or another work is open', () => {
    const page = menu('helfer.py', 'main.py', 'helfer.py');
    item('Löschen').click();
    page.work.create('helfer.py', 'other = 1');
    expect(page.notices.current.value).toBeNull();
    page.work.remove('helfer.py');
    page.work.create('helfer.py', 'third = 1');
    item('Löschen').click();
    expect(page.notices.current.value).not.toBeNull();
    page.work.setScene({ ...page.work.scene.value, name: 'another' }, null);
    expect(page.notices.current.value).toBeNull();
  });

  it('leaves main.py its name and its place, and says why', () => {
    const page = menu('main.py', 'main.py', 'helfer.py');
    expect(item('Umbenennen').getAttribute('aria-disabled')).toBe('true');
    expect(item('Löschen').getAttribute('aria-disabled')).toBe('true');
    expect(textOf(document.querySelector('[role="menu"]'))).toContain('main.py ist das Programm und bleibt.');
    item('Umbenennen').click(); // as a screen reader does, whatever is disabled
    item('Löschen').click();
    expect(page.dialogs.current.value).toBeNull();
  });

  it('lists the files to choose from where there are four or more', () => {
    menu('main.py', 'main.py', 'a.py', 'b.py');
    expect(document.querySelectorAll('[role="menuitemradio"]')).toHaveLength(0);
    document.body.innerHTML = '<section id="menus"></section>';
    const page = menu('a.py', 'main.py', 'a.py', 'b.py', 'c.py');
    const files = [...document.querySelectorAll('[role="menuitemradio"]')];
    expect(files.map((it) => textOf(it))).toEqual(['main.py', 'a.py', 'b.py', 'c.py']);
    expect(files.map((it) => it.getAttribute('aria-checked'))).toEqual(['false', 'true', 'false', 'false']);
    named('c.py', '[role="menuitemradio"]').click();
    expect(page.work.open.value.name).toBe('c.py');
  });
});
