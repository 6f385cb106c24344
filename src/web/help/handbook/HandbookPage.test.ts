// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it, vi } from 'vitest';

import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { setLanguage } from '../../kit/i18n';
import HandbookPage from './HandbookPage.vue';
import SheetPage from './SheetPage.vue';

async function open(address: string): Promise<TestPage> {
  history.replaceState(null, '', `#${address}`);
  const page = createPage();
  mountOn(page, HandbookPage);
  await vi.waitFor(() => expect(isThere('chapter-task') || isThere('handbook-heading')).toBe(true), 20_000);
  return page;
}
const heading = (): string => textOf(byId('handbook-heading'));

describe('the handbook', () => {
  it('begins with the first section, and leads on to the next chapter and back', async () => {
    const page = await open('handbook/lesson.ready');
    expect(heading()).toBe('Einen fertigen Parcours nehmen');
    await tap('handbook-next');
    expect([heading(), page.router.page.value?.id]).toEqual(['Bauen', 'draw']);
    await tap('handbook-before');
    expect(heading()).toBe('Einen fertigen Parcours nehmen');
  });

  it('has the sections of the open chapter below it, and opens one', async () => {
    await open('handbook');
    expect([isThere('section-beamer'), isThere('section-worlds')]).toEqual([true, false]);
    await tap('chapter-task');
    await tap('section-worlds');
    expect(heading()).toBe('Welten: dieselbe Aufgabe, anderer Start');
    expect(byId('section-worlds').getAttribute('aria-current')).toBe('page');
  });

  it('finds words of the text, also without their accents, and opens what is found', async () => {
    await open('handbook');
    await write(byId('handbook-search'), 'uberträgt');
    expect(isThere('found-robots')).toBe(true);
    await write(byId('handbook-search'), 'xyzzyx');
    expect(textOf(byId('handbook-found'))).toBe('Nichts gefunden. Versuche es mit einem kürzeren Wort.');
    await write(byId('handbook-search'), 'verborgene Welt');
    await tap('found-task.worlds');
    expect(heading()).toBe('Welten: dieselbe Aufgabe, anderer Start');
  });

  it('shows a page of the program, or a mode of the arena', async () => {
    const page = await open('handbook/task');
    await tap('handbook-show');
    expect(page.router.page.value?.name).toBe('task');
    page.router.open('handbook', 'draw');
    await flushPromises();
    await tap('handbook-show');
    expect([page.router.page.value, page.mode.current.value]).toEqual([null, 'build']);
  });

  it('is a list of chapters first where there is little room', async () => {
    setWindow(390, 844);
    await open('handbook');
    expect(isThere('handbook-heading')).toBe(false);
    await tap('chapter-check');
    expect([heading(), isThere('chapter-check')]).toEqual(['Die Tabelle lesen', false]);
  });

  it('prints all chapters, and the one for pupils by itself', async () => {
    const printed: string[] = [];
    vi.stubGlobal('print', () => printed.push(byId('handbook-paper').textContent));
    await open('handbook');
    await tap('handbook-pdf');
    dispatchEvent(new Event('afterprint'));
    await flushPromises();
    await tap('chapter-class');
    await tap('handbook-pdf');
    expect(printed[0]).toContain('10 · Datenschutz');
    expect(printed[0]).not.toContain('So arbeitest du');
    expect(printed[1]).toContain('Lies die Karte neben dem Programm.');
    expect(printed[1]).not.toContain('Datenschutz');
  });

  it('follows the language of the page', async () => {
    await open('handbook');
    await setLanguage('fr');
    await vi.waitFor(() => expect(heading()).toBe('Le déroulement'), 20_000);
  });
});

describe('the sheet on data protection', () => {
  it('says of everything that is kept what, where, how long, and how it is deleted, and has lines to sign', async () => {
    mountOn(createPage(), SheetPage);
    await vi.waitFor(() => expect(isThere('data-protection')).toBe(true), 20_000);
    const rows = [...document.querySelectorAll('tbody tr')];
    expect(rows.map((row) => row.querySelectorAll('td').length)).toEqual(rows.map(() => 4));
    expect(rows.length).toBe(8);
    expect(textOf(byId('kept-name'))).toContain('Die Seite behält ihn nicht');
    expect([...document.querySelectorAll('dt')].map((field) => field.textContent)).toContain('Unterschrift');
  });
});
