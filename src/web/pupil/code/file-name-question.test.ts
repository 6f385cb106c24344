// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { mountOn, named } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import NameForm from '../../kit/controls/NameForm.vue';
import { fileNameQuestion } from './file-name-question';

/** The form for a new file's name, or with `own` for another name of that file; `done` are the names that were given. */
function form(own = '') {
  const page = createPage();
  const files = ['main.py', 'helfer.py'].map((name) => ({ name, text: '' }));
  page.work.openProject({ files, scene: page.work.scene.value, course: null }, null);
  const done: string[] = [];
  let closed = 0;
  const question = fileNameQuestion(page, own, (name) => void done.push(name));
  const mounted = mountOn(page, NameForm, { ...question.field(), onDone: question.done, onClose: () => (closed += 1) });
  const field = mounted.get<HTMLInputElement>('input');
  const give = async (name: string) => {
    await field.setValue(name);
    await mounted.trigger('submit');
  };
  return { mounted, field, done, give, closed: () => closed, problem: () => mounted.get('[role="status"]').text() };
}

describe('the name of a new file', () => {
  it('is asked for in a field that has the focus and a label', () => {
    const { field } = form();
    expect(named('Dateiname')).toBe(field.element);
    expect(document.activeElement).toBe(field.element);
    named('Erstellen');
  });

  it('gets its ending by itself', async () => {
    const { give, done, closed } = form();
    await give('fahren');
    expect(done).toEqual(['fahren.py']);
    expect(closed()).toBe(1);
  });

  it('may be given with its ending', async () => {
    const { give, done } = form();
    await give('fahren.py');
    expect(done).toEqual(['fahren.py']);
  });

  it('must be there; that is said after the first try only', async () => {
    const { give, done, closed, problem } = form();
    expect(problem()).toBe('');
    await give('');
    expect(problem()).toBe('Gib einen Namen ein.');
    expect(done).toEqual([]);
    expect(closed()).toBe(0);
  });

  it.each([
    ['helfer', 'Diese Datei gibt es schon.'],
    ['helfer.py', 'Diese Datei gibt es schon.'],
    ['mein programm', 'Erlaubt sind Buchstaben, Ziffern, Punkt, - und _.'],
    ['a/b', 'Erlaubt sind Buchstaben, Ziffern, Punkt, - und _.'],
  ])('cannot be %s, which is said while typing', async (name, words) => {
    const { field, give, done, problem } = form();
    await field.setValue(name);
    expect(problem()).toBe(words);
    expect(field.attributes('aria-invalid')).toBe('true');
    await give(name);
    expect(done).toEqual([]);
  });

  it('cannot be endless', async () => {
    const { field, problem } = form();
    await field.setValue('x'.repeat(200));
    expect(problem()).toMatch(/^Höchstens \d+ Zeichen\.$/);
  });

  it('can be left: nothing is made', () => {
    const { done, closed } = form();
    named('Abbrechen').click();
    expect(done).toEqual([]);
    expect(closed()).toBe(1);
  });
});

describe('another name for a file', () => {
  it('starts with the one it has, chosen up to its ending', () => {
    const { field } = form('helfer.py');
    expect(field.element.value).toBe('helfer.py');
    expect([field.element.selectionStart, field.element.selectionEnd]).toEqual([0, 'helfer'.length]);
    named('Umbenennen');
  });

  it('changes nothing if it is the same', async () => {
    const { give, done, closed } = form('helfer.py');
    await give('helfer.py');
    expect(done).toEqual([]);
    expect(closed()).toBe(1);
  });

  it('is given', async () => {
    const { give, done } = form('helfer.py');
    await give('fahren');
    expect(done).toEqual(['fahren.py']);
  });

  it('cannot be that of another file', async () => {
    const { give, done, problem } = form('helfer.py');
    await give('main.py');
    expect(done).toEqual([]);
    expect(problem()).toBe('Diese Datei gibt es schon.');
  });
});
