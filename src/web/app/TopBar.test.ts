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
import { startRun } from './testing/run';

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

  it('is a landmark with the page’s heading, which is for screen readers only', () => {
    const { bar } = topBar(1400);
    expect(bar.element.tagName).toBe('HEADER');
    expect(bar.attributes('aria-label')).toBe('Steuerung');
    expect(textOf(bar.get('h1.vh').element)).toBe('Parcours');
  });

  it.each([1400, 1100, 700])('has seven buttons before a run, %i px wide', (width) => {
    topBar(width);
    expect(names()).toEqual([
      ...['Parcours: Womit möchtest du beginnen?', 'Simulieren', 'Tempo und Ton: 1×'],
      ...['Aufgabe: Eine Sekunde vorwärts', 'Gerät: Maqueen Lite, micro:bit V2', 'Teilen', 'Menü'],
    ]);
  });

  it('keeps on a phone what a run needs, and the menu', async () => {
    const { page } = topBar(390);
    expect(names().slice(1)).toEqual(['Simulieren', 'Menü']);
    await startRun(page);
    expect(names().slice(1)).toEqual(['Stopp', 'Pause', 'Menü']);
    await page.run.stop();
    await nextTick();
    expect(names().slice(1)).toEqual(['Simulieren', 'Zurück auf Start', 'Menü']);
  });

  it('offers for a run what can be done with it, and nothing else', async () => {
    const { page } = topBar(1400);
    const ofRun = () => names().slice(1, names().indexOf('Tempo und Ton: 1×'));
    await press('Simulieren', 'button');
    await flushPromises();
    page.say({ type: 'started' });
    await nextTick();
    expect(ofRun()).toEqual(['Simulieren', 'Stopp', 'Pause', 'Zurück auf Start']);
    await press('Pause', 'button');
    expect(ofRun()).toEqual(['Simulieren', 'Stopp', 'Weiter', 'Einen Schritt von 20 ms', 'Zurück auf Start']);
    await press('Einen Schritt von 20 ms', 'button');
    expect(page.sent.at(-1)).toEqual({ type: 'step' });
    await press('Weiter', 'button');
    await press('Stopp', 'button');
    await flushPromises();
    expect(ofRun()).toEqual(['Simulieren', 'Einen Schritt von 20 ms', 'Zurück auf Start']);
    await press('Zurück auf Start', 'button');
    await flushPromises();
    expect([page.run.phase.value, ofRun()]).toEqual(['ready', ['Simulieren']]);
  });

  it('gives the keyboard to the run button when the button that had it goes', async () => {
    const { page } = topBar(1400);
    await startRun(page);
    named('Stopp', 'button').focus();
    await press('Stopp', 'button');
    await flushPromises();
    expect(document.activeElement).toBe(named('Simulieren', 'button'));
  });

  it('is ready for another run once the program has ended; the world goes on and can still be stopped', async () => {
    const { page, bar } = topBar(1400);
    await startRun(page);
    expect(bar.get('.run').classes()).toContain('ctl--again');
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    await nextTick();
    expect(textOf(bar.get('.run').element)).toBe('Simulieren');
    expect(bar.get('.run').classes()).toContain('ctl--run');
    expect(bar.get('.stop').classes()).not.toContain('ctl--stop');
    await press('Stopp', 'button');
    await flushPromises();
    expect(page.run.phase.value).toBe('stopped');
  });

  it('names the keys that run and stop', async () => {
    const { page } = topBar(1400);
    expect(named('Simulieren', 'button').title).toBe('Simulieren (Ctrl+Enter)');
    await startRun(page);
    expect(named('Stopp', 'button').title).toBe('Stopp (Ctrl+Shift+Enter)');
  });

  it('brings the greeting back by the logo, but leads nobody away from a task that was handed out', async () => {
    const { page } = topBar(1400);
    page.settings.change({ showArena: false, showCard: false, showTools: true });
    await press('Parcours: Womit möchtest du beginnen?', 'button');
    expect(page.greeting.isAsked.value).toBe(true);
    expect(page.settings.current.value).toMatchObject({ showArena: true, showCard: true, showTools: false });
    page.work.openProject({ ...page.work.work.value.project, task: { version: 1, id: 'A', handedOut: true } }, null);
    await nextTick();
    expect(names().filter((name) => name.startsWith('Parcours'))).toEqual([]);
    named('Abgeben', 'button');
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
    expect(names()).toEqual(['Simulieren']);
    await press('Simulieren', 'button');
    await nextTick();
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
