// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { noHost } from '../session/visit/host-view';
import PhoneNav from './PhoneNav.vue';
import PlayOverlay from './PlayOverlay.vue';
import RunStrip from './RunStrip.vue';
import TopBar from './TopBar.vue';
import { press } from './testing/editing';
import { mountOn, named, setWindow, textOf } from './testing/mount-on';
import { createPage } from './testing/page';
import { show, startRun } from './testing/run';

const names = (selector = 'header button'): readonly string[] =>
  [...document.querySelectorAll(selector)].map((it) => it.getAttribute('aria-label') ?? textOf(it));

/** The bar of a page of this width. */
function topBar(width: number) {
  setWindow(width);
  const page = createPage();
  page.settings.change({ language: 'de' });
  return { page, bar: mountOn(page, TopBar) };
}

describe('the bar at the top', () => {
  afterEach(() => history.replaceState(null, '', '/'));

  it('is a landmark with the page’s heading, which a phone has for screen readers only', () => {
    const { bar } = topBar(1400);
    expect(bar.element.tagName).toBe('HEADER');
    expect(bar.attributes('aria-label')).toBe('Steuerung');
    expect(textOf(bar.get('h1').element)).toBe('Parcours');
    expect(textOf(topBar(390).bar.get('h1.vh').element)).toBe('Parcours');
  });

  it('has all buttons on a large page', () => {
    topBar(1400);
    expect(names()).toEqual(
      expect.arrayContaining([
        ...['Simulieren', 'Stopp', 'Pause', 'Einen Schritt von 20 ms', 'Zurück auf Start', 'Ton ausschalten'],
        ...['Teilen', 'Projekt speichern', 'Datei öffnen', 'Sprache: DE', 'Hell oder dunkel', 'Hilfe (F1)', 'Menü'],
      ]),
    );
  });

  it('keeps on a phone what a run needs, and the menu', () => {
    topBar(390);
    expect(names()).toEqual(['Simulieren', 'Zurück auf Start', '1×', 'Menü']);
  });

  it('names the course beside the title where no button has room for it', async () => {
    const { bar, page } = topBar(700);
    expect(textOf(bar.get('h1 small').element)).toBe('Eine Sekunde vorwärts');
    page.settings.change({ showArena: false, robot: 'none' });
    await nextTick();
    expect(bar.find('h1 small').exists()).toBe(false);
  });

  it('runs, stops and puts everything back', async () => {
    const { page } = topBar(1400);
    await press('Simulieren', 'button');
    expect(page.run.phase.value).toBe('starting');
    await flushPromises();
    page.say({ type: 'started' });
    await nextTick();
    expect(names()).toContain('Simulieren (neu starten)');
    await press('Stopp', 'button');
    await flushPromises();
    expect(page.run.phase.value).toBe('stopped');
    await press('Zurück auf Start', 'button');
    await flushPromises();
    expect(page.run.phase.value).toBe('ready');
  });

  it('offers another run once the program has ended; the world goes on and can still be stopped', async () => {
    const { page, bar } = topBar(1400);
    await startRun(page);
    expect(bar.get('.run').classes()).toContain('ctl--again');
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    await nextTick();
    expect(names()).toContain('Nochmals');
    expect(bar.get('.run').classes()).toContain('ctl--run');
    expect(bar.get('.stop').classes()).not.toContain('ctl--stop');
    await press('Stopp', 'button');
    await flushPromises();
    expect(page.run.phase.value).toBe('stopped');
    expect(names()).toContain('Simulieren');
  });

  it('names the keys that run and stop', () => {
    topBar(1400);
    expect(named('Simulieren', 'button').title).toBe('Simulieren (Ctrl+Enter)');
    expect(named('Stopp', 'button').title).toBe('Stopp (Ctrl+Shift+Enter)');
  });

  it('turns the sound off and on; the button is named by what it does', async () => {
    const { page } = topBar(1400);
    await press('Ton ausschalten', 'button');
    expect(page.settings.own.value.muted).toBe(true);
    await press('Ton einschalten', 'button');
    expect(page.settings.own.value.muted).toBe(false);
  });

  it('shows a tone at the button, for users who do not hear it; not while the sound is off or the run pauses', async () => {
    const { page, bar } = topBar(1400);
    const sounds = () => bar.find('.sounding').exists();
    await startRun(page);
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

  it('changes between light and dark from what is shown now', async () => {
    const { page } = topBar(1400);
    document.documentElement.dataset['theme'] = 'dark';
    await press('Hell oder dunkel', 'button');
    expect(page.settings.own.value.theme).toBe('light');
    document.documentElement.dataset['theme'] = 'light';
    await press('Hell oder dunkel', 'button');
    expect(page.settings.own.value.theme).toBe('dark');
  });

  it('opens the help, and tells its key', async () => {
    const { page } = topBar(1100);
    expect(named('Hilfe (F1)', 'button').getAttribute('aria-keyshortcuts')).toBe('F1');
    await press('Hilfe (F1)', 'button');
    expect(page.guide.at.value).toBe('');
  });

  it('opens the dialog for sharing and gives the keyboard back when it closes', async () => {
    topBar(1400);
    const share = named('Teilen', 'button');
    share.focus();
    await press('Teilen', 'button');
    await vi.waitFor(() => named('Projekt teilen', '[role="dialog"]'), 20_000);
    await press('Schliessen', '[data-testid="share-dialog"] button');
    await flushPromises();
    expect(document.querySelector('[data-testid="share-dialog"]')).toBeNull();
    expect(document.activeElement).toBe(share);
  });

  it('asks for files with a picker that takes programs, projects and courses, several at once', async () => {
    const { page } = topBar(1400);
    const pickers: HTMLInputElement[] = [];
    const click = vi.spyOn(HTMLInputElement.prototype, 'click').mockImplementation(function (this: HTMLInputElement) {
      pickers.push(this);
    });
    await press('Datei öffnen', 'button');
    click.mockRestore();
    const [picker] = pickers;
    expect([picker?.type, picker?.multiple]).toEqual(['file', true]);
    expect(picker?.accept.split(',')).toEqual(expect.arrayContaining(['.py', '.json']));
    Object.defineProperty(picker, 'files', { value: [new File(['x = 1\n'], 'mine.py')] });
    picker?.dispatchEvent(new Event('change'));
    await vi.waitFor(() => expect(page.work.open.value).toMatchObject({ name: 'mine.py', text: 'x = 1\n' }), 20_000);
  });
});

describe('the tabs of a phone', () => {
  beforeEach(() => setWindow(390));
  const tabs = () => names('nav button');
  const current = () => names('nav button[aria-current="page"]');

  it('are program, microcomputer, arena and console; one is in sight', async () => {
    const page = createPage();
    mountOn(page, PhoneNav);
    named('Bereiche', 'nav');
    expect(tabs()).toEqual(['Code', 'micro:bit', 'Arena', 'Konsole']);
    expect(current()).toEqual(['Code']);
    await press('Arena', 'nav button');
    expect(current()).toEqual(['Arena']);
    expect(page.layout.isShown.value).toEqual({ code: false, board: false, arena: true, console: false });
  });

  it('call the microcomputer by its name', async () => {
    const page = createPage();
    mountOn(page, PhoneNav);
    page.settings.change({ device: 'calliope-mini-3' });
    await nextTick();
    expect(tabs()[1]).toBe('Calliope');
  });

  it('leave the arena out for a bare board, and lead from there to the board', async () => {
    const page = createPage();
    mountOn(page, PhoneNav);
    page.layout.tab.value = 'arena';
    page.settings.change({ robot: 'none', showArena: false });
    await nextTick();
    expect(tabs()).not.toContain('Arena');
    expect(current()).toEqual(['micro:bit']);
  });

  it('are only those that a host shows', () => {
    const page = createPage();
    page.host.parts.value = ['board', 'console'];
    mountOn(page, PhoneNav);
    expect(tabs()).toEqual(['micro:bit', 'Konsole']);
  });

  it('have a dot at the console for what came unseen, also in words; it goes when one looks', async () => {
    const page = createPage();
    mountOn(page, PhoneNav);
    page.console.isNew.value = true;
    await nextTick();
    expect(tabs()[3]).toBe('Konsole neue Ausgabe');
    await press('Konsole neue Ausgabe', 'nav button');
    expect(tabs()[3]).toBe('Konsole');
    await press('Code', 'nav button');
    expect(tabs()[3]).toBe('Konsole');
  });

  it('have no dot for what is printed while one looks', async () => {
    const page = createPage();
    page.layout.tab.value = 'console';
    mountOn(page, PhoneNav);
    page.console.isNew.value = true;
    await nextTick();
    page.layout.tab.value = 'code';
    await nextTick();
    expect(tabs()[3]).toBe('Konsole');
  });
});

describe('the strip where a host shows no bar', () => {
  it('still runs and ends every program', async () => {
    setWindow(1400);
    const page = createPage();
    mountOn(page, RunStrip);
    named('Steuerung', 'header');
    expect(names()).toEqual(['Simulieren', 'Stopp', 'Pause', 'Einen Schritt von 20 ms', 'Zurück auf Start']);
    expect((named('Stopp', 'button') as HTMLButtonElement).disabled).toBe(true);
    await press('Simulieren', 'button');
    await nextTick();
    expect((named('Stopp', 'button') as HTMLButtonElement).disabled).toBe(false);
    await press('Stopp', 'button');
    await flushPromises();
    expect(page.run.isActive.value).toBe(false);
  });
});

describe('the play button of a host that brings its program', () => {
  afterEach(() => void vi.unstubAllGlobals());
  const button = () => document.querySelector<HTMLButtonElement>('.play-button');

  it('starts the program of the page where there is no host, and is away while it runs', async () => {
    const page = createPage({ dialect: 'microbit' });
    mountOn(page, PlayOverlay);
    expect(button()?.getAttribute('aria-label')).toBe('Simulator starten');
    button()?.click();
    await nextTick();
    expect(page.run.phase.value).toBe('starting');
    expect(button()).toBeNull();
    await page.run.stop();
    await nextTick();
    expect(button()).not.toBeNull();
  });

  it('asks the host that is there', async () => {
    const page = createPage({ dialect: 'microbit' });
    const asked = vi.fn();
    page.run.ask.value = asked;
    mountOn(page, PlayOverlay);
    button()?.click();
    await nextTick();
    expect(asked).toHaveBeenCalledOnce();
    expect(page.run.phase.value).toBe('ready');
  });

  it('remembers a press until the host can be asked, and asks it once', async () => {
    vi.stubGlobal('parent', {});
    const page = createPage({ dialect: 'microbit' });
    mountOn(page, PlayOverlay);
    button()?.click();
    button()?.click();
    await nextTick();
    expect(page.run.phase.value).toBe('ready');
    const asked = vi.fn();
    page.run.ask.value = asked;
    await nextTick();
    expect(asked).toHaveBeenCalledOnce();
    page.run.ask.value = null;
    page.run.ask.value = vi.fn();
    await nextTick();
    expect(asked).toHaveBeenCalledOnce();
  });

  it('has the host’s word and colour', () => {
    const page = createPage({ dialect: 'microbit', color: 'rebeccapurple' });
    page.host.labels.value = { 'start-simulator': 'Los geht’s' };
    mountOn(page, PlayOverlay);
    expect(button()?.title).toBe('Los geht’s');
    expect(button()?.style.backgroundColor).toBe('rebeccapurple');
    expect(noHost.color).toBeNull();
  });

  it('lies over the board, or over the arena where no board is shown', async () => {
    const page = createPage({ dialect: 'microbit' });
    const overlay = mountOn(page, PlayOverlay);
    const area = () => (overlay.find('.play-button-container').element as HTMLElement).style.gridArea;
    expect(area()).toMatch(/^board/);
    page.host.parts.value = ['arena'];
    await nextTick();
    expect(area()).toMatch(/^arena/);
  });
});
