import { readFile } from 'node:fs/promises';

import LZString from 'lz-string';

import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { appAddress, consoleInFrame, hostPage, isInFrame, pressInFrame, type HostPage } from './hosts';
import { sampleHost, serveHost } from './hosts/webtigerpython/sample-host';
import { consoleIn, isThere, on, programIn } from './page';

/** The messages that the host page received. */
interface Heard {
  readonly type: string;
  readonly data: unknown;
}
declare const heard: readonly Heard[];
declare function post(type: string, data?: unknown): void;
declare function runProgram(source: string): Promise<void>;
declare function runAtOnce(source: string): void;

const PROGRAM = 'for i in range(3):\n    print("number", i)\n';

let host: Pick<HostPage, 'url' | 'close'> | null = null;
test.afterEach(() => {
  host?.close();
  host = null;
});

/** Opens a worksheet of another site with WebTigerPython's address changed to ours. */
async function openWorksheet(app: App, address = ''): Promise<void> {
  const page = await readFile('e2e/hosts/webtigerpython/host.html', 'utf8');
  host = await hostPage(page.replace('{{address}}', appAddress() + address));
  await app.goto(host.url);
}

const messages = (app: App): Promise<readonly Heard[]> => app.evaluate(() => heard);
const said = async (app: App, type: string): Promise<readonly unknown[]> =>
  (await messages(app)).filter((message) => message.type === type).map(({ data }) => data);
const printed = async (app: App): Promise<string> => (await said(app, 'output')).join('');
const untilOver = (app: App, runs = 1): Promise<void> =>
  expect.poll(async () => (await said(app, 'full_output')).length).toBe(runs);

test('a worksheet for WebTigerPython runs its programs when only the address is changed', async ({ app }) => {
  await openWorksheet(app);
  await app.evaluate((source) => runProgram(source), PROGRAM);
  await untilOver(app);
  expect(await printed(app)).toBe('number 0\nnumber 1\nnumber 2\n');
  expect(await said(app, 'full_output')).toEqual(['number 0\nnumber 1\nnumber 2\n']);
  expect(await said(app, 'code')).toEqual([[{ name: 'main.py', data: PROGRAM }]]);
  expect((await messages(app)).map(({ type }) => type).slice(-2)).toEqual(['full_output', 'program_finished']);
  expect((await messages(app)).every((message) => Object.keys(message).join() === 'type,data')).toBe(true);
  // Once more, with an error in it.
  await app.evaluate((source) => runProgram(source), 'print("before")\nprint(1 / 0)\n');
  await untilOver(app, 2);
  expect(await printed(app)).toBe('number 0\nnumber 1\nnumber 2\nbefore\n');
  const [error] = await said(app, 'error');
  expect(error).toMatch(/^Traceback \(most recent call last\):\n {2}File "main.py", line 2/);
  expect(error).toContain('ZeroDivisionError');
});

test('a worksheet that waits for nothing is served as well', IN_ONE_ENGINE, async ({ app }) => {
  await openWorksheet(app);
  await app.evaluate((source) => {
    // Again and again, from before the page is there until it is.
    const timer = setInterval(() => runAtOnce(source), 100);
    addEventListener('message', ({ data }: MessageEvent<Heard>) => {
      if (data.type === 'code') clearInterval(timer);
    });
  }, PROGRAM);
  await expect.poll(async () => (await said(app, 'full_output')).at(-1)).toBe('number 0\nnumber 1\nnumber 2\n');
  await app.evaluate((source) => runAtOnce(source), 'while True:\n    pass\n');
  await expect.poll(async () => JSON.stringify((await said(app, 'code')).at(-1))).toContain('while True');
  await app.evaluate((source) => runAtOnce(source), 'print("after")\n');
  await expect.poll(async () => (await said(app, 'full_output')).at(-1)).toBe('after\n');
});

test('a worksheet that sends its program once, when the frame has loaded, finds it in the editor', async ({ app }) => {
  // As most public pages do it: nobody waits for `pythonReady`.
  await openWorksheet(app, '?lang=fr');
  const program = (): Promise<string> =>
    app.inFrame('iframe', () => document.querySelector('.code-editor .cm-content')?.textContent ?? '');
  await expect.poll(program).toBe('print("with load")');
  await pressInFrame(app, 'button.run');
  await untilOver(app);
  expect(await said(app, 'code')).toEqual([[{ name: 'main.py', data: 'print("with load")' }]]);
  expect(await said(app, 'full_output')).toEqual(['with load\n']);
});

test('who presses Run or Stop in the frame is heard by the worksheet', IN_ONE_ENGINE, async ({ app }) => {
  await openWorksheet(app);
  await expect.poll(async () => (await said(app, 'pythonReady')).length).toBe(1);
  await app.evaluate(() => post('files', 'while True:\n    print("on")\n    import time\n    time.sleep(1)\n'));
  await expect.poll(() => isInFrame(app, 'button.run')).toBe(true);
  await pressInFrame(app, 'button.run');
  await expect.poll(() => printed(app)).toContain('on\n');
  expect(await said(app, 'code')).toHaveLength(1);
  await pressInFrame(app, 'button.stop');
  await untilOver(app);
  expect(await said(app, 'error')).toEqual([]);
});

test('a worksheet sets language, colours, panes and microcomputer by message', IN_ONE_ENGINE, async ({ app }) => {
  await openWorksheet(app, '?lang=en');
  await expect.poll(async () => (await said(app, 'pythonReady')).length).toBe(1);
  await app.evaluate(() =>
    post('settings', { lang: 'fr', dark_mode: true, device: 'Calliope mini 3', layout: ['Canvas'], garden: 7 }),
  );
  await expect.poll(() => app.inFrame('iframe', () => document.documentElement.lang)).toMatch(/^fr/);
  await expect.poll(() => isInFrame(app, '[data-theme=dark]')).toBe(true);
  await expect.poll(() => isInFrame(app, '.pane-code:not([style*="none"])')).toBe(false);
  expect(await isInFrame(app, '.pane-arena')).toBe(true);
  expect(await isInFrame(app, '[data-testid=device][aria-label*="Calliope mini 3"]')).toBe(true);
  await app.evaluate(() => post('settings', { hide_topbar: true, layout: '["Editor",["Canvas","Console"]]' }));
  await expect.poll(() => isInFrame(app, '.pane-code:not([style*="none"])')).toBe(true);
  expect(await isInFrame(app, 'header.top')).toBe(false);
});

/** A link's `code` as WebTigerPython makes it. */
const codeOf = (data: string): string =>
  LZString.compressToBase64(JSON.stringify([{ name: 'main.py', data }]))
    .replaceAll('+', '-')
    .replaceAll('/', '_');

test(
  'links of WebTigerPython open stopped, with the source shown, in the query and behind #?',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const code = codeOf('print("from a link")');
    const fs = LZString.compressToBase64(JSON.stringify({ 'main.py': 'print("from a link")' })).replaceAll('+', '-').replaceAll('/', '_'); // prettier-ignore
    for (const link of [`./?lang=en&code=${code}`, `./?lang=en#?code=${code}&run=true`, `./?lang=en#?fs=${fs}`]) {
      await app.goto('about:blank'); // another fragment alone loads nothing
      await app.goto(link);
      await expect.poll(() => programIn(app)).toContain('from a link');
      await expect.poll(() => app.evaluate(() => location.search + location.hash)).not.toMatch(/code=|fs=/);
      expect(await app.evaluate(() => location.search)).toBe('?lang=en');
      expect(await consoleIn(app)).not.toContain('from a link');
      expect(await isThere(app, `${on('run')}:not([disabled])`)).toBe(true);
    }
    // Even one that would hide it; and a reload still shows it.
    await app.goto('about:blank');
    await app.goto(`./?show=arena&lang=en#?code=${codeOf('print("hidden")')}`);
    await expect.poll(() => isThere(app, '.pane-code')).toBe(true);
    await expect.poll(() => programIn(app)).toContain('hidden');
    await expect.poll(() => app.evaluate(() => decodeURIComponent(location.search))).toContain('code');
    await app.reload();
    await expect.poll(() => programIn(app)).toContain('hidden');
  },
);

/** The effect of each parameter on the page: true once it has happened. */
const EFFECTS: readonly (readonly [address: string, isSo: () => boolean])[] = [
  ['?lang=fr', () => document.documentElement.lang.startsWith('fr')],
  ['#?lang=it-CH', () => document.documentElement.lang.startsWith('it')],
  ['?dark_mode=true', () => document.querySelector('[data-theme=dark]') !== null],
  ['?theme=dark', () => document.querySelector('[data-theme=dark]') !== null],
  ['?hide_topbar=true', () => document.querySelector('.pane-arena') !== null && !document.querySelector('header.top')],
  ['?full_screen=true', () => document.querySelector('.pane-arena') !== null && !document.querySelector('header.top, .pane-code')], // prettier-ignore
  ['?layout=["Editor","Console"]', () => document.querySelector('.pane-code .cm-content') !== null && !document.querySelector('.pane-arena')], // prettier-ignore
  ['?layout=[["Canvas"]]', () => document.querySelector('.pane-arena') !== null && !document.querySelector('.pane-console')], // prettier-ignore
  ['?show=console', () => document.querySelector('.pane-console') !== null && !document.querySelector('.pane-arena')],
  [
    '?device=Calliope%20mini%203',
    () => document.querySelector('[data-testid=device][aria-label*="Calliope mini 3"]') !== null,
  ],
  [
    '?board=calliope-mini-2',
    () => document.querySelector('[data-testid=device][aria-label*="Calliope mini 1/2"]') !== null,
  ],
  ['?robot=callibot', () => document.querySelector('[data-testid=device][aria-label*="Calliope mini 3"]') !== null],
  ['?speed=4', () => document.querySelector('header')?.textContent?.includes('4×') ?? false],
  ['?lang=en&muted=true', () => document.querySelector('[data-testid=speed][aria-label$="sound off"]') !== null],
  ['?lang=en&world=slalom', () => document.querySelector('header')?.textContent?.includes('Slalom') ?? false],
  ['?lang=en&task=slalom', () => document.querySelector('header')?.textContent?.includes('Slalom') ?? false],
];

test('each parameter of the address shows', IN_ONE_ENGINE, async ({ app }) => {
  for (const [address, isSo] of EFFECTS) {
    await app.goto('about:blank');
    await app.goto(`./${encodeURI(decodeURI(address))}`);
    await expect.poll(() => app.evaluate(isSo), { message: address }).toBe(true);
    // For this visit only.
    const stored = await app.evaluate(() => localStorage.getItem('parcours.settings') ?? '');
    expect(stored, address).not.toMatch(/"(theme|language)":"(dark|fr|it)"|"speed":4|"muted":true|calliope|callibot/);
  }
});

test('the address chooses the used robot', IN_ONE_ENGINE, async ({ app }) => {
  await app.goto('./?robot=callibot&reality=0.5&seed=42');
  await expect.poll(() => isThere(app, '[data-testid=device]')).toBe(true);
  await app.click('[data-testid=device]');
  const number = (): Promise<string> =>
    app.evaluate(() => document.querySelector<HTMLInputElement>('[data-testid=seed] input')?.value ?? '');
  await expect.poll(number).toBe('42');
});

test(
  'a page with devices has Parcours from its package: it runs, prints, stops and greys out what is not there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(240_000);
    host = await serveHost(await sampleHost());
    const isDisabled = (name: string): Promise<boolean> =>
      app.evaluate((id) => document.querySelector<HTMLButtonElement>(`[data-testid=${id}]`)?.disabled ?? false, name);
    const state = (): Promise<string> => app.text('[data-testid=state]');
    const choose = (name: string): Promise<void> =>
      app.evaluate((device) => {
        const menu = document.querySelector<HTMLSelectElement>('[data-testid=device]');
        if (menu === null) throw new Error('There is no device menu.');
        menu.value = device;
        menu.dispatchEvent(new Event('change'));
      }, name);
    const type = (text: string): Promise<void> =>
      app.evaluate((source) => {
        const editor = document.querySelector<HTMLTextAreaElement>('[data-testid=code]');
        if (editor === null) throw new Error('There is no editor.');
        editor.value = source;
        editor.dispatchEvent(new Event('input'));
      }, text);

    await app.goto(`${host.url}?parcours=${encodeURIComponent(appAddress())}`);
    await expect.poll(() => isDisabled('run')).toBe(true);
    await choose('Calliope mini 3');
    await expect.poll(state).toBe('Ready');
    expect(await Promise.all(['run', 'stop', 'send', 'export'].map(isDisabled))).toEqual([false, false, true, false]);
    await type(PROGRAM);
    await app.click('[data-testid=run]');
    await expect.poll(() => app.text('[role=log]')).toContain('number 2');
    expect(await app.text('[role=log]')).not.toContain('>>>');
    await type('from microbit import *\nwhile True:\n    display.show("A")\n    print(nonsense)\n');
    await app.click('[data-testid=run]');
    await expect.poll(() => app.text('[role=log]')).toContain('NameError');
    await type('import time\nwhile True:\n    print("on")\n    time.sleep(1)\n');
    await app.click('[data-testid=run]');
    await expect.poll(() => app.text('[role=log]')).toContain('on');
    await expect.poll(state).toBe('Running');
    await app.click('[data-testid=stop]');
    await expect.poll(state).toBe('Ready');
    expect(await consoleInFrame(app)).toBe(''); // the page has its own
    await choose('-');
    await expect.poll(() => isThere(app, 'iframe')).toBe(false);
    expect(await isDisabled('run')).toBe(true);
  },
);
