import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { attribute, consoleIn, isThere, on, openApp, pasteProgram } from './page';
import { by, gone, until } from './parts';

/** A file saved by the page: name, type, size, and for pictures their dimensions and coloured share. */
interface Saved {
  readonly name: string;
  readonly begins: string;
  readonly bytes: number;
  readonly size: readonly number[];
}

/** Notes what is saved, as bytes. */
const watchSaving = (app: App): Promise<void> =>
  app.evaluate(() => {
    const saved: Promise<unknown>[] = ((window as { kept?: Promise<unknown>[] }).kept = []);
    const blobs = new Map<string, Blob>();
    const create = URL.createObjectURL.bind(URL);
    URL.createObjectURL = (object: Blob | MediaSource) => {
      const url = create(object);
      if (object instanceof Blob) blobs.set(url, object);
      return url;
    };
    async function about(name: string, blob: Blob): Promise<unknown> {
      const bytes = new Uint8Array(await blob.arrayBuffer());
      const begins = String.fromCharCode(...bytes.slice(0, 6));
      const size: number[] = [];
      if (!name.endsWith('.pdf')) {
        const image = new Image();
        await new Promise<void>((resolve, reject) => {
          image.onload = () => resolve();
          image.onerror = () => reject(new Error(`${name} is no picture.`));
          const reader = new FileReader();
          reader.onload = () => (image.src = reader.result as string);
          reader.readAsDataURL(blob);
        });
        size.push(image.naturalWidth, image.naturalHeight);
      }
      return { name, begins, bytes: bytes.length, size };
    }
    HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
      const blob = blobs.get(this.href);
      if (this.download !== '' && blob !== undefined) saved.push(about(this.download, blob));
    };
  });
const saved = (app: App): Promise<Saved[]> =>
  app.evaluate(() => Promise.all((window as { kept?: Promise<Saved>[] }).kept ?? []));
/** The next file that is saved. */
async function next(app: App, button: string): Promise<Saved> {
  const { length } = await saved(app);
  await app.click(by(button));
  await expect.poll(async () => (await saved(app)).length, { timeout: 60_000 }).toBe(length + 1);
  return (await saved(app)).at(-1)!;
}

/** Looks back at a run of this program, and opens its pictures. */
async function openPictures(app: App, program: string): Promise<void> {
  await openApp(app);
  await pasteProgram(app, program.trimEnd());
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app), { timeout: 60_000 }).toContain('done');
  await app.click(by('mode-lookBack'));
  await until(app, by('save-run'));
  await app.click(by('save-run'));
  await until(app, by('save-run-pictures'));
  await app.click(by('save-run-pictures'));
  await until(app, `${by('strip-preview')} canvas`);
}

const DRIVE = `from mbrobot import *
setSpeed(40)
forward()
delay(1000)
rightArc(0.3)
delay(1000)
stop()
print("done")
`;
const focus = (app: App, id: string): Promise<void> =>
  app.evaluate((css) => document.querySelector<HTMLElement>(css)?.focus(), by(id));
const at = async (app: App, id: string): Promise<number> => Number(await attribute(app, by(id), 'aria-valuenow'));

test('a run becomes a strip of pictures, as PNG and on a sheet of paper', async ({ app }) => {
  await openPictures(app, DRIVE);
  expect(await violationsOn(app)).toEqual([]);
  await watchSaving(app);
  const six = await next(app, 'strip-png');
  expect(six.name).toMatch(/\.run\.png$/);
  expect(six.begins.slice(1, 4)).toBe('PNG');
  expect(six.size[0]).toBeGreaterThan(2100); // three of 720 px side by side
  expect(six.size[0]).toBeLessThan(2400);
  const sheet = await next(app, 'strip-pdf');
  expect([sheet.name.slice(-8), sheet.begins.slice(0, 5)]).toEqual(['.run.pdf', '%PDF-']);
});

test('a stretch of a run becomes a film in two sizes, and can be given up', IN_ONE_ENGINE, async ({ app }) => {
  await openPictures(app, DRIVE);
  await app.click(by('print-film'));
  await until(app, `${by('film-preview')} canvas`);
  await focus(app, 'stretch-toUs');
  const endMs = await at(app, 'stretch-toUs');
  await app.press('ArrowLeft');
  expect(await at(app, 'stretch-toUs')).toBe(endMs - 20);
  await focus(app, 'stretch-fromUs');
  await app.press('ArrowRight');
  expect(await at(app, 'stretch-fromUs')).toBe(20);
  expect(await violationsOn(app)).toEqual([]);
  await watchSaving(app);
  const small = await next(app, 'film-save');
  expect([small.name.slice(-8), small.begins, Math.max(...small.size)]).toEqual(['.run.gif', 'GIF89a', 360]);
  await until(app, by('film-save'));
  await app.click(by('film-large'));
  const large = await next(app, 'film-save');
  expect(Math.max(...large.size)).toBe(720);
  expect(large.bytes).toBeGreaterThan(small.bytes);
  await until(app, by('film-save'));
  await app.evaluate(
    ({ save, cancel }) => {
      document.querySelector<HTMLElement>(save)?.click();
      const timer = setInterval(() => {
        const button = document.querySelector<HTMLElement>(cancel);
        button?.click();
        if (button) clearInterval(timer);
      });
    },
    { save: by('film-save'), cancel: by('film-cancel') },
  );
  await gone(app, by('film-cancel'));
  await until(app, by('film-save'));
  expect(await saved(app)).toHaveLength(2);
});

test('a film that would be too long says so', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { speed: 'max' });
  await pasteProgram(app, 'from mbrobot import *\nleft()\ndelay(40000)\nstop()\nprint("done")');
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app), { timeout: 60_000 }).toContain('done');
  await app.click(by('mode-lookBack'));
  await until(app, by('save-run'));
  await app.click(by('save-run'));
  await until(app, by('save-run-pictures'));
  await app.click(by('save-run-pictures'));
  await until(app, by('print-film'));
  await app.click(by('print-film'));
  await until(app, `${by('film-preview')} canvas`);
  expect(await isThere(app, by('film-problem'))).toBe(false); // its last half minute is chosen
  await focus(app, 'stretch-fromUs');
  await app.press('Home');
  await until(app, by('film-problem'));
  expect(await attribute(app, by('film-save'), 'disabled')).not.toBe(null);
});
