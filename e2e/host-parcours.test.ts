import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import type { HostPage } from './hosts';
import { parcoursHost } from './hosts/parcours/host-page';

const opened: HostPage[] = [];
test.afterEach(() => {
  for (const host of opened.splice(0)) host.close();
});

/** Opens a host page and waits until its client is there. */
async function openHost(app: App, ...page: Parameters<typeof parcoursHost>): Promise<void> {
  const host = await parcoursHost(...page);
  opened.push(host);
  await app.goto(host.url);
  await app.evaluate(async () => {
    while (!('connect' in globalThis)) await new Promise((resolve) => setTimeout(resolve, 50));
  });
}

/** Notes what goes wrong in the page of the frame from now on. */
const watchErrors = (app: App): Promise<void> =>
  app.inFrame('#parcours', () => {
    const errors: string[] = [];
    Object.assign(globalThis, { errors });
    addEventListener('error', (event) => errors.push(event.message));
    addEventListener('unhandledrejection', (event) => errors.push(String(event.reason)));
  });

const errorsOf = (app: App): Promise<readonly string[]> =>
  app.inFrame('#parcours', () => (globalThis as unknown as { errors: string[] }).errors);

const TALKING = `from microbit import *
import radio
radio.on()
print('light', display.read_light_level())
radio.send('hi')
name = input('name? ')
print('hello', name)
while not button_a.was_pressed():
    sleep(10)
1/0
`;

test('a host page on another site runs a program, talks with it and hears how it ends', async ({ app }) => {
  await openHost(app);
  const heard = await app.evaluate(async (main) => {
    const frame = document.querySelector<HTMLIFrameElement>('#parcours')!;
    const parcours = await connect(frame, { client: 'a test', subscribe: { snapshotHz: 20 } });
    let output = '';
    const names: string[] = [];
    for (const name of ['started', 'phase', 'snapshot', 'radio', 'ended'] as const) parcours.on(name, () => names.push(name)); // prettier-ignore
    parcours.on('output', ({ text }) => void (output += text));
    const ended = new Promise<object>((resolve) => parcours.on('ended', resolve));
    const radio = new Promise<object>((resolve) => parcours.on('radio', resolve));
    const until = async (text: string): Promise<void> => {
      while (!output.includes(text)) await new Promise((resolve) => setTimeout(resolve, 20));
    };
    await parcours.setRobot({ robot: 'none', device: 'microbit-v2' });
    await parcours.setFiles([{ name: 'main.py', text: main }]);
    await parcours.setSensor('lightLevel', 40);
    await parcours.run();
    await until('name? ');
    await parcours.serial('Ada\r');
    await until('hello Ada');
    const state = await parcours.getState();
    await parcours.press('a', true);
    await new Promise((resolve) => setTimeout(resolve, 200)); // a finger takes its time
    await parcours.press('a', false);
    const end = await ended;
    await parcours.stop();
    const stopped = await parcours.getState();
    parcours.close();
    return { output, names: [...new Set(names)], radio: await radio, state, end, phase: stopped.phase };
  }, TALKING);
  expect(heard.output).toContain('light 40');
  expect(heard.radio).toMatchObject({ packets: [{ text: 'hi' }] });
  expect(heard.state).toMatchObject({
    phase: 'running',
    ended: null,
    board: 'microbit-v2',
    sensors: { lightLevel: 40 },
  });
  expect(heard.end).toMatchObject({
    ended: 'exception',
    exception: { type: 'ZeroDivisionError', line: 10 },
    robot: null,
  });
  expect([...heard.names].sort()).toEqual(['ended', 'phase', 'radio', 'snapshot', 'started']);
  expect(heard.phase).toBe('stopped');
});

test('a host page brings a course, lets the robot drive on it and changes it meanwhile, over a port', async ({
  app,
}) => {
  await openHost(app);
  const heard = await app.evaluate(async () => {
    const parcours = await connect(document.querySelector<HTMLIFrameElement>('#parcours')!, { usePort: true });
    const scene = {
      format: 'parcours-scene',
      version: 2,
      name: 'From a host',
      robot: { at: [300, 450], heading: 0 },
      objects: [
        { type: 'target', id: 'goal', at: [700, 450], size: [300, 300] },
        { type: 'block', id: 'box', at: [100, 100], size: [50, 50] },
      ],
    } as const;
    const main = 'from mbrobot import *\nforward()\nwhile True:\n    delay(10)\n';
    const refused = await parcours
      .setProject({ format: 'parcours-project', version: 1, files: [{ name: 'main.py', text: main }] } as never)
      .catch((error: unknown) => ({ ...(error as object) }));
    await parcours.setProject({ format: 'parcours-project', version: 1, files: [{ name: 'main.py', text: main }], scene }); // prettier-ignore
    await parcours.setSpeed('max');
    await parcours.setSeed(3);
    await parcours.setReality(0.2);
    await parcours.setArenaSenses(true);
    await parcours.setSettings({ language: 'fr', theme: 'dark', muted: true, labels: { 'button-a': 'Bouton A' } });
    let changes = 0;
    parcours.on('scene-changed', () => (changes += 1));
    await parcours.subscribe({ snapshotHz: 60 });
    await parcours.run();
    const passed = new Promise<object>((resolve) =>
      parcours.on('snapshot', ({ snapshot }) => snapshot.verdict?.state === 'passed' && resolve(snapshot)),
    );
    const snapshot = await passed;
    await parcours.pause();
    const atMs = (await parcours.getState()).atMs;
    await parcours.step();
    await new Promise((resolve) => setTimeout(resolve, 300));
    const stepped = (await parcours.getState()).atMs - atMs;
    await parcours.place({ xMm: 600, yMm: 300, headingDeg: 90 });
    await parcours.placeBlock('box', { xMm: 200, yMm: 200, headingDeg: 0 });
    await parcours.edit({ type: 'add', objects: [{ type: 'label', id: 'l', at: [600, 800], text: 'Hi', height: 40, angle: 0 }] }); // prettier-ignore
    await parcours.resume();
    await parcours.interrupt();
    const ended = await new Promise<object>((resolve) => parcours.on('ended', resolve));
    await parcours.reset();
    const result = {
      refused,
      snapshot,
      stepped,
      changes,
      ended,
      scene: await parcours.getScene(),
      project: await parcours.getProject(),
      settings: await parcours.getSettings(),
      robot: await parcours.getRobot(),
      state: await parcours.getState(),
    };
    parcours.close();
    return result;
  });
  expect(heard.refused).toMatchObject({ code: 'wrong-document' });
  expect(heard.snapshot).toMatchObject({
    robot: { type: 'maqueen-lite' },
    verdict: { targets: { reached: 1, of: 1 } },
  });
  expect(heard.stepped).toBeGreaterThanOrEqual(20);
  expect(heard.changes).toBeGreaterThan(0);
  expect(heard.ended).toMatchObject({ ended: 'stopped' });
  expect(heard.scene.objects?.map(({ id }) => id)).toEqual(['goal', 'box', 'l']);
  expect(heard.project).toMatchObject({ format: 'parcours-project', settings: { seed: 3, reality: 0.2, arenaSenses: true } }); // prettier-ignore
  expect(heard.settings).toMatchObject({ language: 'fr', theme: 'dark', muted: true });
  expect(heard.robot).toMatchObject({ robot: 'auto', device: 'auto' });
  expect(heard.state).toMatchObject({ phase: 'ready', snapshot: null, speed: 'max' });
});

test('the client notices that the frame was loaded anew', IN_ONE_ENGINE, async ({ app }) => {
  await openHost(app);
  const heard = await app.evaluate(async () => {
    const frame = document.querySelector<HTMLIFrameElement>('#parcours')!;
    const parcours = await connect(frame);
    const before = parcours.welcome.page;
    const restarted = new Promise<{ page: string }>((resolve) => parcours.on('restarted', resolve));
    const { src } = frame;
    frame.src = src;
    const after = (await restarted).page;
    const state = await parcours.getState();
    parcours.close();
    return { isAnother: before !== after, phase: state.phase };
  });
  expect(heard).toEqual({ isAnother: true, phase: 'ready' });
});

test('pages that may not command the page are not heard', async ({ app }) => {
  await openHost(app, '?lang=en&dialect=none&origin=https://school.example');
  const code = await app.evaluate(() =>
    connect(document.querySelector<HTMLIFrameElement>('#parcours')!, { timeoutMs: 4000 }).then(
      () => 'connected',
      (error: unknown) => (error as { code: string }).code,
    ),
  );
  expect(code).toBe('timeout');
});

/** A frame beside the app that posts to it what it can. */
const SIBLING = `<iframe id="sibling" srcdoc="<script>
  setInterval(() => {
    for (const [index] of [0, 1, 2].entries()) {
      const other = parent.frames[index];
      other.postMessage({ parcours: 1, id: 1, type: 'hello' }, '*');
      other.postMessage({ parcours: 1, id: 2, type: 'set-files', files: [{ name: 'main.py', text: 'sibling' }] }, '*');
      other.postMessage({ type: 'files', data: [{ name: 'main.py', data: 'sibling' }] }, '*');
    }
  }, 50);
</script>"></iframe>`;

test('whatever a hostile host and its other frames send, nothing breaks and the page stays usable', async ({ app }) => {
  await openHost(app, '?lang=en&dialect=none', SIBLING);
  await app.evaluate(async () => {
    const parcours = await connect(document.querySelector<HTMLIFrameElement>('#parcours')!);
    Object.assign(globalThis, { parcours });
  });
  await watchErrors(app);
  const heard = await app.evaluate(async () => {
    const page = document.querySelector<HTMLIFrameElement>('#parcours')!.contentWindow!;
    const { parcours } = globalThis as unknown as { parcours: Awaited<ReturnType<typeof connect>> };
    const text = 'print(6 * 7)';
    await parcours.setFiles([{ name: 'main.py', text }]);
    const cyclic: { self?: object } = {};
    cyclic.self = cyclic;
    const polluted = JSON.parse('{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}}}') as object;
    const all: unknown[] = [
      null,
      1,
      'x',
      [],
      cyclic,
      polluted,
      new Map([[cyclic, cyclic]]),
      new Uint8Array(1000),
      new Date(),
    ];
    for (const data of all) {
      page.postMessage(data, '*');
      for (const type of ['set-project', 'set-scene', 'edit', 'set-robot', 'settings', 'hello', '__proto__', data])
        page.postMessage({ parcours: 1, id: 'x', type, project: data, scene: data, edit: data, robotOptions: data, labels: data, session: data }, '*'); // prettier-ignore
    }
    page.postMessage({ parcours: 1, id: 'big', type: 'set-scene', scene: 'x'.repeat(20_000_000) }, '*');
    page.postMessage({ parcours: 1, id: 'bits', type: 'edit', edit: new Array(3_000_000).fill(0) }, '*');
    const buffer = new ArrayBuffer(1_000_000);
    page.postMessage({ parcours: 1, id: 'gone', type: 'set-project', project: buffer }, '*', [buffer]);
    for (let times = 0; times < 20; times += 1) {
      const { port1, port2 } = new MessageChannel();
      page.postMessage({ parcours: 1, id: 1, type: 'hello', session: String(times) }, '*', [port2]);
      port1.postMessage({ parcours: 1, id: 2, type: 'run' });
      if (times % 2 === 0) port1.close();
    }
    parcours.close();
    const again = await connect(document.querySelector<HTMLIFrameElement>('#parcours')!);
    await again.stop();
    const files = await again.getFiles();
    let output = '';
    again.on('output', (data) => void (output += data.text));
    await again.run();
    while (!output.includes('42')) await new Promise((resolve) => setTimeout(resolve, 20));
    again.close();
    return { files, isPolluted: 'polluted' in {} };
  });
  expect(heard).toEqual({ files: [{ name: 'main.py', text: 'print(6 * 7)' }], isPolluted: false });
  expect(await app.inFrame('#parcours', () => 'polluted' in {})).toBe(false);
  expect(await errorsOf(app)).toEqual([]);
});
