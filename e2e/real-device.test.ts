import type * as Testing from '../src/web/pupil/real-device/serial/testing/simulated-board';
import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { boardInNode } from './in-node';
import { openApp, pasteProgram, programIn } from './page';
import { by, gone, until } from './parts';
import { dropFile, giveFirmware, savedFiles, watchSaving } from './transfer';

interface Cable {
  /** The bytes sent by the page since the last call. */
  take(): number[];
  /** The device sends this. */
  give(bytes: readonly number[]): void;
  pull(): void;
}

type WithCable = Window & { cable?: Cable };

/** Gives the page serial lines in any engine; the only device is the one at the other end of `cable`. */
const plugIn = (app: App): Promise<void> =>
  app.evaluate(() => {
    const sent: number[] = [];
    let send: ReadableStreamDefaultController<Uint8Array> | null = null;
    let isOut = false;
    const port = {
      readable: null as ReadableStream | null,
      writable: null as WritableStream | null,
      open: (): Promise<void> => {
        port.readable = new ReadableStream<Uint8Array>({ start: (controller) => void (send = controller) });
        port.writable = new WritableStream<Uint8Array>({
          write: (bytes) => {
            if (isOut) throw new DOMException('The device has been lost.', 'NetworkError');
            sent.push(...bytes);
          },
        });
        return Promise.resolve();
      },
      close: (): Promise<void> => {
        if (port.readable?.locked === true || port.writable?.locked === true) throw new TypeError('locked');
        port.readable = port.writable = null;
        return Promise.resolve();
      },
    };
    (window as WithCable).cable = {
      take: () => sent.splice(0),
      give: (bytes) => send?.enqueue(Uint8Array.from(bytes)),
      pull: () => {
        isOut = true;
        send?.error(new DOMException('The device has been lost.', 'NetworkError'));
        port.readable = null;
      },
    };
    Object.defineProperty(navigator, 'serial', {
      configurable: true,
      value: { requestPort: () => Promise.resolve(port) },
    });
  });

/** Lets the board and the page talk until something is on the page. */
async function talkUntil(app: App, board: Testing.SimulatedBoard, css: string): Promise<void> {
  await expect(async () => {
    const { sent, isThere } = await app.evaluate(
      (wanted) => ({
        sent: (window as WithCable).cable?.take() ?? [],
        isThere: document.querySelector(wanted) !== null,
      }),
      css,
    );
    const answer = board.type(String.fromCharCode(...sent), 30);
    if (answer !== '') {
      const bytes = Array.from(new TextEncoder().encode(answer));
      await app.evaluate((came) => (window as WithCable).cable?.give(came), bytes);
    }
    expect(isThere).toBe(true);
  }).toPass({ intervals: [5], timeout: 60_000 });
}

const said = (app: App): Promise<string> => app.text(by('real-device-said'));

async function openDialog(app: App): Promise<void> {
  await app.click(by('menu'));
  await until(app, by('menu-real-device'));
  await app.click(by('menu-real-device'));
  await until(app, by('way-serial'));
  await app.click(by('way-serial'));
  await until(app, by('real-device-put'));
}

const PROGRAM = 'from microbit import *\nimport mbled\nprint("on the board:", len(dir(mbled)) > 0)';

test('a program goes onto the device with its library, is checked, and runs there', IN_ONE_ENGINE, async ({ app }) => {
  test.slow(); // a page and a board talk over a cable that a driver of browsers has to carry
  const board = await boardInNode({ 'main.py': 'while True: pass' });
  await openApp(app, { language: 'en' });
  await pasteProgram(app, PROGRAM);
  await plugIn(app);
  await openDialog(app);
  expect(await violationsOn(app), 'before').toEqual([]);
  await app.click(by('real-device-put'));
  await talkUntil(app, board, by('real-device-replace'));
  expect(await said(app)).toContain('main.py');
  expect(await violationsOn(app), 'with the question').toEqual([]);
  await watchSaving(app);
  await app.click(by('real-device-save-first'));
  await talkUntil(app, board, `${by('real-device-dialog')}:not(:has(${by('real-device-save-first')}))`);
  expect(await savedFiles(app)).toEqual([{ name: 'main.py', text: 'while True: pass' }]);
  await app.press('Enter'); // the keyboard stands on the first answer: nothing is lost by it
  await talkUntil(app, board, by('real-device-put'));
  expect(board.type('\x03', 500)).toContain('>>>');

  await app.click(by('real-device-put'));
  await talkUntil(app, board, by('real-device-replace'));
  await app.click(by('real-device-replace'));
  await talkUntil(app, board, `${by('real-device-dialog')} pre`);
  expect(await said(app)).toMatch(/Loaded and checked.*runs on the device \(micro:bit/);
  expect(await app.text(`${by('real-device-dialog')} pre`)).toContain('on the board: True');
  expect(await violationsOn(app), 'after').toEqual([]);
  expect(board.type('\x03import os\rprint(sorted(os.listdir()))\r')).toContain("['main.py', 'mbled.py']");

  // Once more, by the keyboard: nothing has changed, and nobody is asked about what came from here.
  await expect.poll(() => app.evaluate(() => document.activeElement?.getAttribute('data-testid'))).toBe('real-device-put'); // prettier-ignore
  await app.press('Enter');
  await gone(app, `${by('real-device-dialog')} pre`);
  await talkUntil(app, board, `${by('real-device-dialog')} pre`);
  expect(await said(app)).toContain('There already: mbled.py, main.py');
});

test('a cable that is pulled out is told, with what to do', IN_ONE_ENGINE, async ({ app }) => {
  const board = await boardInNode({});
  await openApp(app, { language: 'de' });
  await plugIn(app);
  await openDialog(app);
  await app.click(by('real-device-put'));
  await talkUntil(app, board, `${by('real-device-dialog')} progress[value="0.08"], ${by('real-device-dialog')} progress:not([value="0"])`); // prettier-ignore
  await app.evaluate(() => (window as WithCable).cable?.pull());
  await expect.poll(() => said(app)).toMatch(/Verbindung ist abgebrochen.*Steck das Kabel wieder ein/);
});

test('a browser without USB and serial lines says so, and saves the files', async ({ app }) => {
  await openApp(app, { language: 'fr' });
  await pasteProgram(app, PROGRAM);
  await watchSaving(app);
  await app.evaluate(() => {
    for (const name of ['serial', 'usb'])
      if (name in navigator) Object.defineProperty(navigator, name, { configurable: true, value: undefined });
  });
  await app.click(by('menu'));
  await until(app, by('menu-real-device'));
  await app.click(by('menu-real-device'));
  await until(app, by('way-usb'));
  expect(await app.text(by('way-usb'))).toMatch(/sur un ordinateur avec Chrome ou Edge/);
  await app.click(by('real-device-single'));
  await until(app, by('real-device-zip'));
  await app.click(by('real-device-zip'));
  await app.click(`${by('real-device-files')} li:last-child button`);
  const saved = await savedFiles(app);
  expect(saved.map(({ name }) => name.split('.').pop())).toEqual(['zip', 'py']);
  expect(saved[0]?.text).toMatch(/^PK[^]*mbled\.py[^]*main\.py/);
  expect(saved[1]).toEqual({ name: 'main.py', text: PROGRAM });
});

test('a program saved as a hex opens again from it', { tag: '@chromium' }, async ({ app }) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM);
  await watchSaving(app);
  await app.click(by('menu'));
  await until(app, by('menu-real-device'));
  await app.click(by('menu-real-device'));
  await until(app, by('way-serial'));
  await giveFirmware(app);
  await until(app, by('way-hex'));
  await app.click(by('way-hex'));
  await until(app, by('hex-save'));
  await app.click(by('hex-save'));
  await expect.poll(() => app.text(by('hex-said'))).toMatch(/\.hex/);
  const hex = (await savedFiles(app)).at(-1);
  expect(hex?.name).toMatch(/^[a-z-]+\.hex$/);
  await app.click(by('real-device-close'));
  await pasteProgram(app, 'print("something else")\n');
  await dropFile(app, hex ?? { name: '', text: '' });
  await expect.poll(() => programIn(app)).toBe(PROGRAM);
});
