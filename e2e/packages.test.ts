import { execFile } from 'node:child_process';
import { copyFile, readFile, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { promisify } from 'node:util';

import type { ParcoursSimulatorElement } from '../src/embed/element/define';
import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { appAddress } from './hosts';
import { plainHost } from './hosts/plain/sample-host';
import { serveHost } from './hosts/webtigerpython/sample-host';

declare const simulator: ParcoursSimulatorElement;

let host: Awaited<ReturnType<typeof serveHost>> | null = null;
test.afterEach(() => {
  host?.close();
  host = null;
});

/** Opens the sample host, which is on another site than the app that it shows. */
async function openHost(app: App, address = appAddress()): Promise<void> {
  host = await serveHost((await plainHost()).site);
  await app.goto(`${host.url}?parcours=${encodeURIComponent(address)}`);
  await expect.poll(() => app.text('#state'), { timeout: 60_000 }).toBe('Ready');
}

const printed = (app: App): Promise<string> => app.text('#console');
const setProgram = (app: App, source: string): Promise<void> =>
  app.evaluate((text) => simulator.setFiles([{ name: 'main.py', text }]), source);

test(
  'a worksheet with the element from its package: own buttons, console and verdict',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(180_000);
    await openHost(app);
    await setProgram(app, `print('off we go')\n${await readFile('courses/push/main.py', 'utf8')}`);
    await app.evaluate(() => void (simulator.speed = 'max'));
    await app.click('#run');
    await expect.poll(() => app.text('#verdict'), { timeout: 60_000 }).toBe('Well done: the block is in the field.');
    expect(await printed(app)).toContain('off we go');
    await setProgram(app, 'import time\nwhile True:\n    print("still there")\n    time.sleep(1)\n');
    await app.evaluate(() => void (simulator.speed = 1));
    await app.click('#run');
    await expect.poll(() => printed(app)).toContain('still there');
    expect(await printed(app)).not.toContain('off we go');
    await expect.poll(() => app.text('#state')).toBe('Running');
    await app.click('#stop');
    await expect.poll(() => app.text('#state')).toBe('Stopped');
    // Its height is the page's own, and it is not wider for that.
    expect(await app.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    expect(await app.evaluate(() => simulator.offsetWidth - (simulator.nextElementSibling?.clientWidth ?? 0))).toBe(0);
    // The keyboard goes in by a call, and the frame has the name that the page gives it.
    const focused = await app.evaluate(() => {
      simulator.focus();
      return [document.activeElement?.id, simulator.shadowRoot?.activeElement?.getAttribute('title')];
    });
    expect(focused).toEqual(['simulator', 'The course and your program']);
  },
);

test(
  'attributes reach the page that is there, work stays when the element moves, and goes with it',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(180_000);
    await openHost(app, `${appAddress()}simulator.html`); // keeps nothing by itself
    const before = await app.evaluate(async () => {
      Object.assign(simulator, {
        theme: 'dark',
        show: 'board,console',
        speed: 4,
        seed: 42,
        robot: 'none',
        muted: true,
      });
      simulator.lang = 'it';
      const [{ language, theme, parts, muted }, { speed, seed }] = [
        await simulator.getSettings(),
        await simulator.getState(),
      ];
      return { language, theme, parts, muted, speed, seed, page: (await simulator.whenReady()).welcome.page };
    });
    expect(before).toMatchObject({ language: 'it', theme: 'dark', muted: true, speed: 4, seed: 42 });
    expect(before.parts).toEqual(['board', 'console']);
    const after = await app.evaluate(async () => {
      simulator.removeAttribute('muted');
      simulator.removeAttribute('speed');
      await simulator.setFiles([{ name: 'main.py', text: '# mine' }]);
      const { muted } = await simulator.getSettings();
      const { speed } = await simulator.getState();
      const { page } = (await simulator.whenReady()).welcome;
      await new Promise((done) => setTimeout(done, 1500)); // a pupil pauses
      const corner = document.createElement('aside');
      document.body.append(corner);
      corner.append(simulator);
      const [file] = await simulator.getFiles();
      const settings = await simulator.getSettings();
      return {
        muted,
        speed,
        page,
        text: file?.text,
        theme: settings.theme,
        moved: (await simulator.whenReady()).welcome.page,
      };
    });
    expect(after).toMatchObject({ muted: false, speed: 1, page: before.page, text: '# mine', theme: 'dark' });
    expect(after.moved).not.toBe(before.page);
    const gone = await app.evaluate(async () => {
      const element = simulator; // by its id it is known only while it is on the page
      await element.run();
      const late = element.getState().then(
        () => 'answered',
        (error: unknown) => (error as { readonly code: string }).code,
      );
      await Promise.resolve(); // on its way
      element.remove();
      return [await late, element.frame === null];
    });
    expect(gone).toEqual(['closed', true]);
  },
);

test('two elements on a page, one of them in a sandbox, each with a program of its own', async ({ app }) => {
  test.setTimeout(180_000);
  await openHost(app);
  const texts = await app.evaluate(async (src) => {
    const second = document.createElement('parcours-simulator');
    Object.assign(second, { sandboxed: true, show: 'console', loading: 'eager', src });
    second.files = [{ name: 'main.py', text: 'print("in a sandbox")' }];
    const heard = { first: '', second: '' };
    simulator.addEventListener('output', ({ detail }) => (heard.first += detail.text));
    second.addEventListener('output', ({ detail }) => (heard.second += detail.text));
    const ended = (element: HTMLElement): Promise<Event> =>
      new Promise((done) => element.addEventListener('ended', done, { once: true }));
    document.body.append(second);
    await simulator.setFiles([{ name: 'main.py', text: 'print("as usual")' }]);
    const both = [ended(simulator), ended(second)];
    await Promise.all([simulator.run(), second.run()]);
    await Promise.all(both);
    const { src: address, allow } = second.frame ?? {};
    return { ...heard, address, allow, sandbox: second.frame?.getAttribute('sandbox') };
  }, appAddress());
  expect(texts.first).toMatch(/^as usual\r?\n/);
  expect(texts.second).toMatch(/^in a sandbox\r?\n/);
  expect(texts.first + texts.second).not.toMatch(/sandbox[^]*usual|usual[^]*sandbox[^]*usual/);
  expect(texts.address).toMatch(/\/parcours\.single\.html\?show=console&/);
  expect(texts.sandbox).toBe('allow-scripts');
  expect(texts.allow).toContain('usb; serial');
});

test('an element loads when it comes into view, with its project, and has the work again when its page is loaded anew', async ({
  app,
}) => {
  test.setTimeout(180_000);
  await openHost(app);
  const seen = await app.evaluate(async (src) => {
    const project = await simulator.getProject();
    const file = { ...project, files: [{ name: 'main.py', text: '# of the project' }] };
    simulator.remove();
    const far = document.createElement('parcours-simulator');
    far.id = 'far';
    Object.assign(far.style, { marginTop: '5000px', height: 'auto' });
    far.setAttribute('project', URL.createObjectURL(new Blob([JSON.stringify(file)])));
    Object.assign(far, { src, show: 'code' });
    document.body.append(far);
    await new Promise((done) => setTimeout(done, 300));
    const before = far.frame;
    const ready = new Promise((done) => far.addEventListener('parcours-ready', done, { once: true }));
    far.scrollIntoView();
    await ready;
    const loaded = far.frame;
    far.world = 'tour';
    far.world = null; // as before: no reason to reload
    await new Promise((done) => setTimeout(done, 50));
    const isSame = loaded === far.frame;
    const [first] = await far.getFiles();
    await far.setFiles([{ name: 'main.py', text: '# of the pupil' }]);
    await new Promise((done) => setTimeout(done, 1500)); // a pupil pauses
    const again = new Promise((done) => far.addEventListener('parcours-restarted', done, { once: true }));
    const { frame } = far;
    if (frame !== null) frame.src = `${src}simulator.html?dialect=none`; // where nothing is kept
    await again;
    const [second] = await far.getFiles();
    const refused = new Promise<unknown>((done) =>
      far.addEventListener('parcours-error', ({ detail }) => done(detail)),
    );
    far.project = '{ "no": "project" }';
    const { code } = (await refused) as { readonly code: string };
    const box = far.getBoundingClientRect();
    return {
      isLazy: before === null,
      isSame,
      first: first?.text,
      second: second?.text,
      code,
      ratio: box.width / box.height,
    };
  }, appAddress());
  expect(seen).toMatchObject({
    isLazy: true,
    isSame: true,
    first: '# of the project',
    second: '# of the pupil',
    code: 'wrong-document',
  });
  expect(seen.ratio).toBeCloseTo(1.6, 1);
});

test(
  'an element says which of its attributes make no sense, at the start and later, and goes on without them',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(180_000);
    await openHost(app);
    const told = await app.evaluate(async (src) => {
      const element = document.createElement('parcours-simulator');
      const heard: string[] = [];
      element.addEventListener('parcours-error', ({ detail }) => {
        const { code, path } = detail as { readonly code: string; readonly path: string };
        heard.push(`${code} ${path}`);
      });
      const wrong = {
        ...{ speed: '3', theme: 'pink', lang: 'xx', show: 'zzz', 'snapshot-hz': '9999', loading: 'soon', seed: '0' },
        ...{ task: 'nope', world: 'nope', robot: 'cat', board: 'dog', reality: '2' },
      };
      const set = (): void => {
        for (const [name, value] of Object.entries(wrong)) element.setAttribute(name, value);
      };
      set();
      element.setAttribute('src', 'javascript:0');
      document.body.append(element);
      element.whenReady().catch(() => undefined);
      const ofAddress = heard.splice(0);
      element.src = src;
      await element.whenReady();
      const atStart = heard.splice(0).sort();
      for (const name of Object.keys(wrong)) element.removeAttribute(name);
      await element.whenReady();
      const right = { speed: '4', theme: 'dark', lang: 'it', show: 'board', seed: '7', robot: 'none', task: 'push' };
      for (const [name, value] of Object.entries(right)) element.setAttribute(name, value);
      await element.whenReady();
      await element.getState();
      const ofRight = heard.splice(0);
      element.setAttribute('speed', '3');
      element.setAttribute('robot', 'cat');
      const { speed } = await element.getState();
      const { robot } = await element.getRobot();
      element.remove();
      return { ofAddress, atStart, ofRight, later: heard, speed, robot, wrong: Object.keys(wrong).sort() };
    }, appAddress());
    expect(told.ofAddress).toEqual(['wrong-attribute src']);
    expect(told.atStart).toEqual(told.wrong.map((name) => `wrong-attribute ${name}`));
    expect(told.ofRight).toEqual([]);
    expect(told.later.sort()).toEqual(['wrong-attribute robot', 'wrong-attribute speed']);
    expect(told).toMatchObject({ speed: 1, robot: 'auto' });
  },
);

test(
  'the packages bring the app, its licences and types that hold without the repository',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.skip(app.engine !== 'chromium', 'nothing of it is the browser’s');
    test.setTimeout(180_000);
    const { folder, site } = await plainHost();
    for (const file of ['index.html', 'simulator.html', 'parcours.single.html', 'sw.js', 'LICENSES.txt'])
      expect((await readFile(join(site, 'parcours', file))).equals(await readFile(join('dist/app', file)))).toBe(true);
    expect(await readFile(join(site, 'parcours/LICENSES.txt'), 'utf8')).toContain('Damien P. George');
    expect(await readFile(join(site, 'parcours/parcours.single.html'), 'utf8')).toContain('Damien P. George');
    await copyFile('e2e/hosts/plain/consumer.ts.txt', join(folder, 'consumer.ts'));
    const wishes = {
      target: 'ES2022',
      module: 'ESNext',
      moduleResolution: 'bundler',
      lib: ['ES2023', 'DOM'],
      strict: true,
    };
    const options = { ...wishes, exactOptionalPropertyTypes: true, skipLibCheck: false, noEmit: true, types: [] };
    await writeFile(
      join(folder, 'tsconfig.json'),
      JSON.stringify({ compilerOptions: options, files: ['consumer.ts'] }),
    );
    const told = await promisify(execFile)(process.execPath, [
      resolve('node_modules/typescript/bin/tsc'),
      '-p',
      folder,
    ]).catch((error: unknown) => error as { readonly stdout: string });
    expect(told.stdout).toBe('');
  },
);
