// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { downloads } from '../../app/testing/downloads';
import { press } from '../../app/testing/editing';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { realBoard } from '../../session/run/board/real-board';
import RealDeviceDialog from './RealDeviceDialog.vue';
import { simulatedBoard, type SimulatedBoard } from './serial/testing/simulated-board';

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
const byId = (id: string) => document.querySelector<HTMLElement>(`[data-testid="${id}"]`);
const said = () => textOf(byId('real-device-said'));
const buttons = () => [...document.querySelectorAll('.act button')].map(textOf);
const HELLO = 'print("hello")\n';

/** The browser's way to devices: what was asked of it, and what it hands out. */
function withSerial(port: () => Promise<unknown>) {
  const requestPort = vi.fn((_wish: unknown) => port());
  Object.defineProperty(navigator, 'serial', { value: { requestPort }, configurable: true });
  return requestPort;
}
/** The open dialog for this program. */
async function opened(text = HELLO, robot = 'none') {
  const page = createPage();
  page.settings.change({ language: 'de', device: 'microbit-v2', robot });
  page.work.setText('main.py', text);
  let closed = 0;
  mountOn(page, RealDeviceDialog, { onClose: () => (closed += 1) });
  await vi.waitFor(() => expect(byId('way-serial')).not.toBeNull());
  byId('way-serial')?.click();
  await flushPromises();
  return { page, closed: () => closed };
}

beforeEach(() => {
  vi.stubGlobal('fetch', () => Promise.reject(new Error('There is no web server.')));
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
});
afterEach(() => {
  Reflect.deleteProperty(navigator, 'serial');
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

describe('a project on its way to a device', { timeout: 60_000 }, () => {
  /** The board of this test; time passes for it until the test is over. */
  let plugged: SimulatedBoard | null = null;
  const unplugged = () => void (plugged = null);
  afterEach(unplugged);

  /** A micro:bit at the cable, with these files; the page's time passes as its own does. */
  async function plugIn(files: Readonly<Record<string, string>>) {
    const board = await simulatedBoard({ files, board: 'microbit-v2', firmware });
    plugged = board;
    const pass = (): void => {
      if (plugged !== board) return;
      vi.advanceTimersByTime(5);
      board.timer.after(5, pass);
    };
    pass();
    withSerial(() => Promise.resolve(lineOf(board)));
    return board;
  }
  /** A board as the browser shows it. */
  function lineOf({ port }: SimulatedBoard) {
    const line = {
      open: () => Promise.resolve(),
      readable: null as ReadableStream<Uint8Array> | null,
      writable: new WritableStream<Uint8Array>({ write: (bytes) => port.write(bytes) }),
      close: () => port.close(),
    };
    line.readable = new ReadableStream<Uint8Array>({
      pull: async (to) => {
        const bytes = await port.read();
        if (bytes !== null) {
          to.enqueue(bytes);
          return;
        }
        line.readable = null; // as the browser has it once a device is gone
        to.close();
      },
    });
    return line;
  }
  async function put(): Promise<void> {
    byId('real-device-put')?.click();
    await nextTick();
  }
  /** Waits while the board does its work. */
  async function turns(condition: () => boolean): Promise<void> {
    for (let turn = 0; turn < 20_000 && !condition(); turn += 1)
      await new Promise<void>((resolve) => void setImmediate(resolve));
    if (!condition()) throw new Error(`The dialog still says “${said()}”.`);
  }

  it('arrives, is checked and runs; meanwhile one sees how far it is', async () => {
    const board = await plugIn({});
    const parts: number[] = [];
    await opened();
    const watch = new MutationObserver(() => {
      const bar = document.querySelector('progress');
      if (bar !== null) parts.push(bar.value);
    });
    watch.observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
    await put();
    await turns(() => said().startsWith('Geladen'));
    watch.disconnect();
    expect(said()).toMatch(/^Geladen und geprüft\. Das Programm läuft jetzt auf dem Gerät \(.*micro:bit.*\)\.$/);
    expect(byId('real-device-said')?.className).toContain('box--ok');
    expect(textOf(document.querySelector('pre'))).toContain('hello');
    expect(board.console()).toContain('hello');
    expect(parts.length).toBeGreaterThan(1);
    expect([...parts].sort((a, b) => a - b)).toEqual(parts);
    expect(document.querySelector('progress')).toBeNull();
  });

  it('stays connected afterwards: its output goes on, it takes text, and lets go of the line for the next transfer', async () => {
    const board = await plugIn({});
    const closing = vi.spyOn(board.port, 'close');
    const { page, closed } = await opened(`${HELLO}while True:\n    print(input())\n`);
    await put();
    await turns(() => said().startsWith('Geladen'));
    const shown = realBoard(page).value;
    const text = (): string => (shown?.output ?? []).map((it) => it.text).join('');
    expect([shown?.name.value, shown?.state.value, text()]).toEqual(['micro:bit', 'connected', 'hello\n']);
    shown?.send('ping\r');
    await turns(() => /ping\s+ping/.test(text()));
    expect([closing.mock.calls.length, shown?.output.at(-1)?.timeUs]).toEqual([0, expect.any(Number)]);
    byId('serial-output')?.click();
    expect([closed(), page.layout.tab.value]).toEqual([1, 'console']);
    await shown?.disconnect();
    expect([closing.mock.calls.length, realBoard(page).value]).toEqual([1, null]);
  });

  it('asks before it replaces what is not from here; a no leaves it', async () => {
    const board = await plugIn({ 'main.py': 'print("precious")\n' });
    await opened();
    await put();
    await turns(() => byId('real-device-replace') !== null);
    expect(said()).toMatch(/^Auf dem Gerät liegt schon etwas anderes.*: main\.py\. Es ginge verloren\. Ersetzen\?$/);
    expect(buttons()).toEqual(['Behalten', 'Zuerst sichern', 'Ersetzen']);
    await press('Behalten', '.act button');
    await turns(() => byId('real-device-put') !== null);
    expect(said()).toBe('');
    unplugged();
    expect(board.type('\x03\x03\x04', 2000)).toContain('precious');
  });

  it('saves it first on demand, letter for letter, and then replaces it', async () => {
    const saved = downloads();
    await plugIn({ 'main.py': 'print("früher")\n' });
    await opened();
    await put();
    await turns(() => byId('real-device-save-first') !== null);
    byId('real-device-save-first')?.click();
    await turns(() => said().startsWith('Auf diesem Computer gesichert'));
    expect(saved.map(({ name }) => name)).toEqual(['main.py']);
    expect(await saved[0]?.blob.text()).toBe('print("früher")\n');
    expect(byId('real-device-save-first')).toBeNull();
    byId('real-device-replace')?.click();
    await turns(() => said().startsWith('Geladen'));
    expect(textOf(document.querySelector('pre'))).toContain('hello');
  });

  it('shows the device’s own words when the program stops at once', async () => {
    await plugIn({});
    await opened('print(1 / 0)\n');
    await put();
    await turns(() => said().startsWith('Geladen'));
    expect(said()).toContain('aber gleich mit einem Fehler stehen geblieben');
    expect(byId('real-device-said')?.className).toContain('box--warn');
    expect(textOf(document.querySelector('pre'))).toContain('ZeroDivisionError');
    named('Das Gerät meldet:', 'pre');
  });

  it('says that it is the wrong device where a module is missing, before anything is changed', async () => {
    await plugIn({});
    await opened('from calliopemini import *\n');
    await put();
    await turns(() => said().includes('calliopemini'));
    expect(said()).toMatch(/^Dem Gerät \(.*\) fehlt das Modul calliopemini.*Es ist nichts verändert worden\.$/);
  });

  it('says what to do when the cable comes out', async () => {
    const board = await plugIn({});
    await opened(`${HELLO}# ${'x'.repeat(2000)}\n`);
    await put();
    await turns(() => said().startsWith('main.py wird geladen'));
    board.unplug();
    await turns(() => !said().startsWith('main.py wird'));
    expect(said()).toMatch(/^Die Verbindung ist abgebrochen\. Steck das Kabel wieder ein/);
    expect(buttons().at(-1)).toBe('Nochmals laden');
  });

  it('is stopped by the button: at first nothing has happened, later no whole program is left', async () => {
    await plugIn({});
    await opened(`${HELLO}# ${'x'.repeat(2000)}\n`);
    await put();
    await turns(() => said().startsWith('Was ist schon'));
    await press('Abbrechen', '.act button');
    await turns(() => byId('real-device-put') !== null);
    expect(said()).toBe('');
    await put();
    await turns(() => said().startsWith('main.py wird geladen'));
    await press('Abbrechen', '.act button');
    await turns(() => byId('real-device-put') !== null);
    expect(said()).toBe('Abgebrochen. Auf dem Gerät ist kein ganzes Programm mehr: Lade nochmals.');
  });

  it('is stopped by closing the dialog: the line is free again', async () => {
    const board = await plugIn({});
    const closing = vi.spyOn(board.port, 'close');
    const { closed } = await opened();
    await put();
    await turns(() => said().startsWith('Was ist schon'));
    byId('real-device-close')?.click();
    expect(closed()).toBe(1);
    await turns(() => closing.mock.calls.length > 0);
  });

  it('says what helps when the device never answers', async () => {
    const close = vi.fn(() => Promise.resolve());
    const port = {
      open: () => Promise.resolve(),
      readable: new ReadableStream<Uint8Array>(),
      writable: new WritableStream<Uint8Array>(),
      close,
    };
    withSerial(() => Promise.resolve(port));
    await opened();
    byId('real-device-put')?.click();
    await flushPromises();
    expect(said()).toBe('Das laufende Programm wird angehalten …');
    for (let seconds = 0; seconds < 60 && said().startsWith('Das laufende'); seconds += 1)
      await vi.advanceTimersByTimeAsync(1000);
    expect(said()).toMatch(/^Das Gerät antwortet nicht\. Prüfe das Kabel/);
    expect(close).toHaveBeenCalled();
  });
});
