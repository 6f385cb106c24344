import { readdir, rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { consoleIn, on, pasteProgram, programIn } from './page';
import { by, gone, until } from './parts';
import { build, withMouse } from './pupil';
import { filesOfVisit, openHost, release, type Host } from './release';
import { savedFiles, watchSaving } from './transfer';

/** The files of the app are fetched once the page has nothing more urgent to do. */
const KEPT_WITHIN_MS = 60_000;

test.use({ serviceWorkers: 'allow' });
test.describe.configure({ mode: 'parallel' }); // each has a host of its own, and waits more than it works

let host: Host;

test.afterEach(() => host.close());

/** The host of what changes with a new version, whatever number of files it has. */
const openSmallHost = async (app: App): Promise<Host> => openHost(await filesOfVisit(app));

/** Opens the app and waits until its files are kept. */
async function visit(app: App): Promise<void> {
  await app.goto(host.url);
  await until(app, on('editor'));
  await expect.poll(() => isServed(app), { timeout: KEPT_WITHIN_MS }).toBe(true);
}

const isServed = (app: App): Promise<boolean> =>
  app.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    return navigator.serviceWorker.controller !== null && registration?.active?.state === 'activated';
  });

/** The state of an update that was looked for. */
const lookForUpdate = (app: App): Promise<string> =>
  app.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    if (!registration) return 'none';
    await registration.update().catch(() => undefined);
    const { installing } = registration;
    if (installing) {
      await new Promise<void>((done) => {
        installing.addEventListener('statechange', () => {
          if (installing.state !== 'installing') done();
        });
      });
    }
    return registration.waiting === null ? 'none' : 'waiting';
  });

const title = (app: App): Promise<string> => app.evaluate(() => document.title);

async function runs(app: App, text: string): Promise<void> {
  await pasteProgram(app, `print("${text}")`);
  await app.click(on('run'));
  await expect.poll(() => consoleIn(app)).toContain(text);
}

test('after one visit everything works without a network', async ({ app }) => {
  test.setTimeout(180_000);
  host = await openHost();
  await visit(app);
  await host.cut();
  await app.reload();
  await until(app, on('editor'));
  await runs(app, 'without a network');
  for (const [language, word] of [
    ['fr', 'Simuler'],
    ['it', 'Simula'],
  ] as const) {
    await app.evaluate((to) => {
      const settings = JSON.parse(sessionStorage.getItem('parcours.settings') ?? '{}') as object;
      sessionStorage.setItem('parcours.settings', JSON.stringify({ ...settings, language: to }));
    }, language);
    await app.reload();
    await expect.poll(() => app.text(on('run'))).toContain(word);
  }
  for (const gallery of ['robots', 'courses']) {
    await app.goto(`${host.url}#${gallery}`);
    await until(app, '.gallery li');
    await app.click(by('gallery-close'));
    await gone(app, '.gallery');
  }
  expect(await programIn(app)).toContain('without a network');
  const pupil = withMouse(app);
  await build(app);
  await pupil.chooseTool('pen');
  await pupil.draw([[300, 450], [500, 470], [700, 450]]); // prettier-ignore
  await watchSaving(app);
  await app.press('Control', 's');
  await expect.poll(async () => (await savedFiles(app)).map(({ text }) => text).join()).toContain('without a network');
  expect((await savedFiles(app))[0]?.text).toContain('stroke');
});

test('a new version asks before it comes, and keeps the work', async ({ app }) => {
  test.setTimeout(180_000);
  host = await openSmallHost(app);
  await visit(app);
  await pasteProgram(app, '# work of today');
  await release(host, 'v2');
  expect(await lookForUpdate(app)).toBe('waiting');
  await until(app, by('page-bar-update'));
  await app.click(by('page-bar-close'));
  await gone(app, by('page-bar-update'));
  await app.reload();
  await until(app, on('editor'));
  expect(await title(app)).toBe('Parcours');
  await until(app, by('page-bar-update'));
  await app.click(by('page-bar-act'));
  await expect.poll(() => title(app).catch(() => ''), { timeout: 30_000 }).toBe('Parcours v2');
  await until(app, on('editor'));
  await expect.poll(() => programIn(app)).toBe('# work of today');
  await expect.poll(() => keptAssets(app)).toEqual({ second: true, first: false });
  await host.cut();
  await app.reload();
  await until(app, on('editor'));
  await runs(app, 'second version');
});

/** The versions whose files are stored. */
const keptAssets = (app: App): Promise<{ second: boolean; first: boolean }> =>
  app.evaluate(async () => {
    const urls: string[] = [];
    for (const name of await caches.keys()) {
      for (const { url } of await (await caches.open(name)).keys()) if (url.includes('/assets/')) urls.push(url);
    }
    const isSecond = (url: string): boolean => /-v2[\w-]{4,6}\.\w+$/.test(url);
    return { second: urls.some(isSecond), first: !urls.every(isSecond) };
  });

test(
  'of two pages one may take the new version: the other goes on with all of its own, and is asked in its turn',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(180_000);
    host = await openSmallHost(app);
    await writeFile(
      join(host.folder, 'two.html'),
      '<title>Two</title>' +
        ['a', 'b']
          .map((id) => `<iframe id="${id}" src="./?flag=sw" style="width:1200px;height:380px"></iframe>`)
          .join(''),
    );
    const inPage = (id: string, css: string): Promise<boolean> =>
      app.inFrame(`#${id}`, (selector) => document.querySelector(selector) !== null, css);
    const press = (id: string, css: string): Promise<void> =>
      app.inFrame(`#${id}`, (selector) => document.querySelector<HTMLElement>(selector)?.click(), css);
    const titleOf = (id: string): Promise<string> => app.inFrame(`#${id}`, () => document.title).catch(() => '');
    await app.goto(`${host.url}two.html`);
    for (const id of ['a', 'b']) await expect.poll(() => inPage(id, on('editor'))).toBe(true);
    await expect.poll(() => isServed(app), { timeout: KEPT_WITHIN_MS }).toBe(true);

    await release(host, 'v2');
    expect(await lookForUpdate(app)).toBe('waiting');
    for (const id of ['a', 'b']) await expect.poll(() => inPage(id, by('page-bar-update'))).toBe(true);
    await press('a', by('page-bar-act'));
    await expect.poll(() => titleOf('a')).toBe('Parcours v2');
    await expect.poll(() => inPage('a', on('editor'))).toBe(true);

    await expect.poll(() => inPage('b', by('page-bar-update'))).toBe(true);
    expect(await titleOf('b')).toBe('Parcours');
    expect(await keptAssets(app)).toEqual({ second: true, first: true });
    await app.inFrame('#b', () => (location.hash = '#robots')); // comes late: the host has that file no more
    await expect.poll(() => inPage('b', '.gallery li')).toBe(true);
    await press('b', by('page-bar-act'));
    await expect.poll(() => titleOf('b')).toBe('Parcours v2');
  },
);

test('a half-finished update changes nothing, and the next try brings it', IN_ONE_ENGINE, async ({ app }) => {
  test.setTimeout(180_000);
  host = await openSmallHost(app);
  await visit(app);
  await release(host, 'v2');
  const assets = join(host.folder, 'assets');
  const [lost] = (await readdir(assets)).filter((name) => name.startsWith('vm-'));
  if (lost === undefined) throw new Error('There is no VM.');
  await rename(join(assets, lost), join(host.folder, lost));
  expect(await lookForUpdate(app)).toBe('none');
  await app.reload();
  await until(app, on('editor'));
  expect(await title(app)).toBe('Parcours');
  await rename(join(host.folder, lost), join(assets, lost));
  await expect.poll(() => lookForUpdate(app), { timeout: 30_000 }).toBe('waiting');
  await host.cut();
  await app.reload();
  await until(app, on('editor'));
  await runs(app, 'first version');
});
