// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { downloads } from '../../app/testing/downloads';
import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import RealDeviceDialog from './RealDeviceDialog.vue';

/** A browser with a serial line: `choose` is what its list of devices gives. */
function browserWith(choose: (wish: { readonly filters?: readonly unknown[] }) => Promise<unknown>): void {
  Object.defineProperty(navigator, 'serial', { configurable: true, value: { requestPort: choose } });
}
/** A device whose cable comes out as soon as something is sent. */
const pulledOut = () => ({
  open: () => Promise.resolve(),
  close: () => Promise.resolve(),
  readable: null,
  writable: null,
});
/** The dialog on a project with these files. */
async function dialog(files: Readonly<Record<string, string>> = { 'main.py': 'print(1)\n' }) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  const list = Object.entries(files).map(([name, text]) => ({ name, text }));
  page.work.openProject({ files: list, scene: page.work.scene.value, course: null }, null);
  const closed = vi.fn();
  mountOn(page, RealDeviceDialog, { onClose: closed });
  await nextTick();
  return { page, closed };
}
const said = (): string => textOf(byId('real-device-said'));
const names = (): readonly string[] =>
  [...byId('real-device-files').querySelectorAll('.name')].map((name) => textOf(name));

afterEach(() => {
  vi.restoreAllMocks();
  Reflect.deleteProperty(navigator, 'serial');
  Reflect.deleteProperty(document, 'featurePolicy');
});

describe('the dialog for the real device, in a browser without serial lines', () => {
  it('says where it works instead, and offers the files alone', async () => {
    await dialog();
    expect(textOf(byId('real-device-unable'))).toContain('Öffne Parcours auf einem Computer mit Chrome oder Edge');
    expect(isThere('real-device-put')).toBe(false);
    expect(names()).toEqual(['main.py']);
  });

  it('lists the libraries first and main.py last, and says which are libraries', async () => {
    await dialog({ 'main.py': 'from callibot import *\nimport helper\n', 'helper.py': 'x = 1\n' });
    expect(names().at(-1)).toBe('main.py');
    expect(names()).toContain('helper.py');
    expect(names()).toContain('callibot.py');
    const tagged = [...byId('real-device-files').querySelectorAll('li')]
      .filter((item) => item.querySelector('.tag') !== null)
      .map((item) => textOf(item.querySelector('.name')));
    expect(tagged).toContain('callibot.py');
    expect(tagged).not.toContain('helper.py');
  });

  it('says how large each file is, in bytes and not in letters', async () => {
    await dialog({ 'main.py': `#${'ü'.repeat(1000)}` });
    expect(textOf(byId('real-device-files').querySelector('.num'))).toBe('2.0 kB');
  });

  it('saves one file, or all as a ZIP', async () => {
    const saved = downloads();
    await dialog({ 'main.py': 'import helper\n', 'helper.py': 'x = 1\n' });
    await tap(named('helper.py speichern'));
    await tap('real-device-zip');
    expect(saved.map(({ name }) => name)).toEqual(['helper.py', expect.stringMatching(/\.zip$/)]);
  });

  it('offers no ZIP for a single file', async () => {
    await dialog();
    expect(isThere('real-device-zip')).toBe(false);
  });
});

describe('the dialog for the real device, in a frame', () => {
  it('says that the frame does not allow it, and how whoever runs the page can', async () => {
    browserWith(() => Promise.resolve(null));
    Object.defineProperty(document, 'featurePolicy', { configurable: true, value: { allowsFeature: () => false } });
    await dialog();
    expect(textOf(byId('real-device-unable'))).toContain('allow="serial"');
    expect(isThere('real-device-put')).toBe(false);
  });

  it('says so too when the browser refuses only on the click', async () => {
    browserWith(() => Promise.reject(new DOMException('no', 'SecurityError')));
    await dialog();
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('allow="serial"'));
  });
});

describe('the dialog for the real device, with a serial line', () => {
  it('tells the three steps, and to lift the robot before it starts', async () => {
    browserWith(() => Promise.resolve(null));
    await dialog();
    const steps = [...document.querySelectorAll('[data-testid="real-device-dialog"] ol li')].map(textOf);
    expect(steps).toHaveLength(3);
    expect(steps[1]).toContain('Heb den Roboter hoch');
  });

  it('asks the browser for known boards, or for any line', async () => {
    const wishes: unknown[] = [];
    browserWith((wish) => {
      wishes.push(wish);
      return Promise.reject(new DOMException('none', 'NotFoundError'));
    });
    await dialog();
    await tap('real-device-put');
    await vi.waitFor(() => byId('real-device-other'));
    await tap('real-device-other');
    await vi.waitFor(() => expect(wishes).toHaveLength(2));
    expect(wishes).toEqual([{ filters: [{ usbVendorId: 0x0d28, usbProductId: 0x0204 }] }, {}]);
  });

  it('is as before when no device was chosen', async () => {
    browserWith(() => Promise.reject(new DOMException('none', 'NotFoundError')));
    await dialog();
    await tap('real-device-put');
    await vi.waitFor(() => expect(textOf(byId('real-device-put'))).toBe('Aufs Gerät laden'));
    expect(said()).toBe('');
  });

  it('says, while the browser’s list is open, what to do, and can be stopped', async () => {
    browserWith(() => new Promise(() => undefined));
    await dialog();
    await tap('real-device-put');
    expect(said()).toBe('Wähle dein Gerät in der Liste des Browsers.');
    expect(isThere('real-device-put')).toBe(false);
    named('Abbrechen');
  });

  it('says that another program has the line, and offers to try again', async () => {
    browserWith(() => Promise.resolve({ ...pulledOut(), open: () => Promise.reject(new Error('in use')) }));
    await dialog();
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('Der Anschluss ist besetzt.'));
    expect(textOf(byId('real-device-put'))).toBe('Nochmals laden');
    expect(byId('real-device-said').classList.contains('box--error')).toBe(true);
  });

  it('says that the cable is out', async () => {
    browserWith(() => Promise.resolve(pulledOut()));
    await dialog();
    await tap('real-device-put');
    await vi.waitFor(() => expect(said()).toContain('Die Verbindung ist abgebrochen.'));
  });

  it('lets go of a line that was opened after it was stopped', async () => {
    const close = vi.fn(() => Promise.resolve());
    let give: (port: unknown) => void = () => undefined;
    browserWith(() => new Promise((resolve) => (give = resolve)));
    const { closed } = await dialog();
    await tap('real-device-put');
    await tap('real-device-close');
    expect(closed).toHaveBeenCalledOnce();
    give({ ...pulledOut(), close });
    await vi.waitFor(() => expect(close).toHaveBeenCalled());
  });
});
