import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { appAddress, consoleInFrame, hostPage, isInFrame, pasteInFrame, pressInFrame, type HostPage } from './hosts';

const RUN = 'button.run';
const PROGRAM = 'from microbit import *\nfor i in range(3):\n    display.show(i)\n    print("number", i)\n';

let host: HostPage | null = null;

/** Opens a page of another site with the app in a frame. */
async function openIn(app: App, sandbox: string, path: string, size = 'width:1200px;height:720px'): Promise<void> {
  host = await hostPage(
    `<script>const heard = []; addEventListener('message', ({ data }) => heard.push(data));</script><button id="before">before</button><iframe src="${appAddress()}${path}" sandbox="${sandbox}" style="display:block;border:0;${size}"></iframe><button id="after">after</button>`,
  );
  await app.goto(host.url);
}

const untilInFrame = (app: App, css: string): Promise<void> => expect.poll(() => isInFrame(app, css)).toBe(true);

/** The place of the robot in the frame, in mm from the left. */
const robotX = (app: App): Promise<number> =>
  app.inFrame('iframe', () => {
    const said = document.querySelector('[role=application] p:last-of-type')?.textContent ?? '';
    return 10 * Number(/-?[\d.]+/.exec(said)?.[0]);
  });

test.afterEach(() => {
  host?.close();
  host = null;
});

test('in a frame of another site a program runs without a tap', async ({ app }) => {
  await openIn(app, 'allow-scripts allow-same-origin', '');
  await untilInFrame(app, '.code-editor .cm-content');
  await pasteInFrame(app, PROGRAM);
  await pressInFrame(app, RUN);
  await expect.poll(() => consoleInFrame(app)).toContain('number 2');
});

test('the keyboard’s focus goes into the frame, and out of it behind its last control', async ({ app }) => {
  await openIn(app, 'allow-scripts allow-same-origin', '');
  await untilInFrame(app, '.code-editor .cm-content');
  await app.evaluate(() => {
    const passed: string[] = [];
    Object.assign(window, { passed });
    addEventListener('focusin', ({ target }) => passed.push((target as Element).id));
    document.querySelector<HTMLElement>('#before')?.focus();
  });
  await app.press('Tab');
  await expect.poll(() => app.evaluate(() => document.activeElement?.tagName)).toBe('IFRAME');
  const hasPassed = () => app.evaluate(() => (window as { passed?: string[] }).passed?.includes('after') === true);
  for (let round = 0; round < 40 && !(await hasPassed()); round += 1) {
    await app.strike(['Escape', 'Tab', 'Escape', 'Tab', 'Escape', 'Tab']); // Escape: the editor lets go of Tab
  }
  expect(await hasPassed()).toBe(true);
});

test('in a frame without an origin the single file runs a program, drives and asks nobody', async ({ app }) => {
  await openIn(app, 'allow-scripts', 'parcours.single.html');
  await untilInFrame(app, '.code-editor .cm-content');
  expect(await app.inFrame('iframe', () => self.origin)).toBe('null');
  const before = await robotX(app);
  await pressInFrame(app, RUN);
  await expect.poll(() => robotX(app)).toBeGreaterThan(before + 30);
  await pressInFrame(app, 'button.stop');
  await pasteInFrame(app, PROGRAM);
  await pressInFrame(app, RUN);
  await expect.poll(() => consoleInFrame(app)).toContain('number 2');
  expect(await app.inFrame('iframe', () => performance.getEntriesByType('resource').map(({ name }) => name))).toEqual(
    [],
  );
  expect(
    await app.inFrame('iframe', () =>
      fetch(location.href).then(
        () => 'fetched',
        () => 'refused',
      ),
    ),
  ).toBe('refused');
});

/** The messages of the frame to the page around it, in the words of one dialect: `kind` or `type`. */
const heard = (app: App, word: 'kind' | 'type', which: string): Promise<readonly unknown[]> =>
  app.evaluate(
    ([key, name]) =>
      (window.eval('heard') as Record<string, unknown>[]).filter((it) => it[key] === name).map(({ data }) => data),
    [word, which] as const,
  );

const say = (app: App, script: string): Promise<void> =>
  app.evaluate((code) => void window.eval(`frames[0].postMessage(${code}, '*')`), script);

test(
  'in a frame without an origin the single file takes the place of the micro:bit simulator',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openIn(app, 'allow-scripts', 'simulator.single.html', 'width:400px;height:330px');
    await expect.poll(() => heard(app, 'kind', 'ready')).toHaveLength(1);
    await pressInFrame(app, '.play-button');
    await expect.poll(() => heard(app, 'kind', 'request_flash')).toHaveLength(1);
    await say(app, `{ kind: 'flash', filesystem: { 'main.py': new TextEncoder().encode('print(6 * 7)') } }`);
    await expect.poll(async () => (await heard(app, 'kind', 'serial_output')).join('')).toContain('42\r\n');
    await untilInFrame(app, '#LEDsOn');
  },
);

test(
  'in a frame without an origin the single file takes the place of WebTigerPython',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openIn(app, 'allow-scripts', 'parcours.single.html');
    await expect.poll(() => heard(app, 'type', 'pythonReady')).toHaveLength(1);
    await say(app, `{ type: 'files', data: [{ name: 'main.py', data: 'print(6 * 7)' }] }`);
    await say(app, `{ type: 'run_code' }`);
    await expect.poll(async () => (await heard(app, 'type', 'output')).join('')).toContain('42');
  },
);

test('the single file says that nothing can be saved there, and throws nowhere', async ({ app }) => {
  await openIn(app, 'allow-scripts', 'parcours.single.html');
  await untilInFrame(app, '[data-testid=page-bar-no-storage]');
  await app.inFrame('iframe', () => {
    const errors: string[] = [];
    Object.assign(window, { errors });
    addEventListener('error', ({ message }) => errors.push(message));
    addEventListener('unhandledrejection', ({ reason }) => errors.push(String(reason)));
  });
  await pressInFrame(app, '[data-testid=page-bar-close]');
  await expect.poll(() => isInFrame(app, '[data-testid=page-bar-no-storage]')).toBe(false);
  for (const gallery of ['gallery', 'menu-courses']) {
    await openFromMenu(app, gallery);
    await untilInFrame(app, '.gallery h2');
    await pressInFrame(app, '[data-testid=gallery-close]');
    await expect.poll(() => isInFrame(app, '.gallery')).toBe(false);
  }
  await pressInFrame(app, '[data-testid=share]');
  await untilInFrame(app, '[data-testid=share-copy]');
  await pressInFrame(app, '[data-testid=share-copy]');
  const said = () => app.inFrame('iframe', () => document.querySelector('[data-testid=share-said]')?.textContent ?? '');
  await expect.poll(said).not.toBe('');
  await pressInFrame(app, '[data-testid=share-close]');
  await openFromMenu(app, 'menu-list-save');
  await pressInFrame(app, '[data-testid=menu-save]');
  await untilInFrame(app, '[data-testid=page-bar-may-be-refused]');
  expect(await app.inFrame('iframe', () => (window as { errors?: string[] }).errors)).toEqual([]);
});

/** Opens the main menu of the app in the frame and takes an item of it. */
async function openFromMenu(app: App, item: string): Promise<void> {
  if (item === 'menu-courses') {
    await app.inFrame('iframe', () => (location.hash = '#courses'));
    return;
  }
  await pressInFrame(app, '[data-testid=menu]');
  await untilInFrame(app, `[data-testid=${item}]`);
  await pressInFrame(app, `[data-testid=${item}]`);
}

test('the ordinary page says in one sentence why it cannot start in a frame without an origin', async ({ app }) => {
  await openIn(app, 'allow-scripts', '?lang=fr');
  const seen = (): Promise<string> => app.inFrame('iframe', () => document.body.innerText.trim());
  await expect.poll(seen).toContain('Parcours ne peut pas démarrer');
  expect(await seen()).not.toContain('Parcours cannot start');
  const isVisible = await app.inFrame('iframe', () => {
    const said = document.querySelector('.cannot-start p[lang=fr]');
    return said !== null && getComputedStyle(said).visibility === 'visible';
  });
  expect(isVisible).toBe(true);
});

test('where it can start the page never shows that sentence', async ({ app }) => {
  await app.goto('./');
  expect(await app.evaluate(() => 'cannot' in document.documentElement.dataset)).toBe(false);
  await expect.poll(() => app.evaluate(() => document.querySelector('.cannot-start') === null)).toBe(true);
});
