// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { loadTexts, showLanguage } from '../kit/i18n';
import LanguageList from './LanguageList.vue';
import LanguageMenu from './LanguageMenu.vue';
import MainList from './MainList.vue';
import MainMenu from './MainMenu.vue';
import SpeedList from '../pupil/arena/SpeedList.vue';
import SpeedMenu from '../pupil/arena/SpeedMenu.vue';
import { downloads } from './testing/downloads';
import { press } from './testing/editing';
import { mountOn, named, setWindow, textOf } from './testing/mount-on';
import { createPage } from './testing/page';
import { startRun } from './testing/run';

const radios = (): readonly HTMLElement[] => [...document.querySelectorAll<HTMLElement>('[role="menuitemradio"]')];
const checked = (): readonly string[] =>
  radios().filter((item) => item.getAttribute('aria-checked') === 'true').map(textOf); // prettier-ignore
const items = (): readonly string[] =>
  [...document.querySelectorAll('[role="menuitem"]')].map((item) =>
    textOf(item.querySelector('.page-list-item-title')),
  );

describe('the list of languages', () => {
  it('names each language in itself and says so to screen readers', () => {
    mountOn(createPage(), LanguageList);
    named('Sprache', '[role="menu"]');
    expect(radios().map((item) => [item.lang, textOf(item)])).toEqual([
      ['de', 'Deutsch'],
      ['fr', 'Français'],
      ['it', 'Italiano'],
      ['en', 'English'],
    ]);
  });

  it('ticks the language of the page, and takes another', async () => {
    const page = createPage();
    page.settings.change({ language: 'de' });
    mountOn(page, LanguageList);
    await nextTick();
    expect(checked()).toEqual(['Deutsch']);
    await press('Italiano', '[role="menuitemradio"]');
    expect(checked()).toEqual(['Italiano']);
    expect(page.settings.own.value.language).toBe('it');
  });

  it('opens from a button that shows the language with two letters', async () => {
    const page = createPage();
    page.settings.change({ language: 'fr' });
    mountOn(page, LanguageMenu);
    const button = named('Sprache: FR', 'button');
    expect(textOf(button)).toBe('FR');
    expect(button.getAttribute('aria-expanded')).toBe('false');
    button.click();
    await vi.waitFor(() => named('Français', '[role="menuitemradio"]'));
    expect(button.getAttribute('aria-expanded')).toBe('true');
    await press('English', '[role="menuitemradio"]');
    expect(textOf(button)).toBe('EN');
  });
});

describe('the list of speeds', () => {
  it('goes from a quarter to as fast as possible', () => {
    mountOn(createPage(), SpeedList);
    expect(radios().map(textOf)).toEqual(['¼×', '½×', '1×', '2×', '4×', '8×', 'max: so schnell wie möglich']);
    expect(checked()).toEqual(['1×']);
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

describe('the button of the speed', () => {
  /** A page whose run reaches so much. */
  async function reaching(achieved: number, wish: 0.5 | 1 | 4 | 'max', width = 1400) {
    setWindow(width);
    const page = createPage();
    page.settings.change({ speed: wish });
    const button = mountOn(page, SpeedMenu).get('button');
    await startRun(page);
    page.say({ type: 'alive', achieved, nowUs: 0 });
    await nextTick();
    return { page, button, text: () => textOf(button.element) };
  }

  it('says its meaning in words before a run, where there is room', () => {
    setWindow(1400);
    const button = mountOn(createPage(), SpeedMenu).get('button');
    expect(textOf(button.element)).toBe('1×Tempo');
    expect(button.attributes('title')).toBe('Tempo 1×');
  });

  it('says what is reached', async () => {
    const { text, button } = await reaching(3.96, 4);
    expect(text()).toContain('erreicht 4.0×');
    expect(button.attributes('title')).toBe('Tempo 4×');
    expect(button.classes()).not.toContain('speed--slow');
  });

  it('warns when the device does not manage it, and comforts: the result is the same', async () => {
    const { text, button } = await reaching(0.62, 1);
    expect(button.classes()).toContain('speed--slow');
    expect(button.attributes('title')).toBe('Dieses Gerät schafft nur 0.62×. Das Ergebnis bleibt gleich.');
    expect(text()).toContain('erreicht 0.62×');
  });

  it('does not warn of a tenth', async () => {
    expect((await reaching(0.92, 1)).button.classes()).not.toContain('speed--slow');
    expect((await reaching(0.45, 0.5)).button.classes()).not.toContain('speed--slow');
    expect((await reaching(0.44, 0.5)).button.classes()).toContain('speed--slow');
  });

  it('says with “max” how fast that is, and never that it is too slow', async () => {
    const { button } = await reaching(0.3, 'max');
    expect(button.classes()).not.toContain('speed--slow');
    expect(button.attributes('title')).toBe('Tempo max, erreicht 0.30×');
  });

  it('shows on a phone what is reached only where that is not as wished', async () => {
    expect((await reaching(1, 1, 390)).text()).toBe('1×');
    expect((await reaching(0.5, 1, 390)).text()).toBe('1×0.50×');
  });

  it('says that the device is computing while the worker is silent', async () => {
    const { page, text } = await reaching(1, 1);
    page.run.isBusy.value = true;
    await nextTick();
    expect(text()).toBe('1×rechnet …');
  });

  it('forgets what was reached when the run stands still', async () => {
    const { page, text } = await reaching(0.5, 1);
    page.run.pause();
    await nextTick();
    expect(text()).toBe('1×Tempo');
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

describe('the main menu', () => {
  it('has on a large page what has no button there', () => {
    mainList();
    expect(items()).toEqual([
      'Hilfe',
      'Rundgang',
      'Teilen',
      'Aufs Gerät laden …',
      'Projekt speichern',
      'Nur das Programm speichern',
      'Nur den Parcours speichern',
      'Datei öffnen …',
      'Link öffnen …',
      'Mikrocomputer ausblenden',
      'Arena ausblenden',
      'Meine Arbeiten',
      'Roboter-Galerie',
      'Aufgabe stellen',
      'Aufgabenserie machen',
      'Lösungen prüfen',
      'Beamer-Ansicht',
    ]);
  });

  it('has on a phone all that the small bar leaves out', () => {
    mainList(390);
    for (const name of ['Pause', 'Einen Schritt von 20 ms', 'Ton ausschalten', 'Parcours wählen', 'Gerät wählen'])
      expect(items()).toContain(name);
    expect(items()).not.toContain('Arena ausblenden'); // there each pane has a tab
  });

  it('has on a tablet held upright the step and the device, which the bar has no room for', () => {
    mainList(700);
    expect(items()).toContain('Einen Schritt von 20 ms');
    expect(items()).toContain('Gerät wählen');
    expect(items()).not.toContain('Pause');
  });

  it('opens the help, and the tour where it was left', async () => {
    const { page, asked } = mainList();
    await pressItem('Hilfe');
    expect(page.guide.at.value).toBe('');
    await pressItem('Rundgang');
    expect(page.tour.isOpen.value).toBe(true);
    expect(asked).toEqual(['leave', 'leave']);
    page.settings.change({ tourStep: 'arena' });
    await nextTick();
    expect(items()).toContain('Rundgang fortsetzen');
  });

  it('opens help and tour only once it is gone itself', async () => {
    setWindow(1400);
    const page = createPage();
    const left: (() => void)[] = [];
    mountOn(page, MainList, { onLeave: (open: () => void) => left.push(open) });
    await pressItem('Hilfe');
    await pressItem('Rundgang');
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual([null, false]);
    for (const open of left) open();
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual(['', true]);
  });

  it('asks for dialogs, lists and the gallery in its place', async () => {
    const { asked, page } = mainList(390);
    for (const name of ['Teilen', 'Aufs Gerät laden …', 'Link öffnen …', 'Parcours wählen', 'Gerät wählen'])
      await pressItem(name);
    await pressItem('Roboter-Galerie');
    expect(asked).toEqual([...['dialog', 'dialog', 'dialog', 'inside', 'inside', 'leave']]);
    expect(page.router.page.value).toEqual({ name: 'robots', id: null });
  });

  it('pauses and goes on; before a run there is nothing to pause', async () => {
    const { page } = mainList(390);
    expect(named('Pause', '[role="menuitem"]').getAttribute('aria-disabled')).toBe('true');
    await startRun(page);
    expect(named('Pause', '[role="menuitem"]').getAttribute('aria-disabled')).toBe('false');
    await pressItem('Pause');
    expect(page.run.phase.value).toBe('paused');
    await pressItem('Weiter');
    expect(page.run.phase.value).toBe('running');
  });

  it('makes one step of a run that stands still, none of one that goes', async () => {
    const { page } = mainList(390);
    await startRun(page);
    expect(named('Einen Schritt von 20 ms', '[role="menuitem"]').getAttribute('aria-disabled')).toBe('true');
    page.run.pause();
    await nextTick();
    await pressItem('Einen Schritt von 20 ms');
    expect(page.sent.at(-1)).toEqual({ type: 'step' });
  });

  it('turns the sound off and on, and says what that means', async () => {
    const { page } = mainList(390);
    await pressItem('Ton ausschalten');
    expect(page.settings.current.value.muted).toBe(true);
    expect(page.notices.current.value?.key).toBe('notice.muted');
    await pressItem('Ton einschalten');
    expect(page.settings.current.value.muted).toBe(false);
    expect(page.notices.current.value?.key).toBe('notice.unmuted');
  });

  it('hides and shows the board and the arena', async () => {
    const { page } = mainList();
    await pressItem('Mikrocomputer ausblenden');
    expect(page.layout.isShown.value.board).toBe(false);
    await pressItem('Mikrocomputer zeigen');
    expect(page.layout.isShown.value.board).toBe(true);
    await pressItem('Arena ausblenden');
    expect(page.layout.isShown.value.arena).toBe(false);
    expect(items()).toContain('Arena zeigen');
  });

  it('has a tick for what does not run on the device', async () => {
    const { page } = mainList();
    const tick = () => named('Zeigen, was auf dem Gerät nicht läuft', '[role="menuitemcheckbox"]');
    expect(tick().getAttribute('aria-checked')).toBe('true');
    await pressItem('Zeigen, was auf dem Gerät nicht läuft');
    expect(tick().getAttribute('aria-checked')).toBe('false');
    expect(page.settings.own.value.deviceCheck).toBe(false);
  });

  it('has a tick for the telling of the drive', async () => {
    const { page } = mainList();
    const tick = () => named('Fahrt ansagen', '[role="menuitemcheckbox"]');
    expect(tick().getAttribute('aria-checked')).toBe('false');
    await pressItem('Fahrt ansagen');
    expect(tick().getAttribute('aria-checked')).toBe('true');
    expect(page.settings.own.value.tell).toBe(true);
  });

  it('ticks one stage, one language and one of light and dark', async () => {
    const { page } = mainList();
    page.settings.change({ language: 'de' });
    await nextTick();
    expect(checked()).toEqual(['Parcours bauen', 'Deutsch', 'Wie das Gerät']);
    await pressItem('Dunkel');
    await pressItem('Français');
    expect(page.settings.current.value).toMatchObject({ theme: 'dark', language: 'fr' });
    expect(checked()).toEqual(['Parcours bauen', 'Français', 'Dunkel']);
  });

  it('leaves the stages out where a host says what is shown', async () => {
    const { page } = mainList();
    page.host.parts.value = ['bar', 'code', 'arena'];
    await nextTick();
    expect(document.querySelector('[data-testid^="stage-"]')).toBeNull();
  });

  it('is there in all four languages, without a German word left', async () => {
    const { page } = mainList(390);
    expect(items().length).toBeGreaterThan(12);
    const german = new Set(items());
    for (const language of ['fr', 'it', 'en'] as const) {
      await loadTexts(language);
      showLanguage(language);
      await nextTick();
      expect(items()).toHaveLength(german.size);
      expect(items().filter((name) => german.has(name) && name !== 'Pause')).toEqual([]);
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
    await pressItem('Arena ausblenden');
    await flushPromises();
    expect(isOpen()).toBe(false);
    expect(page.settings.current.value.showArena).toBe(false);
    expect(button.isConnected).toBe(true);
  });

  it.each([
    ['Teilen', 'ShareDialog'],
    ['Link öffnen …', 'OpenLinkDialog'],
    ['Aufs Gerät laden …', 'RealDeviceDialog'],
  ])('closes for the dialog behind “%s” and keeps the keyboard', async (name, dialog) => {
    const { asked, button, isOpen } = await opened();
    await pressItem(name);
    expect((await Promise.all(asked)).map((view) => view.default.__name)).toEqual([dialog]);
    expect(isOpen()).toBe(false);
    expect(document.activeElement).toBe(button);
  });

  it('gives its place to the help', async () => {
    const { page, button, isOpen } = await opened();
    await pressItem('Hilfe');
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

  it('shows the list of devices in its place on a phone, which stays while one chooses', async () => {
    const { page, isOpen } = await opened(390);
    await pressItem('Gerät wählen');
    await vi.waitFor(() => named('Roboter-Galerie', '.device-list *, [role^="menuitem"], button'), 20_000);
    expect(document.querySelector('[data-testid="menu-share"]')).toBeNull();
    expect(isOpen()).toBe(true);
    expect(page.router.page.value).toBeNull();
  });

  it('begins anew the next time, with its own entries', async () => {
    const { button, isOpen } = await opened(390);
    await pressItem('Gerät wählen');
    await vi.waitFor(() => expect(document.querySelector('[data-testid="menu-share"]')).toBeNull());
    button.click();
    await flushPromises();
    expect(isOpen()).toBe(false);
    button.click();
    await flushPromises();
    expect(document.querySelector('[data-testid="menu-share"]')).not.toBeNull();
  });
});
