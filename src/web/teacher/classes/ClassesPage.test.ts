// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { addResults } from '#school-class/add-results';
import { classToText } from '#school-class/class-file';
import { withList } from '#school-class/class-list';
import { newClass } from '#school-class/school-class';
import { aResult, aTask, found } from '#school-class/testing/class';

import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { stubDatabase } from '../../session/work/storage/testing/memory-database';
import { classOf } from '../class/use-class';
import { ClassBook } from '../class-book/class-book';
import ClassesPage from './ClassesPage.vue';
import { KeptClasses } from '../class-book/kept-classes';
import { classBookOf } from '../class-book/use-class-book';

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  document.body.replaceChildren();
  stubDatabase();
});
afterEach(() => vi.unstubAllGlobals());

const list = withList(newClass('8b'), ['Ada Meier', 'Ben Huber']);
const given = { task: aTask('bend'), found: found('Die Kurve', { Ada: aResult(4), Zoe: aResult(2) }), day: '2026-11-02' }; // prettier-ignore
const { schoolClass } = addResults(list, given);

async function opened(): Promise<ReturnType<typeof createPage>> {
  const page = createPage();
  mountOn(page, ClassesPage);
  await vi.waitFor(() => expect(isThere('classes-page')).toBe(true));
  return page;
}
const rowsShown = (): readonly string[] =>
  [...document.querySelectorAll('[data-testid=classes-table] tbody tr')].map((row) => textOf(row));

describe('the page of classes', () => {
  it('begins a class with a pasted list and grades, and says where it stands', async () => {
    const page = await opened();
    await tap('classes-begin');
    await write(byId('class-names'), 'Vorname\tName\nAda\tMeier\nBen\tHuber');
    await tap('class-dialog-done');
    expect(isThere('class-dialog-done')).toBe(true); // not without a name
    await write(byId('class-name'), 'Klasse 8b');
    await tap('class-dialog-done');
    expect(rowsShown()).toEqual(['Ada Meier 0 /0', 'Ben Huber 0 /0']);
    expect(classBookOf(page).isUnsaved.value).toBe(true);
  });

  it('shows points, stars and who is missing, and offers what was checked until it is entered', async () => {
    const page = await opened();
    classBookOf(page).add(schoolClass, true);
    await flushPromises();
    expect(rowsShown()).toEqual([
      'Ada Meier bestanden: 4/44 /4',
      'Ben Huber fehlt0 /4',
      'Zoe nicht auf der Listeteilweise: 2/42 /4',
    ]);
    expect(textOf(byId('classes-missing'))).toBe('«Die Kurve»: Noch 1 ohne Abgabe (Ben Huber)');
    const checked = classOf(page);
    checked.task.value = { name: 'Die Kurve', from: 'file', task: aTask('bend') };
    checked.rows.value = [{ name: 'Ben', shown: 'Ben', handIn: null, result: aResult(4), note: '' }];
    await flushPromises();
    expect(textOf(byId('classes-checked'))).toContain('Abgaben zu «Die Kurve», geprüft und noch nicht eingetragen: 1');
    await tap('classes-enter');
    expect(rowsShown()[1]).toBe('Ben Huber bestanden: 4/44 /4');
    expect(isThere('classes-checked')).toBe(false);
    page.notices.current.value?.action?.run();
    await flushPromises();
    expect(rowsShown()[1]).toBe('Ben Huber fehlt0 /4');
  });

  it('draws the first rows of a large class, and the others when somebody scrolls to them', async () => {
    const page = await opened();
    const names = Array.from({ length: 90 }, (_, place) => `Kind ${'abcdefghi'.charAt(place / 10)}${'klmnopqrst'.charAt(place % 10)}`); // prettier-ignore
    classBookOf(page).add(withList(newClass('8b'), names), true);
    await flushPromises();
    expect(rowsShown()).toHaveLength(40);
    byId('classes-table').parentElement!.dispatchEvent(new Event('scroll'));
    await flushPromises();
    expect(rowsShown()).toHaveLength(80);
  });

  it('joins a second row with the pupil that it belongs to', async () => {
    const page = await opened();
    classBookOf(page).add(schoolClass, true);
    await flushPromises();
    document.querySelectorAll<HTMLElement>('[data-testid=classes-pupil]')[2]!.click();
    await flushPromises();
    const also = byId('class-pupil-also') as HTMLSelectElement;
    also.value = 'ben-huber';
    also.dispatchEvent(new Event('change'));
    await flushPromises();
    await tap('class-dialog-done');
    expect(rowsShown()).toEqual(['Ada Meier bestanden: 4/44 /4', 'Ben Huber teilweise: 2/42 /4']);
  });
});

describe('a class that the browser keeps', () => {
  const booked = async (): Promise<ClassBook> => {
    const book = new ClassBook(new KeptClasses());
    await vi.waitFor(() => expect(book.isReady.value).toBe(true));
    return book;
  };

  it('is there again; what two tabs have added is in both; and it is gone when it is no longer kept', async () => {
    const one = await booked();
    one.add(list, false);
    await one.keep(true);
    const two = await booked();
    expect(classToText(two.chosen.value!.schoolClass)).toBe(classToText(list));
    one.change(() => schoolClass);
    await one.keep(true);
    two.change(() => ({ ...list, name: '8b', scale: { system: 'ch6', passPercent: null, step: 0.5 } }));
    await two.keep(true);
    expect(two.chosen.value!.schoolClass).toMatchObject({ scale: { system: 'ch6' }, results: schoolClass.results });
    await two.keep(false);
    expect((await booked()).classes.value).toEqual([]);
  });
});
