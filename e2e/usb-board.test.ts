import { FakeBoard, type FakeStart } from '../src/web/pupil/real-device/usb/testing/fake-board';
import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { openApp, pasteProgram } from './page';
import { by, until } from './parts';
import { giveFirmware } from './transfer';

type WithBoard = Window & { board?: FakeBoard };

/** Gives the page a USB in any engine; a fake board is all there is at it, so that no list of true devices ever opens. */
async function plugIn(app: App, start: FakeStart = {}): Promise<void> {
  const source = `window.board = new (${String(FakeBoard)})(start);
    Object.defineProperty(navigator, 'usb', { configurable: true, value: window.board.usb });`;
  // eslint-disable-next-line @typescript-eslint/no-implied-eval -- the class goes over as its source
  await app.evaluate(new Function('start', source) as (given: FakeStart) => void, start);
}
const counts = (app: App) => app.evaluate(() => (window as WithBoard).board?.done ?? null);
const said = (app: App): Promise<string> => app.text(by('usb-said'));

/** Opens the dialog, and gives it MicroPython for the micro:bit V2 where it has none. */
async function openDialog(app: App): Promise<void> {
  await app.click(by('menu'));
  await until(app, by('menu-real-device'));
  await app.click(by('menu-real-device'));
  await until(app, '.way');
  await giveFirmware(app);
  await until(app, by('usb-put'));
}
async function put(app: App): Promise<void> {
  await app.click(by('usb-put'));
  await until(app, `${by('usb-output')}, ${by('usb-problem')}`);
}

// No other engine has WebUSB.
test(
  'a program goes onto a board by USB: as a whole, then in part; its output stands beside the console',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await pasteProgram(app, 'print("distance", 23)\n');
    await plugIn(app, { says: 'distance 23\r\n' });
    await openDialog(app);
    expect(await violationsOn(app), 'before').toEqual([]);
    await put(app);
    expect(await said(app)).toBe('Transferred. Your program now runs on the device (micro:bit V2).');
    expect(await violationsOn(app), 'after').toEqual([]);
    expect(await counts(app)).toMatchObject({ full: 1, pages: 0, asked: 1 });
    await put(app);
    await expect.poll(() => said(app)).toContain('Exactly this program was on it already');
    await app.click(by('usb-output'));
    await until(app, by('board-output'));
    await expect.poll(() => app.text(by('board-output'))).toContain('distance 23');
    expect(await violationsOn(app), 'with its output').toEqual([]);
    await app.click(by('tab-chart'));
    await expect.poll(() => app.text('.values')).toContain('distance · micro:bit V2');
    await app.click(by('tab-console'));

    await pasteProgram(app, 'print("distance", 24)\n');
    await openDialog(app);
    await put(app);
    await expect.poll(() => said(app)).toContain('Transferred.');
    expect(await counts(app)).toMatchObject({ full: 1, pages: 1, asked: 1 });
  },
);

test('each problem at the USB is told with the way out', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'de' });
  const problem = async (start: FakeStart): Promise<string> => {
    await plugIn(app, start);
    await openDialog(app);
    await put(app);
    const text = await app.text(by('usb-problem'));
    await app.click(by('real-device-close'));
    return text;
  };
  expect(await problem({ isTaken: true })).toMatch(/anderer Tab[^]*Schliess MakeCode/);
  expect(await problem({ refusal: 'forbidden' })).toMatch(/nicht freigegeben[^]*in einem eigenen Tab/);
  expect(await problem({ boardId: '1234' })).toMatch(/weder ein micro:bit[^]*anderes Gerät/);
  expect(await problem({ boardId: '9900' })).toMatch(/ein micro:bit V1[^]*Wähle oben micro:bit V1/);
  expect(await problem({ unplugsAt: 600 })).toMatch(/Kabel[^]*Steck es wieder ein/);
});

test('the USB library is fetched with the dialog, and nothing of it before', IN_ONE_ENGINE, async ({ app }) => {
  const late = () => app.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /usb-board|RealDevice/.test(name)).length); // prettier-ignore
  await openApp(app, { language: 'en' });
  await plugIn(app);
  expect(await late()).toBe(0);
  await openDialog(app);
  expect(await late()).toBeGreaterThan(1);
});
