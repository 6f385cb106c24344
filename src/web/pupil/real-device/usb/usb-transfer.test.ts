// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { firmwareText } from '#hex/testing/firmware';

import { byId, tap } from '../../../app/testing/find';
import { mountOn, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { realBoard } from '../../../session/run/board/real-board';
import { firmwareModel } from '../firmware/firmware-model';
import RealDeviceDialog from '../RealDeviceDialog.vue';
import { FakeBoard, type FakeStart } from './testing/fake-board';

/** The dialog, with MicroPython for the micro:bit V2 at hand and this board at the USB. */
async function dialog(start: FakeStart) {
  const fake = new FakeBoard(start);
  Object.defineProperty(navigator, 'usb', { configurable: true, value: fake.usb });
  const page = createPage();
  page.settings.change({ language: 'de' });
  page.work.setText('main.py', 'print("on the board")\n');
  await firmwareModel(page).take(new Blob([firmwareText('microbit-v2')]));
  const closed = vi.fn();
  mountOn(page, RealDeviceDialog, { onClose: closed });
  await vi.waitFor(() => byId('usb-put'));
  return { page, fake, closed };
}

beforeEach(() => void vi.stubGlobal('fetch', () => Promise.reject(new Error('There is no web server.'))));
afterEach(() => {
  vi.unstubAllGlobals();
  Reflect.deleteProperty(navigator, 'usb');
});

describe('a program put onto a board by USB', { timeout: 60_000 }, () => {
  it('is told from stage to stage; afterwards the board stays connected, and its output can be seen', async () => {
    const { page, fake, closed } = await dialog({ says: 'on the board\r\n' });
    await tap('usb-put');
    await vi.waitFor(() => byId('usb-output'), { timeout: 30_000 });
    expect(textOf(byId('usb-said'))).toBe('Übertragen. Dein Programm läuft jetzt auf dem Gerät (micro:bit V2).');
    expect(new TextDecoder().decode(fake.flash)).toContain('print("on the board")');
    const board = realBoard(page).value;
    expect([board?.name.value, board?.state.value]).toEqual(['micro:bit V2', 'connected']);
    await vi.waitFor(() => expect(board?.output.map(({ text }) => text).join('')).toBe('on the board\r\n'));
    await tap('usb-output');
    expect(closed).toHaveBeenCalledOnce();
    expect(page.layout.tab.value).toBe('console');
    await board?.disconnect();
    expect(realBoard(page).value).toBeNull();
  });

  it('says what went wrong and the way out, and can be tried again', async () => {
    const { page } = await dialog({ boardId: '9901' });
    const words = 'Am Kabel ist ein anderes Gerät: ein micro:bit V1. Wähle oben micro:bit V1.';
    await tap('usb-put');
    await vi.waitFor(() => expect(textOf(byId('usb-problem')).replace('.Wähle', '. Wähle')).toContain(words), { timeout: 30_000 }); // prettier-ignore
    expect(textOf(byId('usb-put'))).toBe('Nochmals');
    expect(realBoard(page).value).toBeNull();
  });

  it('says nothing when no board was chosen in the browser’s list', async () => {
    await dialog({ refusal: 'nothing-chosen' });
    await tap('usb-put');
    await vi.waitFor(() => expect(textOf(byId('usb-put'))).toBe('Auf den Roboter'));
    expect(document.querySelector('[data-testid="usb-problem"]')).toBeNull();
  });
});
