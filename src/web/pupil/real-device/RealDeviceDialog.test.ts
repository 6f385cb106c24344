// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { HexBoard } from '#hex/firmware';
import { readHex } from '#hex/read';
import { firmwareText } from '#hex/testing/firmware';

import { downloads } from '../../app/testing/downloads';
import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { firmwareModel } from './firmware/firmware-model';
import RealDeviceDialog from './RealDeviceDialog.vue';

/** A browser with these interfaces, from which a device is chosen. */
function browserWith(interfaces: { readonly serial?: SerialChoice; readonly usb?: object }): void {
  const { serial, usb } = interfaces;
  if (serial) Object.defineProperty(navigator, 'serial', { configurable: true, value: { requestPort: serial } });
  if (usb) Object.defineProperty(navigator, 'usb', { configurable: true, value: usb });
}
type SerialChoice = (wish: { readonly filters?: readonly unknown[] }) => Promise<unknown>;
/** A frame that allows none of it. */
const inFrame = () => Object.defineProperty(document, 'featurePolicy', { configurable: true, value: { allowsFeature: () => false } }); // prettier-ignore
/** A device whose cable comes out as soon as something is sent. */
const pulledOut = () => ({
  open: () => Promise.resolve(),
  close: () => Promise.resolve(),
  readable: null,
  writable: null,
});
/** A USB whose list of devices is closed without a choice. */
const emptyUsb = {
  getDevices: () => Promise.resolve([]),
  requestDevice: () => Promise.reject(Object.assign(new Error('No device selected.'), { name: 'NotFoundError' })),
  addEventListener: () => undefined,
  removeEventListener: () => undefined,
};

interface Given {
  readonly files?: Readonly<Record<string, string>>;
  /** Boards whose MicroPython is at hand. */
  readonly firmwares?: readonly HexBoard[];
}
/** The dialog on a project. */
async function dialog({ files = { 'main.py': 'print(1)\n' }, firmwares = [] }: Given = {}) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  const list = Object.entries(files).map(([name, text]) => ({ name, text }));
  page.work.openProject({ files: list, scene: page.work.scene.value, course: null }, null);
  for (const board of firmwares) await give(page, board);
  const closed = vi.fn();
  mountOn(page, RealDeviceDialog, { onClose: closed });
  await vi.waitFor(() => expect(ways()).not.toEqual([]));
  return { page, closed };
}
const give = (page: TestPage, board: HexBoard) => firmwareModel(page).take(new Blob([firmwareText(board)]));
/** Saves the hex, and waits until it is written. */
async function save(): Promise<void> {
  await tap('hex-save');
  await vi.waitFor(() => expect(byId('hex-save').hasAttribute('disabled')).toBe(false));
}
/** The ways in their order, the open one with a star. */
const ways = (): readonly string[] =>
  [...document.querySelectorAll<HTMLElement>('.way')].map(
    (way) => (way.dataset['testid'] ?? '').replace('way-', '') + (way.matches('.way--open') ? '*' : ''),
  );
const names = (): readonly string[] =>
  [...byId('real-device-files').querySelectorAll('.name')].map((name) => textOf(name));

beforeEach(() => void vi.stubGlobal('fetch', () => Promise.reject(new Error('There is no web server.'))));
afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  Reflect.deleteProperty(navigator, 'serial');
  Reflect.deleteProperty(navigator, 'usb');
  Reflect.deleteProperty(document, 'featurePolicy');
});

describe('the dialog for the real board', () => {
  it('opens the best way and shows the others in a line each; a press opens another', async () => {
    browserWith({ usb: emptyUsb, serial: () => Promise.resolve(null) });
    await dialog({ firmwares: ['microbit-v2'] });
    expect(ways()).toEqual(['usb*', 'hex', 'serial']);
    await tap('way-serial');
    expect(ways()).toEqual(['usb', 'hex', 'serial*']);
    expect(document.activeElement?.id).toBe('way-serial');
  });

  it('says in one sentence what to do where there is no MicroPython for the board, and goes on once it is given', async () => {
    browserWith({ usb: emptyUsb, serial: () => Promise.resolve(null) });
    const { page } = await dialog();
    expect(ways()).toEqual(['firmware*', 'serial']);
    expect(textOf(byId('way-firmware'))).toContain('Wirf hier eine .hex-Datei hinein');
    await give(page, 'microbit-v2');
    await nextTick();
    expect(ways()).toEqual(['usb*', 'hex', 'serial']);
  });

  it('says what is wrong with a file that is given for it', async () => {
    await dialog();
    const field = byId('firmware-file') as HTMLInputElement;
    const giveFile = (text: string): void => {
      Object.defineProperty(field, 'files', { configurable: true, value: [new File([text], 'a.hex')] });
      field.dispatchEvent(new Event('change'));
    };
    giveFile('print(1)');
    await vi.waitFor(() => expect(textOf(byId('firmware-problem'))).toBe('Das ist keine .hex-Datei.'));
    giveFile(firmwareText('calliope-mini-3'));
    await vi.waitFor(() => expect(textOf(byId('firmware-problem'))).toContain('MicroPython für Calliope mini 3'));
    expect(ways()).toEqual(['firmware*', 'usb']);
  });

  it('is for the board that is chosen in its head', async () => {
    const { page } = await dialog({ firmwares: ['microbit-v2'] });
    await tap('real-device-board');
    await tap('board-calliope-mini-3');
    await vi.waitFor(() => expect(ways()).toEqual(['firmware*', 'usb']));
    expect(textOf(byId('way-firmware'))).toContain('MicroPython für Calliope mini 3');
    await give(page, 'calliope-mini-3');
    await nextTick();
    expect(textOf(byId('hex-steps'))).toContain('Laufwerk MINI');
  });

  it('lists the MicroPython that is kept: it is saved for a server, or removed, after which it is asked for', async () => {
    const saved = downloads();
    await dialog({ firmwares: ['microbit-v2', 'calliope-mini-3'] });
    await tap('real-device-trouble');
    expect(byId('kept-firmwares').querySelectorAll('li')).toHaveLength(2);
    await tap('firmware-save');
    await vi.waitFor(() => expect(saved.map(({ name }) => name)).toEqual(['firmware.zip']));
    await tap('firmware-remove-microbit-v2');
    await vi.waitFor(() => expect(ways()[0]).toBe('firmware*'));
  });

  it('says in a frame that it is not allowed there and how it can be, and offers the file', async () => {
    browserWith({ usb: emptyUsb, serial: () => Promise.resolve(null) });
    inFrame();
    await dialog({ firmwares: ['microbit-v2'] });
    expect(ways()).toEqual(['hex*', 'usb']);
    expect(textOf(byId('way-usb'))).toContain('allow="usb; serial"');
    expect(textOf(byId('way-usb'))).toContain('hier gesperrt');
  });
});

describe('a program saved as a hex', () => {
  it('has a short name of plain letters, and holds the program for all boards at hand', async () => {
    const saved = downloads();
    await dialog({
      files: { 'main.py': 'import mbled\n', 'helfer.py': '' },
      firmwares: ['microbit-v2', 'microbit-v1'],
    });
    await save();
    expect(saved.map(({ name }) => name)).toEqual([expect.stringMatching(/^[a-z0-9-]+\.hex$/)]);
    const read = readHex((await saved[0]?.blob.text()) ?? '');
    expect(read.kind === 'hex' && [read.made, read.files.map(({ name }) => name).sort()]).toEqual([
      'universal',
      ['helfer.py', 'main.py', 'mbled.py'],
    ]);
    expect(textOf(byId('hex-said'))).toContain('micro:bit V1, micro:bit V2');
    expect(textOf(byId('hex-said'))).toContain('Leere Dateien haben eine leere Zeile bekommen: helfer.py.');
  });

  it('is not saved when it is too large, and says by how much', async () => {
    const saved = downloads();
    await dialog({ files: { 'main.py': `#${'x'.repeat(30_000)}` }, firmwares: ['microbit-v2'] });
    await save();
    expect(saved).toEqual([]);
    expect(textOf(byId('hex-problem'))).toMatch(
      /^Das Programm ist [\d’']+ Bytes zu gross\. ?Kürz, was gross ist: main\.py\.$/,
    );
  });

  it('is offered first the next time, as the way that worked last', async () => {
    browserWith({ usb: emptyUsb });
    downloads();
    const { page } = await dialog({ firmwares: ['microbit-v2'] });
    await tap('way-hex');
    await save();
    mountOn(page, RealDeviceDialog);
    await vi.waitFor(() => expect(ways().slice(-3)).toEqual(['hex*', 'usb', 'serial']));
  });
});

describe('single files', () => {
  it('are listed, the libraries first and main.py last, with their sizes in bytes', async () => {
    await dialog({ files: { 'main.py': `from callibot import *\nimport helper\n#${'ü'.repeat(1000)}`, 'helper.py': 'x = 1\n' } }); // prettier-ignore
    await tap('real-device-single');
    expect(names().at(-1)).toBe('main.py');
    const tagged = [...byId('real-device-files').querySelectorAll('li')].filter((item) => item.querySelector('.tag') !== null); // prettier-ignore
    const libraries = tagged.map((item) => textOf(item.querySelector('.name')));
    expect(libraries).toContain('callibot.py');
    expect(libraries).not.toContain('helper.py');
    expect(textOf(byId('real-device-files').querySelector('li:last-child .num'))).toBe('2.0 kB');
  });

  it('are saved one by one, or all as a ZIP where there are several', async () => {
    const saved = downloads();
    await dialog({ files: { 'main.py': 'import helper\n', 'helper.py': 'x = 1\n' } });
    await tap('real-device-single');
    await tap(named('helper.py speichern'));
    await tap('real-device-zip');
    expect(saved.map(({ name }) => name)).toEqual(['helper.py', expect.stringMatching(/\.zip$/)]);
  });

  it('need no ZIP where there is one', async () => {
    await dialog();
    await tap('real-device-single');
    expect(isThere('real-device-zip')).toBe(false);
  });
});

describe('the program alone, over a serial line', () => {
  /** The dialog with this way open. */
  async function serialWay(serial: SerialChoice) {
    browserWith({ serial });
    const given = await dialog();
    await tap('way-serial');
    return given;
  }
  const said = (): string => textOf(byId('real-device-said'));

  it('tells the three steps, and to lift the robot before it starts', async () => {
    await serialWay(() => Promise.resolve(null));
    const steps = [...document.querySelectorAll('[data-testid="way-serial"] ol li')].map(textOf);
    expect(steps).toHaveLength(3);
    expect(steps[1]).toContain('Heb den Roboter hoch');
  });

  it('asks the browser for known boards, or for any line', async () => {
    const wishes: unknown[] = [];
    await serialWay((wish) => {
      wishes.push(wish);
      return Promise.reject(new DOMException('none', 'NotFoundError'));
    });
    await tap('real-device-put');
    await vi.waitFor(() => byId('real-device-other'));
    await tap('real-device-other');
    await vi.waitFor(() => expect(wishes).toHaveLength(2));
    expect(wishes).toEqual([{ filters: [{ usbVendorId: 0x0d28, usbProductId: 0x0204 }] }, {}]);
  });

  it('is as before when no device was chosen', async () => {
    await serialWay(() => Promise.reject(new DOMException('none', 'NotFoundError')));
    await tap('real-device-put');
    await vi.waitFor(() => expect(textOf(byId('real-device-put'))).toBe('Programm austauschen'));
    expect(said()).toBe('');
  });

  it('says, while the browser’s list is open, what to do, and can be stopped; the other ways wait', async () => {
    await serialWay(() => new Promise(() => undefined));
    await tap('real-device-put');
    expect(said()).toBe('Wähle dein Gerät in der Liste des Browsers.');
    expect(isThere('real-device-put')).toBe(false);
    expect((byId('way-firmware') as HTMLButtonElement).disabled).toBe(true);
    named('Abbrechen');
  });

  it('says so when the browser refuses only on the press', async () => {
    await serialWay(() => Promise.reject(new DOMException('no', 'SecurityError')));
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('allow="serial"'));
  });

  it('says that another program has the line, and offers to try again', async () => {
    await serialWay(() => Promise.resolve({ ...pulledOut(), open: () => Promise.reject(new Error('in use')) }));
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('Der Anschluss ist besetzt.'));
    expect(textOf(byId('real-device-put'))).toBe('Nochmals laden');
    expect(byId('real-device-said').classList.contains('box--error')).toBe(true);
  });

  it('says that the cable is out', async () => {
    await serialWay(() => Promise.resolve(pulledOut()));
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('Die Verbindung ist abgebrochen.'));
  });

  it('lets go of a line that was opened after it was stopped', async () => {
    const close = vi.fn(() => Promise.resolve());
    let offer: (port: unknown) => void = () => undefined;
    const { closed } = await serialWay(() => new Promise((resolve) => (offer = resolve)));
    await tap('real-device-put');
    await tap('real-device-close');
    expect(closed).toHaveBeenCalledOnce();
    offer({ ...pulledOut(), close });
    await vi.waitFor(() => expect(close).toHaveBeenCalled());
  });
});
