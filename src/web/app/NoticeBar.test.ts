// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick, shallowRef } from 'vue';

import { loadTexts, showLanguage } from '../kit/i18n';
import { fileNameQuestion } from '../pupil/code/file-name-question';
import AppDialog from './AppDialog.vue';
import NoticeBar from './NoticeBar.vue';
import { fill, press } from './testing/editing';
import { mountOn, named, setWindow, textOf } from './testing/mount-on';
import { createPage, type TestPage } from './testing/page';

const SECOND = 1000;

/** A page with the place for messages. */
function withNotices(width = 1024) {
  setWindow(width);
  const page = createPage();
  const bar = mountOn(page, NoticeBar);
  const isShown = () => bar.find('.notice').exists();
  const after = async (seconds: number) => {
    await vi.advanceTimersByTimeAsync(seconds * SECOND);
  };
  return { page, bar, isShown, after };
}

describe('a message at the foot of the page', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('is announced to screen readers: its place is there before it', async () => {
    const { page, bar, isShown } = withNotices();
    expect(bar.attributes('aria-live')).toBe('polite');
    expect(isShown()).toBe(false);
    page.notices.show({ kind: 'ok', key: 'files.loaded', values: { file: 'drive.py' } });
    await nextTick();
    expect(textOf(bar.get('.notice p').element)).toBe('drive.py ist geladen.');
  });

  it('follows the language, also while it is shown', async () => {
    await loadTexts('fr');
    const { page, bar } = withNotices();
    page.notices.show({ kind: 'info', key: 'console.copied' });
    await nextTick();
    expect(textOf(bar.get('.notice p').element)).toBe('Kopiert.');
    showLanguage('fr');
    await nextTick();
    expect(textOf(bar.get('.notice p').element)).toBe('Copié.');
  });

  it('looks different for success, news, warning and error', async () => {
    const { page, bar } = withNotices();
    const pictures = new Set<string>();
    for (const kind of ['ok', 'info', 'warn', 'error'] as const) {
      page.notices.show({ kind, key: 'console.copied' });
      await nextTick();
      expect(bar.get('.notice').classes()).toContain(`notice--${kind}`);
      pictures.add(bar.get('.notice svg').html());
    }
    expect(pictures.size).toBe(4);
  });

  it('goes by itself after five seconds', async () => {
    const { page, isShown, after } = withNotices();
    page.notices.show({ kind: 'ok', key: 'console.copied' });
    await after(4.9);
    expect(isShown()).toBe(true);
    await after(0.2);
    expect(isShown()).toBe(false);
  });

  it('stays twelve seconds where there is something to press', async () => {
    const { page, isShown, after } = withNotices();
    page.notices.show({ kind: 'ok', key: 'notice.cleared', action: { key: 'notice.undo', run: () => undefined } });
    await after(11.9);
    expect(isShown()).toBe(true);
    await after(0.2);
    expect(isShown()).toBe(false);
  });

  it('has its whole time although it takes the place of an older one', async () => {
    const { page, isShown, after } = withNotices();
    page.notices.show({ kind: 'ok', key: 'console.copied' });
    await after(4);
    page.notices.show({ kind: 'info', key: 'notice.muted' });
    await after(4);
    expect(isShown()).toBe(true);
    await after(1.1);
    expect(isShown()).toBe(false);
  });

  it('stays when it tells of an error, except on a phone, which has no room to spare', async () => {
    const large = withNotices();
    large.page.notices.show({ kind: 'error', key: 'notice.firmware' });
    await large.after(600);
    expect(large.isShown()).toBe(true);
    const phone = withNotices(390);
    phone.page.notices.show({ kind: 'error', key: 'notice.firmware' });
    await phone.after(19.9);
    expect(phone.isShown()).toBe(true);
    await phone.after(0.2);
    expect(phone.isShown()).toBe(false);
  });

  it('is closed by its button', async () => {
    const { page, isShown } = withNotices();
    page.notices.show({ kind: 'error', key: 'notice.firmware' });
    await nextTick();
    await press('Schliessen');
    expect(isShown()).toBe(false);
    expect(page.notices.current.value).toBeNull();
  });

  it('goes before it does what it offers, so that the next message is not lost', async () => {
    const { page, bar } = withNotices();
    const undo = vi.fn(() => page.notices.show({ kind: 'ok', key: 'course.restored' }));
    page.notices.show({ kind: 'ok', key: 'notice.cleared', action: { key: 'notice.undo', run: undo } });
    await nextTick();
    await press('Rückgängig');
    expect(undo).toHaveBeenCalledOnce();
    expect(textOf(bar.get('.notice p').element)).toBe('Deine bisherige Arbeit ist wieder da.');
  });

  it('has no button to do anything where it offers nothing', async () => {
    const { page, bar } = withNotices();
    page.notices.show({ kind: 'ok', key: 'console.copied' });
    await nextTick();
    expect(bar.findAll('button').map((it) => it.attributes('aria-label'))).toEqual(['Schliessen']);
  });

  it('goes as soon as it does not hold any more', async () => {
    const { page, isShown } = withNotices();
    const holds = shallowRef(true);
    page.notices.show({ kind: 'warn', key: 'notice.cleared', holds: () => holds.value });
    await nextTick();
    expect(isShown()).toBe(true);
    holds.value = false;
    await nextTick();
    expect(isShown()).toBe(false);
  });

  it('goes once the user has got to the console to which it leads', async () => {
    const { page, isShown } = withNotices(390);
    const show = () => void (page.layout.tab.value = 'console');
    page.notices.show({ kind: 'error', key: 'state.failed', action: { key: 'nav.console', run: show } });
    page.layout.tab.value = 'arena';
    await nextTick();
    expect(isShown()).toBe(true);
    page.layout.tab.value = 'console';
    await nextTick();
    expect(isShown()).toBe(false);
  });

  it('stays on the way to the console when it is about something else', async () => {
    const { page, isShown } = withNotices(390);
    page.notices.show({ kind: 'ok', key: 'notice.cleared', action: { key: 'notice.undo', run: () => undefined } });
    page.layout.tab.value = 'console';
    await nextTick();
    expect(isShown()).toBe(true);
  });
});

describe('the place of a message', () => {
  /** A part of the page with room for messages. */
  function room(name: string, left: number, top: number, width: number): void {
    const part = document.createElement('div');
    part.dataset['notices'] = name;
    part.getBoundingClientRect = () => ({ left, top, width, height: 500 }) as DOMRect;
    document.body.append(part);
  }
  /** The element on top at every place in the window. */
  let above: Element | null = null;
  beforeEach(() => {
    above = null;
    Object.assign(document, { elementsFromPoint: () => (above === null ? [] : [above]) });
  });
  afterEach(() => document.querySelectorAll('[data-notices]').forEach((part) => part.remove()));
  async function placeOf(): Promise<string[]> {
    const { page, bar } = withNotices();
    page.notices.show({ kind: 'ok', key: 'console.copied' });
    await flushPromises();
    const { left, top, width, bottom } = (bar.element as HTMLElement).style;
    return [left, top, width, bottom];
  }

  it('is along the lower edge of the program', async () => {
    room('arena', 508, 122, 700);
    room('code', 0, 120, 500);
    expect(await placeOf()).toEqual(['0px', 'auto', '500px', `${String(window.innerHeight - 616)}px`]);
  });

  it('is nowhere where a card lies', async () => {
    room('code', 0, 120, 500);
    above = document.createElement('section');
    expect(await placeOf()).toEqual(['', '', '', '']);
  });

  it('is at the foot of a page that shows nothing with room for it', async () => {
    expect(await placeOf()).toEqual(['', '', '', '']);
  });
});

/** A page with its dialog, and a button that had the keyboard before. */
function withDialog() {
  const page = createPage();
  const before = document.createElement('button');
  document.body.append(before);
  before.focus();
  mountOn(page, AppDialog);
  return { page, before };
}
const dialog = (): HTMLElement | null => document.querySelector('.dialog-card');
const answers = (): readonly string[] => [...document.querySelectorAll('.dialog-card button')].map(textOf);

/** Asks whether a file shall be replaced; notes the answer. */
function askRemoval(page: TestPage, file: string, said: string[]): void {
  page.dialogs.ask({
    kind: 'choose',
    title: 'files.askTitle',
    text: 'files.askText',
    values: { file },
    choices: [
      { key: 'code.cancel', run: () => said.push(`${file} stays`) },
      { key: 'files.askReplace', look: 'stop', run: () => said.push(`${file} goes`) },
    ],
  });
}

describe('the question in a dialog', () => {
  it('has a title, a text and its answers', async () => {
    const { page } = withDialog();
    expect(dialog()).toBeNull();
    askRemoval(page, 'drive.py', []);
    await flushPromises();
    expect(textOf(dialog()?.querySelector('h2'))).toBe('drive.py gibt es schon');
    expect(textOf(dialog()?.querySelector('p'))).toBe(
      'Soll die geladene Datei die offene ersetzen? Die bisherige Arbeit bleibt aufbewahrt.',
    );
    expect(answers()).toEqual(['Abbrechen', 'Ersetzen']);
    named('drive.py gibt es schon', '[role="dialog"]');
  });

  it('does only what was answered', async () => {
    const { page } = withDialog();
    const said: string[] = [];
    askRemoval(page, 'drive.py', said);
    await flushPromises();
    await press('Ersetzen', '.dialog-card button');
    expect(said).toEqual(['drive.py goes']);
    expect(page.dialogs.current.value).toBeNull();
  });

  it('lets a second question wait for its turn', async () => {
    const { page } = withDialog();
    const said: string[] = [];
    askRemoval(page, 'one.py', said);
    askRemoval(page, 'two.py', said);
    await flushPromises();
    expect(textOf(dialog()?.querySelector('h2'))).toBe('one.py gibt es schon');
    await press('Abbrechen', '.dialog-card button');
    await flushPromises();
    expect(textOf(dialog()?.querySelector('h2'))).toBe('two.py gibt es schon');
    await press('Ersetzen', '.dialog-card button');
    expect(said).toEqual(['one.py stays', 'two.py goes']);
  });

  it('gives the keyboard back to what had it before, after the last of several', async () => {
    const { page, before } = withDialog();
    askRemoval(page, 'one.py', []);
    askRemoval(page, 'two.py', []);
    await flushPromises();
    named('Ersetzen', '.dialog-card button').focus();
    await press('Ersetzen', '.dialog-card button');
    await flushPromises();
    expect(document.activeElement).not.toBe(before);
    await press('Ersetzen', '.dialog-card button');
    await flushPromises();
    expect(document.activeElement).toBe(before);
  });
});

describe('the question for a file’s name', () => {
  async function asked(own?: string) {
    const { page } = withDialog();
    page.work.create('drive.py', 'x = 1\n');
    const done: string[] = [];
    page.dialogs.ask(fileNameQuestion(page, own ?? '', (name) => done.push(name)));
    await flushPromises();
    const submit = async () => {
      document.querySelector('.dialog-card form')?.dispatchEvent(new Event('submit', { cancelable: true }));
      await nextTick();
    };
    const field = named('Dateiname', 'input') as HTMLInputElement;
    return { page, done, submit, field, problem: () => textOf(document.getElementById('file-name-problem')) };
  }

  it('begins empty for a new file, and adds the ending', async () => {
    const { page, done, submit, field } = await asked();
    expect(field.value).toBe('');
    expect(answers()).toEqual(['Abbrechen', 'Erstellen']);
    await fill('Dateiname', 'turn');
    await submit();
    expect(done).toEqual(['turn.py']);
    expect(page.dialogs.current.value).toBeNull();
  });

  it('begins with the name to be changed, without its ending selected', async () => {
    const { field } = await asked('drive.py');
    expect(field.value).toBe('drive.py');
    expect([field.selectionStart, field.selectionEnd]).toEqual([0, 5]);
    expect(answers()).toEqual(['Abbrechen', 'Umbenennen']);
  });

  it('says what is wrong with a name and takes none of those', async () => {
    const { page, done, submit, field, problem } = await asked();
    expect(problem()).toBe('');
    await submit();
    expect(problem()).toBe('Gib einen Namen ein.');
    await fill('Dateiname', 'drive.py');
    expect(problem()).toBe('Diese Datei gibt es schon.');
    expect(field.getAttribute('aria-invalid')).toBe('true');
    await fill('Dateiname', 'à la carte');
    expect(problem()).toMatch(/^Erlaubt sind Buchstaben/);
    await submit();
    expect(done).toEqual([]);
    expect(page.dialogs.current.value).not.toBeNull();
  });

  it('does nothing when the name stays the same', async () => {
    const { page, done, submit } = await asked('drive.py');
    await submit();
    expect(done).toEqual([]);
    expect(page.dialogs.current.value).toBeNull();
  });
});
