// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { byId, fieldById, isThere, pressKey, tap, write } from '../../app/testing/find';
import { leavePage, mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts, showLanguage } from '../../kit/i18n';
import { LANGUAGES } from '../../kit/i18n/texts';
import GuidePanel from './GuidePanel.vue';

/** The help over a page, fetched. */
async function help(prepare: (page: TestPage) => void = () => undefined) {
  document.body.insertAdjacentHTML('beforeend', '<div class="app"></div>');
  const page = createPage();
  page.guide.open();
  prepare(page);
  const onTour = vi.fn();
  const panel = mountOn(page, GuidePanel, { onTour });
  await vi.waitFor(() => byId('guide-search'), 20_000);
  await flushPromises();
  const unmount = (): void => leavePage(panel);
  return { page, onTour, unmount };
}
const titles = (): readonly string[] => [...document.querySelectorAll('.guide h3')].map(textOf);
const folds = (): readonly HTMLElement[] => [...document.querySelectorAll<HTMLElement>('.guide .fold')];
const unfolded = (): readonly string[] =>
  folds().filter((it) => it.getAttribute('aria-expanded') === 'true').map(textOf); // prettier-ignore
const items = (): readonly string[] => [...document.querySelectorAll('.guide .item b')].map(textOf);
const search = (text: string): Promise<void> => write(byId('guide-search'), text);
const found = (): string => textOf(byId('guide-found'));
const inApp = (): HTMLElement => document.querySelector<HTMLElement>('.app')!;

beforeEach(() => setWindow(1400, 800));

describe('the help', () => {
  it('begins with the first steps unfolded, then the commands of the robot, then all else folded', async () => {
    await help();
    expect(titles()[0]).toBe('Erste Schritte');
    expect(titles()[1]).toMatch(/^Befehle: \w+$/);
    expect(titles()).toEqual(expect.arrayContaining(['Obere Leiste', 'Konsole', 'Tastatur', 'Befehle: music']));
    expect(unfolded()).toEqual(['Erste Schritte']);
    expect(items()).toContain('Das Programm laufen lassen');
  });

  it('unfolds and folds a section', async () => {
    await help();
    await tap(named('Konsole', '.fold'));
    expect(unfolded()).toEqual(['Erste Schritte', 'Konsole']);
    await tap(named('Konsole', '.fold'));
    await tap(named('Erste Schritte', '.fold'));
    expect(unfolded()).toEqual([]);
    expect(items()).toEqual([]);
  });

  it('has the keyboard in its search', async () => {
    await help();
    expect(document.activeElement).toBe(byId('guide-search'));
    expect(byId('guide-search').getAttribute('aria-label')).toBe('Hilfe durchsuchen');
  });

  it('opens at a requested entry: its section is unfolded and it has the keyboard', async () => {
    const { page } = await help();
    page.guide.open('speed');
    await nextTick();
    await nextTick();
    expect(document.activeElement?.id).toBe('guide-speed');
    expect(unfolded()).toContain('Obere Leiste');
  });

  it('shows keys as keys', async () => {
    await help();
    await tap(named('Tastatur', '.fold'));
    const keys = [...document.querySelectorAll('.guide kbd')].map(textOf);
    expect(keys).toContain('F1');
  });

  it.each(LANGUAGES)('is in the language of the page: %s', async (language) => {
    await loadTexts(language);
    showLanguage(language);
    await help((page) => page.settings.change({ language }));
    const title = { de: 'Hilfe', en: 'Help', fr: 'Aide', it: 'Aiuto' }[language];
    expect(textOf(document.querySelector('.guide h2'))).toBe(title);
    expect(items().every((item) => item !== '')).toBe(true);
  });

  it('leads to the licences of its parts in another tab', async () => {
    await help();
    const link = byId('guide-licences');
    expect([link.getAttribute('href'), link.getAttribute('target')]).toEqual(['./LICENSES.txt', '_blank']);
  });
});

describe('the search of the help', () => {
  it('finds a thing by its name, first, and says how much there is', async () => {
    await help();
    await search('Stopp');
    const count = document.querySelectorAll('.guide .item, .guide .commands li').length;
    expect(found()).toBe(count === 1 ? '1 Treffer' : `${String(count)} Treffer`);
    expect(count).toBeGreaterThan(0);
    expect(folds()).toEqual([]);
  });

  it.each([
    ['de', 'ZURUCK start', 'reset', 'zeitlupe'],
    ['fr', 'arrete les moteurs', 'stop', 'ralenti'],
    ['it', 'velocita', 'speed', 'rallentatore'],
    ['en', 'back to start', 'reset', 'slow motion'],
  ] as const)('finds a button in %s by “%s”, and one by a word of its text', async (language, query, entry, inText) => {
    await loadTexts(language);
    showLanguage(language);
    await help((page) => page.settings.change({ language }));
    const isFound = (id: string): boolean => document.querySelector(`#guide-${id}`) !== null;
    await search(query);
    expect(isFound(entry)).toBe(true);
    await search(inText);
    expect([isFound('speed'), isFound('save-scene')]).toEqual([true, false]);
  });

  it('finds a command by its name', async () => {
    await help();
    await search('display.show');
    const none = found();
    await search('show');
    const commands = [...document.querySelectorAll<HTMLElement>('.guide .command')].map((it) => it.dataset['command']);
    expect([none, commands.some((name) => name?.includes('show'))]).toEqual([expect.any(String), true]);
  });

  it('says that there is nothing, and what to try', async () => {
    await help();
    await search('xyzzyx');
    expect(found()).toBe('Nichts gefunden.');
    expect(textOf(byId('guide'))).toContain('Versuche es mit einem kürzeren oder einem anderen Wort.');
    expect(titles()).toEqual([]);
  });

  it('is emptied by its button, which gives the keyboard back to it; all sections are there again', async () => {
    await help();
    const before = titles();
    await search('Stopp');
    await tap(named('Suche leeren'));
    expect(fieldById('guide-search').value).toBe('');
    expect(document.activeElement).toBe(byId('guide-search'));
    expect(titles()).toEqual(before);
    expect(found()).toBe('');
  });

  it('is emptied by the first Escape; the second closes the help', async () => {
    const { page } = await help();
    await search('Stopp');
    await pressKey('Escape', byId('guide-search'));
    expect(fieldById('guide-search').value).toBe('');
    expect(page.guide.at.value).toBe('');
    await pressKey('Escape', byId('guide-search'));
    expect(page.guide.at.value).toBeNull();
  });

  it('gives way to an entry that is asked for', async () => {
    const { page } = await help();
    await search('Stopp');
    page.guide.open('speed');
    await nextTick();
    await nextTick();
    expect(fieldById('guide-search').value).toBe('');
    expect(document.activeElement?.id).toBe('guide-speed');
  });
});

describe('the commands in the help', () => {
  it('are those of the robot that is in use', async () => {
    const { page } = await help();
    const before = titles()[1];
    page.settings.change({ robot: 'callibot' });
    await vi.waitFor(() => expect(titles()[1]).toBe('Befehle: callibot'), 20_000);
    expect(before).not.toBe('Befehle: callibot');
  });

  it('say that the editor is not ready where there is none', async () => {
    await help();
    await search('show');
    const command = document.querySelector<HTMLElement>('.guide .command')!;
    await tap(command);
    expect(found()).toBe('Der Editor ist noch nicht bereit. Versuche es gleich nochmals.');
  });

  it('each are explained to a screen reader', async () => {
    await help();
    await search('show');
    for (const command of document.querySelectorAll('.guide .command')) {
      expect(command.getAttribute('aria-label')).toMatch(/ ins Programm einfügen$/);
      expect(textOf(document.getElementById(command.getAttribute('aria-describedby')!))).not.toBe('');
    }
  });
});

describe('the help on the page', () => {
  it('is a region beside the page, which stays in use', async () => {
    await help();
    expect(byId('guide').getAttribute('role')).toBe('region');
    expect(inApp().hasAttribute('inert')).toBe(false);
  });

  it('is a dialog over all of a phone; nothing behind it is reached until it goes', async () => {
    setWindow(390, 800);
    const { unmount, page } = await help();
    expect(byId('guide').getAttribute('role')).toBe('dialog');
    expect(byId('guide').getAttribute('aria-modal')).toBe('true');
    expect(inApp().hasAttribute('inert')).toBe(true);
    expect(page.layout.isHelpShown.value).toBe(true);
    unmount();
    expect(inApp().hasAttribute('inert')).toBe(false);
    expect(page.layout.isHelpShown.value).toBe(false);
  });

  it('gives the keyboard back to what had it', async () => {
    const button = document.body.appendChild(document.createElement('button'));
    button.focus();
    const { unmount } = await help();
    expect(document.activeElement).not.toBe(button);
    unmount();
    expect(document.activeElement).toBe(button);
  });

  it('begins the tour, or goes on with it, and makes room for it', async () => {
    const { page, onTour } = await help();
    expect(textOf(byId('guide-tour'))).toBe('Rundgang starten');
    page.settings.change({ tourStep: 'arena' });
    await nextTick();
    expect(textOf(byId('guide-tour'))).toBe('Rundgang fortsetzen');
    await tap('guide-tour');
    expect(onTour).toHaveBeenCalledOnce();
    expect(page.guide.at.value).toBeNull();
  });

  it('is closed by its button', async () => {
    const { page } = await help();
    expect(isThere('guide-close')).toBe(true);
    await tap('guide-close');
    expect(page.guide.at.value).toBeNull();
  });
});
