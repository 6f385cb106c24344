// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick, shallowRef } from 'vue';

import { useDrop } from '../exchange/share/use-drop';
import { useCommandKeys } from '../kit/command-keys';
import { useBoardKeys } from '../pupil/board/use-board-keys';
import LiveRegion from '../pupil/console/LiveRegion.vue';
import { useDark } from '../session/work/settings/use-dark';
import { mountOn, setWindow, textOf } from './testing/mount-on';
import { createPage, type TestPage } from './testing/page';
import { inputsOf, show, startRun } from './testing/run';
import { useSound } from './use-sound';

/** Mounts something that listens to the page. */
function listening<T>(page: TestPage, use: () => T) {
  const given = shallowRef<T>();
  const Listener = defineComponent({
    setup() {
      given.value = use();
      return () => h('p');
    },
  });
  const mounted = mountOn(page, Listener);
  return { given: given.value as T, unmount: () => mounted.vm.$.root.appContext.app.unmount() };
}
/** The presses on the board so far: `+a`, `-a`, `+pinLogo` … */
const presses = (page: TestPage): readonly string[] =>
  inputsOf(page).flatMap((input) =>
    input.type === 'button'
      ? [`${input.down ? '+' : '-'}${input.button}`]
      : input.type === 'touch'
        ? [`${input.down ? '+' : '-'}${input.pad}`]
        : [],
  );
function key(type: 'keydown' | 'keyup', name: string, more: KeyboardEventInit = {}, on: EventTarget = document.body) {
  const event = new KeyboardEvent(type, { key: name, bubbles: true, cancelable: true, ...more });
  on.dispatchEvent(event);
  return event;
}

describe('keys on the page', () => {
  async function running() {
    const page = createPage();
    const commands: string[] = [];
    const { unmount } = listening(page, () => {
      useBoardKeys(page);
      useCommandKeys({ enter: () => commands.push('run'), s: () => commands.push('save') });
    });
    await startRun(page);
    return { page, commands, unmount };
  }

  it('press the buttons A and B and the logo while a program runs, as long as they are held', async () => {
    const { page } = await running();
    for (const name of ['a', 'b', 'l']) {
      key('keydown', name);
      key('keyup', name);
    }
    expect(presses(page)).toEqual(['+a', '-a', '+b', '-b', '+pinLogo', '-pinLogo']);
  });

  it('press both buttons together', async () => {
    const { page } = await running();
    key('keydown', 'a');
    key('keydown', 'b');
    key('keyup', 'a');
    key('keyup', 'b');
    expect(presses(page)).toEqual(['+a', '+b', '-a', '-b']);
  });

  it('mean the same with Caps Lock, and a held key presses once', async () => {
    const { page } = await running();
    key('keydown', 'A');
    key('keydown', 'A', { repeat: true });
    key('keyup', 'a');
    expect(presses(page)).toEqual(['+a', '-a']);
  });

  it('let go when the window loses the keyboard: no button stays down', async () => {
    const { page } = await running();
    key('keydown', 'a');
    dispatchEvent(new Event('blur'));
    expect(presses(page)).toEqual(['+a', '-a']);
    key('keyup', 'a');
    expect(presses(page)).toEqual(['+a', '-a']);
  });

  it.each([
    ['a text field', '<input>'],
    ['the editor', '<p contenteditable="true"></p>'],
    ['a menu, which jumps by letters', '<ul role="menu"><li tabindex="0"></li></ul>'],
    ['a dialog', '<p role="dialog"><button></button></p>'],
  ])('belong to %s while it has them', async (_name, html) => {
    const { page } = await running();
    document.body.insertAdjacentHTML('beforeend', html);
    const last = document.body.lastElementChild;
    key('keydown', 'a', {}, last?.firstElementChild ?? last ?? document.body);
    expect(presses(page)).toEqual([]);
  });

  it('do nothing to the board without a run, nor with Alt', async () => {
    const { page } = await running();
    key('keydown', 'a', { altKey: true });
    await page.run.stop();
    key('keydown', 'a');
    expect(presses(page)).toEqual([]);
  });

  it('run and save with Ctrl or ⌘, from a text field, too, and keep the browser from it', async () => {
    const { page, commands } = await running();
    const field = document.createElement('textarea');
    document.body.append(field);
    expect(key('keydown', 's', { ctrlKey: true }, field).defaultPrevented).toBe(true);
    expect(key('keydown', 'Enter', { metaKey: true }, field).defaultPrevented).toBe(true);
    expect(key('keydown', 'a', { ctrlKey: true }, field).defaultPrevented).toBe(false);
    expect(commands).toEqual(['save', 'run']);
    expect(presses(page)).toEqual([]);
  });

  it('are not listened to any more once the page is gone; what was held is let go', async () => {
    const { page, unmount } = await running();
    key('keydown', 'b');
    unmount();
    expect(presses(page)).toEqual(['+b', '-b']);
    key('keydown', 'a');
    expect(presses(page)).toEqual(['+b', '-b']);
  });
});

describe('files that are dropped onto the page', () => {
  function drag(type: string, files: readonly File[] | null, relatedTarget: EventTarget | null = null) {
    const event = Object.assign(new Event(type, { bubbles: true, cancelable: true }), {
      dataTransfer: { types: files === null ? ['text/plain'] : ['Files'], files: files ?? [] },
    });
    Object.defineProperty(event, 'relatedTarget', { value: relatedTarget });
    document.body.dispatchEvent(event);
    return event;
  }
  function dropping() {
    const taken: string[][] = [];
    const { given: isOver, unmount } = listening(createPage(), () =>
      useDrop((files) => taken.push([...files].map(({ name }) => name))),
    );
    return { isOver, taken, unmount };
  }
  const files = [new File(['x'], 'one.py'), new File(['{}'], 'two.json')];

  it('are taken, all of them, and not opened by the browser', () => {
    const { isOver, taken } = dropping();
    expect(drag('dragover', files).defaultPrevented).toBe(true);
    expect(isOver.value).toBe(true);
    expect(drag('drop', files).defaultPrevented).toBe(true);
    expect(isOver.value).toBe(false);
    expect(taken).toEqual([['one.py', 'two.json']]);
  });

  it('do not reach the editor, which would type their text', () => {
    dropping();
    const typed = vi.fn();
    document.body.addEventListener('drop', typed);
    drag('drop', files);
    document.body.removeEventListener('drop', typed);
    expect(typed).not.toHaveBeenCalled();
  });

  it('are waited for until they leave the window, not when they pass from one thing to the next', () => {
    const { isOver } = dropping();
    drag('dragover', files);
    drag('dragleave', files, document.body);
    expect(isOver.value).toBe(true);
    drag('dragleave', files);
    expect(isOver.value).toBe(false);
  });

  it('are something else than dragged text, which stays the editor’s', () => {
    const { isOver, taken } = dropping();
    expect(drag('dragover', null).defaultPrevented).toBe(false);
    expect(drag('drop', null).defaultPrevented).toBe(false);
    expect(isOver.value).toBe(false);
    expect(taken).toEqual([]);
  });

  it('are nobody’s once the page is gone', () => {
    const { taken, unmount } = dropping();
    unmount();
    drag('drop', files);
    expect(taken).toEqual([]);
  });
});

describe('light and dark', () => {
  afterEach(() => void vi.unstubAllGlobals());
  /** A device that is dark or not; `turn` changes it. */
  function device(isDark: boolean) {
    const query = Object.assign(new EventTarget(), { matches: isDark });
    const real = window.matchMedia.bind(window);
    vi.stubGlobal('matchMedia', (text: string) => (text.includes('dark') ? query : real(text)));
    const page = createPage();
    const { given: dark } = listening(page, () => useDark(page.settings));
    const turn = async (matches: boolean) => {
      query.matches = matches;
      query.dispatchEvent(new Event('change'));
      await nextTick();
    };
    return { page, dark, turn };
  }
  const marked = () => document.documentElement.dataset['theme'];

  it('follow the device, also when evening comes', async () => {
    const { dark, turn } = device(false);
    expect([dark.value, marked()]).toEqual([false, 'light']);
    await turn(true);
    expect([dark.value, marked()]).toEqual([true, 'dark']);
  });

  it('stay as the pupil has chosen, whatever the device does', async () => {
    const { page, dark, turn } = device(true);
    page.settings.change({ theme: 'light' });
    await nextTick();
    expect([dark.value, marked()]).toEqual([false, 'light']);
    await turn(false);
    page.settings.change({ theme: 'dark' });
    await nextTick();
    expect([dark.value, marked()]).toEqual([true, 'dark']);
  });
});

describe('the sound of a run', () => {
  /** A page that notes what its sound player is told. */
  function sounding() {
    const page = createPage();
    const told: string[] = [];
    const { sound } = page;
    vi.spyOn(sound, 'wake').mockImplementation(() => void told.push('wake'));
    vi.spyOn(sound, 'start').mockImplementation(() => void told.push('start'));
    vi.spyOn(sound, 'setSpeed').mockImplementation((speed) => void told.push(`speed ${speed}`));
    vi.spyOn(sound, 'setMuted').mockImplementation((muted) => void told.push(muted ? 'muted' : 'heard'));
    vi.spyOn(sound, 'dispose').mockImplementation(() => void told.push('gone'));
    const { unmount } = listening(page, () => useSound(page));
    const lately = () => told.splice(0);
    return { page, lately, unmount };
  }

  it('is made inside the tap that starts the run: later no browser allows it', () => {
    const { page, lately } = sounding();
    expect(lately()).toEqual(['speed 0', 'heard']);
    void page.run.start();
    expect(lately()).toEqual(expect.arrayContaining(['start', 'wake']));
  });

  it('goes as fast as the run, and is silent while it pauses or is over', async () => {
    const { page, lately } = sounding();
    page.settings.change({ speed: 0.5 });
    await startRun(page);
    expect(lately().at(-1)).toBe('speed 0.5');
    page.run.pause();
    expect(lately()).toEqual(['speed 0']);
    page.run.resume();
    expect(lately()).toEqual(['speed 0.5']);
    page.settings.change({ speed: 'max' });
    expect(lately()).toEqual(['speed Infinity']);
    await page.run.stop();
    expect(lately().at(-1)).toBe('speed 0');
  });

  it('comes back with the tap that turns it on, during a run only', async () => {
    const { page, lately } = sounding();
    page.settings.change({ muted: true });
    expect(lately().at(-1)).toBe('muted');
    page.settings.change({ muted: false });
    expect(lately()).toEqual(['heard']);
    await startRun(page);
    page.settings.change({ muted: true });
    lately();
    page.settings.change({ muted: false });
    expect(lately()).toEqual(['heard', 'wake']);
  });

  it('says when the browser does not allow it, and tries again with the next tap or key', async () => {
    const { page, lately } = sounding();
    page.sound.isBlocked.value = true;
    await nextTick();
    expect(page.notices.current.value).toMatchObject({ kind: 'info', key: 'notice.soundBlocked' });
    lately();
    dispatchEvent(new Event('pointerdown'));
    dispatchEvent(new Event('keydown'));
    expect(lately()).toEqual(['wake', 'wake']);
    page.sound.isBlocked.value = false;
    await nextTick();
    dispatchEvent(new Event('pointerdown'));
    expect(lately()).toEqual([]);
  });

  it('ends with the page', async () => {
    const { page, lately, unmount } = sounding();
    page.sound.isBlocked.value = true;
    await nextTick();
    unmount();
    expect(lately().at(-1)).toBe('gone');
    dispatchEvent(new Event('pointerdown'));
    expect(lately()).toEqual([]);
  });
});

const zeroDivision = {
  type: 'ZeroDivisionError',
  message: 'divide by zero',
  line: 2,
  traceback: 'Traceback (most recent call last):\n  File "main.py", line 2, in <module>\nZeroDivisionError: divide by zero', // prettier-ignore
};
const finished = { kind: 'finished', exception: null, timeUs: 1000 } as const;
const failed = { kind: 'exception', exception: zeroDivision, timeUs: 1000 } as const;

describe('what screen readers hear of a run', () => {
  function region() {
    const page = createPage();
    page.work.setText('main.py', 'x = 0\nprint(1 / x)\n');
    const mounted = mountOn(page, LiveRegion);
    return { page, mounted, said: () => textOf(mounted.element) };
  }

  it('is nothing before the first, in a place that is there already', () => {
    const { mounted, said } = region();
    expect(said()).toBe('');
    expect([mounted.attributes('role'), mounted.attributes('aria-live')]).toEqual(['status', 'polite']);
    expect(mounted.classes()).toContain('vh');
  });

  it('is that it runs, pauses, has stopped and is back at the start', async () => {
    const { page, said } = region();
    await startRun(page);
    expect(said()).toBe('Die Simulation läuft.');
    page.run.pause();
    await nextTick();
    expect(said()).toBe('Die Simulation macht Pause.');
    page.run.resume();
    await page.run.stop();
    await nextTick();
    expect(said()).toBe('Die Simulation ist gestoppt.');
    await page.run.reset();
    await nextTick();
    expect(said()).toBe('Alles steht wieder am Start.');
  });

  it('is that the program has ended, while the world goes on', async () => {
    const { page, said } = region();
    await startRun(page);
    page.say({ type: 'program-ended', ended: finished, device: 0 });
    await flushPromises();
    expect(said()).toBe('Das Programm ist zu Ende. Die Simulation läuft weiter.');
  });

  it('is an error with its file, its line and what it means', async () => {
    const { page, said } = region();
    await startRun(page);
    page.say({ type: 'program-ended', ended: failed, device: 0 });
    await vi.waitFor(() => expect(said()).toMatch(/^Fehler in main\.py, Zeile 2: Durch null /), 20_000);
  });

  it('is not the error of the run before, when a new one has begun meanwhile', async () => {
    const { page, said } = region();
    await startRun(page);
    page.say({ type: 'program-ended', ended: failed, device: 0 });
    void page.run.start();
    await flushPromises();
    page.say({ type: 'started' });
    await flushPromises();
    expect(said()).toBe('Die Simulation läuft.');
  });
});

describe('how a run ends, in the console and at the foot of the page', () => {
  beforeEach(() => setWindow(1024));

  async function running(width = 1024) {
    setWindow(width);
    const page = createPage();
    page.work.setText('main.py', 'x = 0\nprint(1 / x)\n');
    await startRun(page);
    const end = async (ended: object) => {
      page.say({ type: 'program-ended', ended: ended as typeof finished, device: 0 });
      await flushPromises();
    };
    /** The keys of the notes that the console shows. */
    const notes = () =>
      page.console.entries.value.flatMap((entry) => (entry.kind === 'note' ? [entry.key as string] : []));
    return { page, end, notes };
  }
  const driving = { robot: { state: { duty: { left: 80, right: 80 } } } as never };

  it('is told in a note, with a warning where the motors go on turning', async () => {
    const still = await running();
    await still.end(finished);
    expect(still.notes()).toEqual(['console.finished']);
    const moving = await running();
    await show(moving.page, driving);
    await moving.end(finished);
    expect(moving.notes()).toEqual(['console.finishedDriving']);
  });

  it('is a card with the line for an exception, and the line is marked in the program', async () => {
    const { page, end } = await running();
    await end(failed);
    expect(page.jump.wrong.value).toEqual({ file: 'main.py', line: 2, device: 0 });
    expect(page.console.entries.value.map(({ kind }) => kind)).toContain('error');
    await page.run.start();
    expect(page.jump.wrong.value).toBeNull();
  });

  it('warns after an exception, too, that the motors turn', async () => {
    const { page, end, notes } = await running();
    await show(page, driving);
    await end(failed);
    expect(notes()).toEqual(['console.motorsOn']);
  });

  it('is no error when the pupil interrupted it', async () => {
    const { page, end, notes } = await running();
    await end({ ...failed, kind: 'stopped' });
    expect(notes()).toEqual(['console.interrupted']);
    expect(page.jump.wrong.value).toBeNull();
    expect(page.console.entries.value.some(({ kind }) => kind === 'error')).toBe(false);
  });

  it('says how to go on after panic()', async () => {
    const { end, notes } = await running();
    await end({ kind: 'panic', exception: null, timeUs: 1000 });
    expect(notes()).toEqual(['console.panic']);
  });

  it('is said once that it was stopped', async () => {
    const { page, notes } = await running();
    await page.run.stop();
    await page.run.stop();
    expect(notes()).toEqual(['console.stopped']);
  });

  it('shows an error on a phone over the board, with the way to the line', async () => {
    const { page, end } = await running(390);
    page.layout.tab.value = 'board';
    await end(failed);
    await vi.waitFor(() => expect(page.notices.current.value).not.toBeNull(), 20_000);
    expect(page.notices.current.value).toMatchObject({
      kind: 'error',
      key: 'state.announceErrorLine',
      values: { file: 'main.py', line: 2 },
    });
    page.notices.current.value?.action?.run();
    expect(page.layout.isShown.value.code).toBe(true);
  });

  it.each(['console', 'arena'] as const)(
    'shows it there only where it is out of sight: not over the %s',
    async (tab) => {
      const { page, end } = await running(390);
      page.layout.tab.value = tab;
      await end(failed);
      await flushPromises();
      expect(page.notices.current.value).toBeNull();
    },
  );
});

describe('what goes wrong with a run through no fault of the program', () => {
  it('is told in the words of the simulation, and the run is over', async () => {
    const page = createPage();
    await startRun(page);
    page.say({ type: 'failed', message: 'Too many bodies.' });
    await vi.waitFor(() => expect(page.notices.current.value).not.toBeNull(), 20_000);
    expect(page.notices.current.value).toMatchObject({ kind: 'error', key: 'notice.failed', values: { message: 'Too many bodies.' } }); // prettier-ignore
    expect(page.run.isActive.value).toBe(false);
  });

  it('is only mentioned where the run goes on', async () => {
    const page = createPage();
    await startRun(page);
    page.say({ type: 'refused', message: 'No such pin.' });
    expect(page.notices.current.value).toMatchObject({ kind: 'info', key: 'notice.refused' });
    expect(page.run.isActive.value).toBe(true);
  });

  it('goes with the next run', async () => {
    const page = createPage();
    await startRun(page);
    page.say({ type: 'refused', message: 'No such pin.' });
    await page.run.start();
    expect(page.notices.current.value).toBeNull();
  });

  it('is told at the foot of the page where the arena is out of sight: a robot on the wrong board', async () => {
    setWindow(390);
    const page = createPage();
    page.work.setText('main.py', 'from callibot import *\nmotor(0, 50, 50)\n');
    page.settings.change({ robot: 'maqueen-lite' });
    page.layout.tab.value = 'code';
    await page.run.start();
    expect(page.notices.current.value).toMatchObject({ kind: 'warn' });
    page.notices.current.value?.action?.run();
    await nextTick();
    expect(page.settings.current.value.robot).not.toBe('maqueen-lite');
    page.notices.close();
    await page.run.start();
    expect(page.notices.current.value).toBeNull();
  });
});
