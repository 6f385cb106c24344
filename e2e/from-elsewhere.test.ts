import { linkSamples } from '../src/project/webtigerpython/testing/links';
import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { isThere, openApp, programIn } from './page';
import { by, gone, until } from './parts';

test.use({ viewport: { width: 1366, height: 625 } });

const [sample] = linkSamples;
if (sample === undefined) throw new Error('There is no link.');
const address = sample.link.slice(sample.link.indexOf('#'));
/** True if two parts of the page have no place in common. */
const areApart = (app: Parameters<typeof programIn>[0], one: string, other: string): Promise<boolean> =>
  app.evaluate(
    (css) => {
      const [a, b] = [css.one, css.other].map((it) => document.querySelector(it)?.getBoundingClientRect());
      if (a === undefined || b === undefined) return false;
      return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
    },
    { one, other },
  );

test(
  'a link of WebTigerPython opens with its card; its loop is taken back and done again; a link leads back there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await app.goto(`./${address}`);
    await until(app, by('brought-changed'));
    const marked = () => app.evaluate(() => document.querySelector('.cm-changedLine')?.textContent ?? '');
    await expect.poll(marked).toBe('while True:');
    expect(await areApart(app, by('brought'), by('editor'))).toBe(true);
    expect(await areApart(app, by('brought'), '.pane-arena')).toBe(true);

    await app.click(by('brought-take-back'));
    await expect.poll(() => programIn(app)).toBe(sample.program);
    await gone(app, by('brought-changed'));
    await app.press('Control', 'z');
    await expect.poll(marked).toBe('while True:');

    await app.click(by('brought-close'));
    await gone(app, by('brought'));
    expect(await isThere(app, '.cm-changedLine')).toBe(false);
    await app.click(by('share'));
    await until(app, by('share-elsewhere'));
    await app.click(`${by('share-elsewhere')} summary`);
    await until(app, by('elsewhere-link'));
    const link = await app.evaluate(
      (css) => document.querySelector<HTMLInputElement>(css)?.value ?? '',
      by('elsewhere-link'),
    );
    expect(link).toMatch(/^https:\/\/webtigerpython\.ethz\.ch\/#\?code=.*&device=micro%3Abit&playground=/);
  },
);
