// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { flushPromises } from '@vue/test-utils';
import { nextTick } from 'vue';

import { mountOn, named, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import ConsolePane from './ConsolePane.vue';

const button = (name: string) => named(name) as HTMLButtonElement;
const tags = (pane: ReturnType<typeof mountOn>) => pane.findAll('.tag').map((it) => it.element.firstChild?.textContent);

/** A console with a line of output. */
async function withOutput() {
  const page = createPage();
  page.settings.change({ showArena: false });
  const pane = mountOn(page, ConsolePane);
  page.console.write('Hallo\n');
  page.console.toText();
  await vi.dynamicImportSettled();
  await nextTick();
  return { page, pane };
}

describe('the pane of the console', () => {
  afterEach(() => void vi.unstubAllGlobals());

  it('is a region of its own with a heading', () => {
    const pane = mountOn(createPage(), ConsolePane);
    expect(pane.element.tagName).toBe('SECTION');
    expect(pane.attributes('aria-label')).toBe('Konsole');
    expect(pane.get('h2').text()).toBe('Konsole');
  });

  it('has nothing to choose while it is folded before the first run', () => {
    const pane = mountOn(createPage(), ConsolePane);
    expect(pane.findAll('button').map((it) => it.attributes('data-testid'))).toEqual(['console-fold']);
  });

  it('has nothing to copy or to clear before there is output', async () => {
    const page = createPage();
    mountOn(page, ConsolePane);
    button('Konsole aufklappen').click();
    await nextTick();
    expect(button('Ausgabe kopieren').disabled).toBe(true);
    expect(button('Konsole leeren').disabled).toBe(true);
    page.console.addNote('console.stopped');
    await nextTick();
    expect(button('Ausgabe kopieren').disabled).toBe(false);
    expect(button('Konsole leeren').disabled).toBe(false);
  });

  it('clears', async () => {
    const { page, pane } = await withOutput();
    expect(pane.text()).toContain('Hallo');
    button('Konsole leeren').click();
    await nextTick();
    expect(page.console.toText()).toBe('');
    expect(pane.text()).toContain('Noch keine Ausgabe');
  });

  it('copies what the program wrote, and says so', async () => {
    const written: string[] = [];
    vi.stubGlobal('navigator', {
      languages: ['de'],
      clipboard: { writeText: (text: string) => Promise.resolve(void written.push(text)) },
    });
    const { page } = await withOutput();
    button('Ausgabe kopieren').click();
    await flushPromises();
    expect(written).toEqual(['Hallo\n']);
    expect(page.notices.current.value).toMatchObject({ kind: 'ok', key: 'console.copied' });
  });

  it('says when the browser does not allow copying', async () => {
    vi.stubGlobal('navigator', {
      languages: ['de'],
      clipboard: { writeText: () => Promise.reject(new Error('denied')) },
    });
    const { page } = await withOutput();
    button('Ausgabe kopieren').click();
    await flushPromises();
    expect(page.notices.current.value).toMatchObject({ kind: 'warn', key: 'console.copyFailed' });
  });

  it('says likewise where there is no clipboard at all', async () => {
    vi.stubGlobal('navigator', { languages: ['de'] });
    const { page } = await withOutput();
    button('Ausgabe kopieren').click();
    await flushPromises();
    expect(page.notices.current.value).toMatchObject({ kind: 'warn', key: 'console.copyFailed' });
  });

  it('tells where the run stands, and the simulated time once it passes', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    expect(tags(pane)).toEqual(['bereit']);
    expect(pane.find('.clock').exists()).toBe(false);
    await startRun(page);
    await show(page, { timeUs: 61_500_000 });
    expect(tags(pane)).toEqual(['läuft']);
    await vi.dynamicImportSettled();
    expect(pane.get('.clock').text()).toContain('simuliert');
    await show(page, { timeUs: 61_500_000, awaitsInput: true });
    expect(tags(pane)).toEqual(['wartet auf dich']);
    await page.run.stop();
    await nextTick();
    expect(tags(pane)).toEqual(['gestoppt']);
  });

  it('has a line to type into only while somebody listens', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    expect(pane.find('form').exists()).toBe(false);
    await startRun(page);
    await vi.dynamicImportSettled();
    expect(pane.find('form').exists()).toBe(true);
    page.say({ type: 'program-ended', ended: { kind: 'panic', exception: null, timeUs: 1 }, device: 0 });
    await nextTick();
    expect(pane.find('form').exists()).toBe(false);
  });

  it('leaves an error’s card alone until somebody turns to lines of Python', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    await startRun(page);
    const exception = { type: 'NameError', message: 'x', line: null, traceback: '' };
    page.say({ type: 'program-ended', ended: { kind: 'exception', exception, timeUs: 1 }, device: 0 });
    await show(page, { repl: true });
    expect(pane.find('form').exists()).toBe(false);
    page.console.visitRepl();
    await vi.dynamicImportSettled();
    await nextTick();
    expect(document.activeElement).toBe(pane.get('form input').element);
  });

  it('marks the REPL and says what it is', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    await startRun(page);
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    await show(page, { repl: true });
    await vi.dynamicImportSettled();
    expect(tags(pane)).toHaveLength(1); // nobody has gone there yet
    await pane.get('input').trigger('focus');
    const tag = pane.findAll('.tag').at(1);
    expect(tag?.text()).toBe('REPL: Das Programm ist zu Ende, Python wartet auf eine Zeile.');
  });

  it('writes the bare time beside the long word that the program is over', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    await startRun(page);
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    await show(page, { timeUs: 2_000_000, repl: true });
    expect(tags(pane)).toEqual(['Programm zu Ende']);
    await vi.dynamicImportSettled();
    expect(pane.get('.clock').text()).not.toContain('simuliert');
  });

  it('says that the program is over also while its world is paused, as building does it', async () => {
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    await startRun(page);
    page.run.pause();
    await nextTick();
    expect(tags(pane)).toEqual(['Pause']);
    page.run.resume();
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1 }, device: 0 });
    page.run.pause();
    await nextTick();
    expect(tags(pane)).toEqual(['Programm zu Ende']);
  });

  it('writes the bare time on a phone', async () => {
    setWindow(390, 800);
    const page = createPage();
    const pane = mountOn(page, ConsolePane);
    await startRun(page);
    await show(page, { timeUs: 2_000_000 });
    await vi.dynamicImportSettled();
    expect(pane.get('.clock').text()).not.toContain('simuliert');
    expect(pane.get('.clock').attributes('title')).toContain('simuliert');
  });
});
