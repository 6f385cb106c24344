// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { loadTexts, showLanguage } from '../kit/i18n';
import MainList from './MainList.vue';
import MainMenu from './MainMenu.vue';
import SpeedList from '../pupil/arena/SpeedList.vue';
import SpeedMenu from '../pupil/arena/SpeedMenu.vue';
import { downloads } from './testing/downloads';
import { press } from './testing/editing';
import { byId, isThere, pressKey, tap } from './testing/find';
import { mountOn, named, setWindow, textOf } from './testing/mount-on';
import { createPage } from './testing/page';
import { show, startRun } from './testing/run';

const radios = (): readonly HTMLElement[] => [...document.querySelectorAll<HTMLElement>('[role="menuitemradio"]')];
const checked = (): readonly string[] =>
  radios().filter((item) => item.getAttribute('aria-checked') === 'true').map(textOf); // prettier-ignore
const items = (): readonly string[] =>
  [...document.querySelectorAll('[role="menuitem"]')].map((item) =>
    textOf(item.querySelector('.page-list-item-title')),
  );

describe('the list of speeds', () => {
  it('goes from a quarter to as fast as possible', () => {
    mountOn(createPage(), SpeedList);
    expect(radios().map(textOf)).toEqual(['¼×', '½×', '1×', '2×', '4×', '8×', 'max: so schnell wie möglich']);
    expect(checked()).toEqual(['1×']);
  });

  it('has the sound above them, ticked while it is on, and says what a change means', async () => {
    const page = createPage();
    mountOn(page, SpeedList);
    const sound = () => named('Ton', '[role="menuitemcheckbox"]');
    expect(sound().getAttribute('aria-checked')).toBe('true');
    sound().click();
    await nextTick();
    expect([page.settings.own.value.muted, page.notices.current.value?.key]).toEqual([true, 'notice.muted']);
    sound().click();
    await nextTick();
    expect([sound().getAttribute('aria-checked'), page.notices.current.value?.key]).toEqual(['true', 'notice.unmuted']);
  });

  it('sets the speed of a run that is under way', async () => {
    const page = createPage();
    mountOn(page, SpeedList);
    await startRun(page);
    await press('4×', '[role="menuitemradio"]');
    expect(page.sent.at(-1)).toEqual({ type: 'speed', speed: 4 });
    expect(checked()).toEqual(['4×']);
    await press('max: so schnell wie möglich', '[role="menuitemradio"]');
    expect(page.sent.at(-1)).toEqual({ type: 'speed', speed: 'max' });
  });
});

describe('the button of speed and sound', () => {
  /** A page whose run reaches so much. */
  async function reaching(achieved: number, wish: 0.5 | 1 | 4 | 'max') {
    const page = createPage();
    page.settings.change({ speed: wish });
    const button = mountOn(page, SpeedMenu).get('button');
    await startRun(page);
    page.say({ type: 'alive', achieved, nowUs: 0 });
    await nextTick();
    const aside = (): string => button.element.querySelector<HTMLElement>('.reached')?.dataset['words'] ?? '';
    return { page, button, text: () => textOf(button.element), aside };
  }

  it('shows the speed, and says in its name what it is for and whether anything is heard', async () => {
    const page = createPage();
    const button = mountOn(page, SpeedMenu).get('button');
    expect([textOf(button.element), button.attributes('aria-label')]).toEqual(['1×', 'Tempo und Ton: 1×']);
    page.settings.change({ muted: true });
    await nextTick();
    expect(button.attributes('aria-label')).toBe('Tempo und Ton: 1×, Ton aus');
  });

  it('shows no more while the run reaches what is wished', async () => {
    const { text, button } = await reaching(3.96, 4);
    expect(text()).toBe('4×');
    expect(button.classes()).not.toContain('speed--slow');
  });

  it('warns when the device does not manage it, and comforts: the result is the same', async () => {
    const { aside, button } = await reaching(0.62, 1);
    expect(button.classes()).toContain('speed--slow');
    expect(button.attributes('title')).toBe('Dieses Gerät schafft nur 0.62×. Das Ergebnis bleibt gleich.');
    expect(aside()).toBe('0.62×');
  });

  it('does not warn of a tenth', async () => {
    expect((await reaching(0.92, 1)).button.classes()).not.toContain('speed--slow');
    expect((await reaching(0.45, 0.5)).button.classes()).not.toContain('speed--slow');
    expect((await reaching(0.44, 0.5)).button.classes()).toContain('speed--slow');
  });

  it('says with “max” how fast that is, and never that it is too slow', async () => {
    const { button } = await reaching(0.3, 'max');
    expect(button.classes()).not.toContain('speed--slow');
    expect(button.attributes('title')).toBe('Tempo und Ton: max, erreicht 0.30×');
  });

  it('says that the device is computing while the worker is silent', async () => {
    const { page, aside } = await reaching(1, 1);
    page.run.isBusy.value = true;
    await nextTick();
    expect(aside()).toBe('rechnet …');
  });

  it('forgets what was reached when the run stands still', async () => {
    const { page, aside } = await reaching(0.5, 1);
    page.run.pause();
    await nextTick();
    expect(aside()).toBe('');
  });

  it('shows a tone, for users who do not hear it; not while the sound is off or the run pauses', async () => {
    const { page, button } = await reaching(1, 1);
    const sounds = () => button.classes().includes('sounding');
    await show(page, { sound: { hz: 440 } });
    expect(sounds()).toBe(true);
    page.run.pause();
    await nextTick();
    expect(sounds()).toBe(false);
    page.run.resume();
    page.settings.change({ muted: true });
    await nextTick();
    expect(sounds()).toBe(false);
  });
});

/** The entries of the main menu, and what they ask for. */
function mainList(width = 1400) {
  setWindow(width);
  const page = createPage();
  const asked: string[] = [];
  const note = (what: string) => () => asked.push(what);
  const leave = (open: () => void) => {
    asked.push('leave');
    open();
  };
  mountOn(page, MainList, {
    ...{ onInside: note('inside'), onDialog: note('dialog'), onLeave: leave },
  });
  return { page, asked };
}
const pressItem = (name: string) => press(name, '[role^="menuitem"]');

/** The lists of the main menu that an entry leads to, as they are shown now. */
const lists = (): readonly string[] =>
  [...document.querySelectorAll<HTMLElement>('[data-testid^="menu-list-"]')].map(
    ({ dataset }) => dataset['testid'] ?? '',
  );
const entries = (): number => document.querySelectorAll('[role^="menuitem"]').length;
const handedOut = { version: 1, id: 'A', handedOut: true };

describe('the main menu', () => {
  it('has three parts and one entry for teachers', () => {
    mainList();
    expect([...document.querySelectorAll('[role="group"]')].map((part) => part.getAttribute('aria-label'))).toEqual([
      ...['Datei', 'Ansicht', 'Hilfe', null],
    ]);
    expect(items()).toEqual([
      ...['Meine Arbeiten', 'Öffnen …', 'Speichern', 'Auf den Roboter …', 'Versuchsreihe'],
      ...['Sprache', 'Hell oder dunkel', 'Bereiche'],
      ...['Hilfe', 'Rundgang', 'Tasten', 'Roboter-Galerie', 'Für Lehrpersonen'],
    ]);
  });

  it('has on a phone what the small bar leaves out, with what is chosen', () => {
    mainList(390);
    expect(items().slice(0, 5)).toEqual(['Aufgabe', 'Gerät', 'Tempo und Ton', 'Meine Arbeiten', 'Teilen']);
    expect(textOf(named('Tempo und Ton1×', '[role="menuitem"]'))).toBe('Tempo und Ton1×');
    expect(items()).not.toContain('Bereiche'); // there each pane has a tab
  });

  const windows = [['a wide window', 1400], ['a tablet', 1100], ['a tablet held upright', 700], ['a phone', 390]] as const; // prettier-ignore
  it.each(
    windows.flatMap(
      ([name, width]) =>
        [
          [name, 'without a task', width],
          [name, 'with a task', width],
        ] as const,
    ),
  )(
    // prettier-ignore
    'has in %s %s at most 16 entries, in each of its lists, too',
    async (_, what, width) => {
      const { page } = mainList(width);
      const task = what === 'with a task' ? handedOut : undefined;
      page.work.openProject({ ...page.work.work.value.project, ...(task && { task }) }, null);
      page.settings.change({ tell: true });
      await nextTick();
      expect(entries()).toBeLessThanOrEqual(16);
      expect(lists().length).toBeGreaterThan(2);
      for (const list of lists()) {
        await tap(list);
        expect(entries()).toBeGreaterThan(1);
        expect(entries()).toBeLessThanOrEqual(16);
        await tap('menu-back');
      }
    },
  );

  it('leads nobody to the teachers’ page in a task that was handed out, nor where a host says what is shown', async () => {
    const { page } = mainList(390);
    expect(items()).toContain('Für Lehrpersonen');
    page.host.parts.value = ['bar', 'code', 'arena'];
    await nextTick();
    expect(items()).not.toContain('Für Lehrpersonen');
    page.host.parts.value = null;
    page.work.openProject({ ...page.work.work.value.project, task: handedOut }, null);
    await nextTick();
    expect(items()).not.toContain('Für Lehrpersonen');
    expect(items()).toContain('Abgeben');
  });

  it('offers no series of runs in an exam', async () => {
    const { page } = mainList();
    expect(items()).toContain('Versuchsreihe');
    page.work.openProject({ ...page.work.work.value.project, task: { ...handedOut, exam: { minutes: 45 } } }, null);
    await nextTick();
    expect(items()).not.toContain('Versuchsreihe');
  });

  it('opens a list in its place, and gives the keyboard back to its entry', async () => {
    mainList();
    await tap('menu-list-save');
    expect(items()).toEqual([
      ...[
        'Speichern',
        'Projekt speichern',
        'Nur das Programm speichern',
        'Nur den Parcours speichern',
        'Bild und Druck',
      ],
    ]);
    expect(document.activeElement).toBe(byId('menu-save'));
    await pressKey('Escape');
    expect(document.activeElement).toBe(byId('menu-list-save'));
    await pressKey('ArrowRight');
    await pressKey('ArrowLeft');
    expect(document.activeElement).toBe(byId('menu-list-save'));
  });

  it('opens the help, its keys, and the tour where it was left, once it is gone itself', async () => {
    setWindow(1400);
    const page = createPage();
    const left: (() => void)[] = [];
    mountOn(page, MainList, { onLeave: (open: () => void) => left.push(open) });
    for (const entry of ['Hilfe', 'Rundgang', 'Tasten'])
      await tap([...document.querySelectorAll<HTMLElement>('[role="menuitem"]')].find((it) => textOf(it).startsWith(entry))!); // prettier-ignore
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual([null, false]);
    left[0]?.();
    left[1]?.();
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual(['', true]);
    left[2]?.();
    expect(page.guide.at.value).toBe('key-run');
    page.settings.change({ tourStep: 'arena' });
    await nextTick();
    expect(items()).toContain('Rundgang fortsetzen');
  });

  it('asks for dialogs, lists and pages in its place', async () => {
    const { asked, page } = mainList(390);
    for (const id of ['menu-share', 'menu-open', 'menu-real-device', 'menu-course', 'device', 'menu-speed'])
      await tap(id);
    await tap('menu-teachers');
    expect(asked).toEqual(['dialog', 'dialog', 'dialog', 'inside', 'inside', 'inside', 'leave']);
    expect(page.router.page.value).toEqual({ name: 'teachers', id: null });
  });

  it('hides and shows the board and the arena', async () => {
    const { page } = mainList();
    await tap('menu-list-panes');
    await tap('pane-board');
    expect(page.layout.isShown.value.board).toBe(false);
    await tap('pane-board');
    expect(page.layout.isShown.value.board).toBe(true);
    await tap('pane-arena');
    expect(page.layout.isShown.value.arena).toBe(false);
  });

  it('has a tick for what does not run on the device, and for the telling of the drive, whose tones come with it', async () => {
    const { page } = mainList();
    const tick = (id: string) => byId(id).getAttribute('aria-checked');
    expect([tick('device-check-switch'), tick('tell-switch'), isThere('tones-switch')]).toEqual([
      'true',
      'false',
      false,
    ]);
    await tap('device-check-switch');
    await tap('tell-switch');
    expect(page.settings.own.value).toMatchObject({ deviceCheck: false, tell: true });
    expect([tick('device-check-switch'), tick('tell-switch'), tick('tones-switch')]).toEqual(['false', 'true', 'true']);
  });

  it('ticks one language and one of light and dark', async () => {
    const { page } = mainList();
    await tap('menu-list-theme');
    expect(checked()).toEqual(['Wie das Gerät']);
    await pressItem('Dunkel');
    await tap('menu-back');
    await tap('menu-list-language');
    expect(radios().map((item) => [item.lang, textOf(item)])).toEqual([
      ...[['de', 'Deutsch'], ['fr', 'Français'], ['it', 'Italiano'], ['en', 'English']], // prettier-ignore
    ]);
    await pressItem('Français');
    expect(checked()).toEqual(['Français']);
    expect(page.settings.current.value).toMatchObject({ theme: 'dark', language: 'fr' });
  });

  it('is there in all four languages, without a German word left', async () => {
    const { page } = mainList(390);
    const german = new Set(items());
    for (const language of ['fr', 'it', 'en'] as const) {
      await loadTexts(language);
      showLanguage(language);
      await nextTick();
      expect(items()).toHaveLength(german.size);
      expect(items().filter((name) => german.has(name))).toEqual([]);
    }
    expect(page.settings.own.value.theme).toBe('system');
  });
});

describe('the button of the main menu', () => {
  beforeEach(() => void downloads());
  afterEach(() => history.replaceState(null, '', '/'));

  /** The open menu of a page of this width. */
  async function opened(width = 1400) {
    setWindow(width);
    const page = createPage();
    const asked: Promise<{ default: { __name?: string } }>[] = [];
    mountOn(page, MainMenu, { onDialog: (load: () => (typeof asked)[number]) => asked.push(load()) });
    const button = named('Menü', 'button');
    button.click();
    await vi.waitFor(() => named('Menü', '[role="menu"]'));
    await flushPromises();
    return { page, asked, button, isOpen: () => button.getAttribute('aria-expanded') === 'true' };
  }

  it('opens the menu and closes it with an entry', async () => {
    const { button, page, isOpen } = await opened();
    expect(isOpen()).toBe(true);
    await tap('menu-list-panes');
    expect(isOpen()).toBe(true);
    await tap('pane-arena');
    await flushPromises();
    expect(isOpen()).toBe(false);
    expect(page.settings.current.value.showArena).toBe(false);
    expect(button.isConnected).toBe(true);
  });

  it.each([
    ['Öffnen …', 'OpenDialog'],
    ['Auf den Roboter …', 'RealDeviceDialog'],
  ])('closes for the dialog behind “%s” and keeps the keyboard', async (name, dialog) => {
    const { asked, button, isOpen } = await opened();
    await pressItem(name);
    expect((await Promise.all(asked)).map((view) => view.default.__name)).toEqual([dialog]);
    expect(isOpen()).toBe(false);
    expect(document.activeElement).toBe(button);
  });

  it('gives its place to the help', async () => {
    const { page, button, isOpen } = await opened();
    await tap('menu-help');
    expect(isOpen()).toBe(false);
    expect(page.guide.at.value).toBe('');
    expect(document.activeElement).toBe(button);
  });

  it('gives its place to the gallery of robots', async () => {
    const { page, isOpen } = await opened();
    await pressItem('Roboter-Galerie');
    expect(isOpen()).toBe(false);
    expect(page.router.page.value).toEqual({ name: 'robots', id: null });
  });

  it('is a page on a phone, in which a list takes its place and stays while one chooses', async () => {
    const { page, isOpen } = await opened(390);
    await vi.waitFor(() => byId('menu-close'));
    await tap('device');
    await vi.waitFor(() => expect(isThere('menu-share')).toBe(false));
    expect([isOpen(), page.router.page.value]).toEqual([true, null]);
    await tap('menu-close');
    expect([isOpen(), isThere('menu-share')]).toEqual([true, true]);
    await tap('menu-list-language');
    await pressItem('English');
    expect([isOpen(), page.settings.current.value.language]).toEqual([false, 'en']);
  });

  it('begins anew the next time, with its own entries', async () => {
    const { button, isOpen } = await opened(390);
    await tap('menu-list-theme');
    await pressKey('Escape');
    await tap('menu-close');
    expect(isOpen()).toBe(false);
    button.click();
    await flushPromises();
    expect(isThere('menu-share')).toBe(true);
  });
});
