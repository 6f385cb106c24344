// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { SPEEDS } from '#simulation/pace';

import { byId, isThere, tap } from './testing/find';
import { mountOn, named, setWindow, textOf } from './testing/mount-on';
import { createPage } from './testing/page';
import { startRun } from './testing/run';
import AppDialog from './AppDialog.vue';
import LanguageList from './LanguageList.vue';
import LiveRegion from './LiveRegion.vue';
import MainList from './MainList.vue';
import NoticeBar from './NoticeBar.vue';
import SpeedList from './SpeedList.vue';
import { useDark } from './use-dark';
import { useDrop } from './use-drop';

const germanPage = () => {
  const page = createPage();
  page.settings.change({ language: 'de' });
  return page;
};
const chosen = (): readonly string[] =>
  [...document.querySelectorAll('[role="menuitemradio"][aria-checked="true"]')].map((it) => textOf(it));
const items = (): readonly HTMLElement[] => [...document.querySelectorAll<HTMLElement>('.v-list-item')];
const item = (text: string): HTMLElement => {
  const found = items().find((it) => textOf(it) === text);
  if (found === undefined) throw new Error(`No entry “${text}”, only ${items().map(textOf).join(' · ')}`);
  return found;
};

beforeEach(() => setWindow(1400, 800));
afterEach(() => {
  vi.restoreAllMocks();
  vi.useRealTimers();
});

describe('the list of languages', () => {
  it('names each language in itself, and marks the one in use', async () => {
    const page = germanPage();
    mountOn(page, LanguageList);
    expect(
      items()
        .map((it) => it.lang)
        .sort(),
    ).toEqual(['de', 'en', 'fr', 'it']);
    expect(chosen()).toEqual(['Deutsch']);
    await tap(item('Français'));
    expect(page.settings.current.value.language).toBe('fr');
    expect(chosen()).toEqual(['Français']);
  });
});

describe('the list of speeds', () => {
  it('has every speed; the one that is chosen reaches the run', async () => {
    const page = germanPage();
    mountOn(page, SpeedList);
    expect(items()).toHaveLength(SPEEDS.length);
    expect(chosen()).toHaveLength(1);
    await tap(items().at(-1)!);
    expect(page.settings.current.value.speed).toBe(SPEEDS.at(-1));
    expect(chosen()).toEqual([textOf(items().at(-1))]);
  });
});

describe('the menu', () => {
  it('opens help and tour only once it is gone', async () => {
    const page = germanPage();
    const left: (() => void)[] = [];
    mountOn(page, MainList, { onLeave: (open: () => void) => left.push(open) });
    await tap('menu-help');
    await tap('menu-tour');
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual([null, false]);
    for (const open of left) open();
    expect([page.guide.at.value, page.tour.isOpen.value]).toEqual(['', true]);
  });

  it('offers to go on with a tour that was left', () => {
    const page = germanPage();
    page.settings.change({ tourStep: 'arena' });
    mountOn(page, MainList);
    expect(textOf(byId('menu-tour'))).toBe('Rundgang fortsetzen');
  });

  it.each(['share', 'real-device', 'open-link'])('asks for its dialog: %s', async (name) => {
    const asked = vi.fn();
    mountOn(germanPage(), MainList, { onDialog: asked });
    await tap(`menu-${name}`);
    expect(asked).toHaveBeenCalledExactlyOnceWith(name);
  });

  it('has what the bar of a phone has no room for', async () => {
    setWindow(390, 800);
    const page = germanPage();
    mountOn(page, MainList);
    expect(byId('pause').getAttribute('aria-disabled')).toBe('true');
    await tap(item('Ton ausschalten'));
    expect(page.settings.current.value.muted).toBe(true);
    item('Ton einschalten');
    await startRun(page);
    await nextTick();
    expect(byId('pause').getAttribute('aria-disabled')).not.toBe('true');
  });

  it('has none of that where the bar has room', () => {
    mountOn(germanPage(), MainList);
    for (const id of ['pause', 'step', 'device']) expect(isThere(id), id).toBe(false);
  });

  it('hides and shows the microcomputer and the arena', async () => {
    const page = germanPage();
    mountOn(page, MainList);
    await tap(item('Mikrocomputer ausblenden'));
    expect(page.settings.current.value.showBoard).toBe(false);
    await tap(item('Mikrocomputer zeigen'));
    await tap(item('Arena ausblenden'));
    expect([page.settings.current.value.showBoard, page.settings.current.value.showArena]).toEqual([true, false]);
  });

  it('switches the check of what runs on the device', async () => {
    const page = germanPage();
    mountOn(page, MainList);
    const before = page.settings.current.value.deviceCheck;
    await tap('device-check-switch');
    expect(page.settings.current.value.deviceCheck).toBe(!before);
    expect(byId('device-check-switch').getAttribute('aria-checked')).toBe(String(!before));
  });

  it('chooses light, dark or as the device has it', async () => {
    const page = germanPage();
    mountOn(page, MainList);
    await tap(item('Dunkel'));
    expect(page.settings.current.value.theme).toBe('dark');
    expect(chosen()).toContain('Dunkel');
    expect(chosen()).not.toContain('Hell');
  });

  it('saves the program that is shown', async () => {
    const saved: string[] = [];
    vi.spyOn(URL, 'createObjectURL').mockReturnValue('blob:here');
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
      saved.push(this.download);
    });
    const page = germanPage();
    page.work.create('helper.py', 'x = 1\n');
    mountOn(page, MainList);
    await tap('menu-save-program');
    expect(saved).toEqual(['helper.py']);
  });
});

describe('a message at the foot of the page', () => {
  it.each([
    ['ok', 5_000],
    ['info', 5_000],
    ['warn', 5_000],
  ] as const)('goes by itself: %s after %i ms', async (kind, ms) => {
    vi.useFakeTimers();
    const page = germanPage();
    mountOn(page, NoticeBar);
    page.notices.show({ kind, key: 'files.saved', values: { file: 'main.py' } });
    await nextTick();
    expect(textOf(document.querySelector('.notice p'))).toBe('main.py ist gespeichert.');
    vi.advanceTimersByTime(ms - 1);
    expect(page.notices.current.value).not.toBeNull();
    vi.advanceTimersByTime(1);
    expect(page.notices.current.value).toBeNull();
  });

  it('stays when something went wrong', async () => {
    vi.useFakeTimers();
    const page = germanPage();
    mountOn(page, NoticeBar);
    page.notices.show({ kind: 'error', key: 'notice.firmware' });
    await nextTick();
    vi.advanceTimersByTime(60_000);
    expect(page.notices.current.value).not.toBeNull();
  });

  it('with something to do stays for 12 s; doing it takes it away', async () => {
    vi.useFakeTimers();
    const page = germanPage();
    mountOn(page, NoticeBar);
    const run = vi.fn();
    page.notices.show({ kind: 'ok', key: 'notice.cleared', action: { key: 'notice.undo', run } });
    await nextTick();
    vi.advanceTimersByTime(11_999);
    await tap(named('Rückgängig'));
    expect(run).toHaveBeenCalledOnce();
    expect(page.notices.current.value).toBeNull();
  });

  it('has a time of its own: one that takes another’s place stays its full time', async () => {
    vi.useFakeTimers();
    const page = germanPage();
    mountOn(page, NoticeBar);
    page.notices.show({ kind: 'ok', key: 'notice.cleared' });
    await nextTick();
    vi.advanceTimersByTime(4_000);
    page.notices.show({ kind: 'ok', key: 'files.saved', values: { file: 'a.py' } });
    await nextTick();
    vi.advanceTimersByTime(4_000);
    expect(page.notices.current.value?.key).toBe('files.saved');
  });
});

describe('a question', () => {
  it('is asked with its answers; the chosen one is done once, and the question is gone', async () => {
    const page = germanPage();
    mountOn(page, AppDialog);
    const answers = { no: vi.fn(), yes: vi.fn() };
    page.dialogs.ask({
      kind: 'choose',
      title: 'files.askTitle',
      text: 'files.askText',
      values: { file: 'main.py' },
      choices: [
        { key: 'code.cancel', run: answers.no },
        { key: 'files.askReplace', run: answers.yes },
      ],
    });
    await nextTick();
    expect(textOf(document.querySelector('.dialog-card h2'))).toBe('main.py gibt es schon');
    await tap(named('Ersetzen'));
    expect([answers.no.mock.calls.length, answers.yes.mock.calls.length]).toEqual([0, 1]);
    expect(page.dialogs.current.value).toBeNull();
  });
});

describe('what a screen reader hears of the run', () => {
  it('is that it runs, rests, and is stopped', async () => {
    const page = germanPage();
    const region = mountOn(page, LiveRegion);
    await startRun(page);
    await nextTick();
    expect(region.text()).toBe('Die Simulation läuft.');
    await page.run.stop();
    await nextTick();
    expect(region.text()).toBe('Die Simulation ist gestoppt.');
  });
});

describe('light and dark', () => {
  it('follow the choice, and the device where nothing is chosen', async () => {
    const query = Object.assign(new EventTarget(), { matches: true });
    vi.spyOn(window, 'matchMedia').mockReturnValue(query as unknown as MediaQueryList);
    const page = germanPage();
    const theme = (): string | undefined => document.documentElement.dataset['theme'];
    page.scope.run(() => useDark(page.settings));
    page.settings.change({ theme: 'system' });
    await nextTick();
    expect(theme()).toBe('dark');
    query.matches = false;
    query.dispatchEvent(new Event('change'));
    await nextTick();
    expect(theme()).toBe('light');
    page.settings.change({ theme: 'dark' });
    await nextTick();
    expect(theme()).toBe('dark');
  });
});

describe('files over the page', () => {
  /** What is dragged: files, or a piece of text. */
  const drag = (type: string, types: readonly string[], files: readonly File[] = []): DragEvent =>
    Object.assign(new Event(type, { bubbles: true, cancelable: true }), {
      dataTransfer: { types, files },
      relatedTarget: null,
    }) as unknown as DragEvent;

  it('are announced while they are held there, and taken when they are let go', () => {
    const taken: string[] = [];
    const page = germanPage();
    const isOver = page.scope.run(() => useDrop((files) => taken.push(...[...files].map(({ name }) => name))))!;
    document.body.dispatchEvent(drag('dragover', ['Files']));
    expect(isOver.value).toBe(true);
    document.body.dispatchEvent(drag('dragleave', ['Files']));
    expect(isOver.value).toBe(false);
    const drop = drag('drop', ['Files'], [new File(['x = 1'], 'a.py')]);
    document.body.dispatchEvent(drop);
    expect([taken, drop.defaultPrevented]).toEqual([['a.py'], true]);
    page.scope.stop();
    document.body.dispatchEvent(drag('drop', ['Files'], [new File([''], 'b.py')]));
    expect(taken).toEqual(['a.py']);
  });

  it('are meant, and not text that is dragged within the editor', () => {
    const page = germanPage();
    const take = vi.fn();
    const isOver = page.scope.run(() => useDrop(take))!;
    document.body.dispatchEvent(drag('dragover', ['text/plain']));
    expect(isOver.value).toBe(false);
    document.body.dispatchEvent(drag('drop', ['text/plain']));
    expect(take).not.toHaveBeenCalled();
    page.scope.stop();
  });
});
