import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { appAddress, type HostPage } from './hosts';
import { microbitHost, printedInNode, type SimulatorOfHost } from './hosts/microbit/microbit-host';
import { serialPrograms } from './hosts/microbit/programs';

/** How the REPL greets: what comes after is not the program's. */
const BANNER = /MicroPython v\d/;

let host: HostPage | null = null;

test.afterEach(() => {
  host?.close();
  host = null;
});

/** Opens the host page with simulators in frames of another site, and waits until they are ready. */
async function open(app: App, parameters: readonly string[] = ['?color=%236c4bc1&flag=sw'], more = ''): Promise<void> {
  host = await microbitHost();
  const query = parameters
    .map((one) => `simulator=${encodeURIComponent(`${appAddress()}simulator.html${one}`)}`)
    .join('&');
  await app.goto(`${host.url}?${query}${more}`);
  for (const index of parameters.keys())
    await expect.poll(() => app.evaluate((at) => (window as never as Host).simulators?.[at]?.status ?? '', index)).toBe('connected'); // prettier-ignore
}

/** The globals that host.js sets. */
interface Host {
  readonly simulators: (SimulatorOfHost & {
    files: Record<string, string>;
    serial: string;
    flash(): void;
    send(message: object): void;
    sendRadio(text: string): void;
    configure(language: string, translations: object): void;
  })[];
}

const kept = (app: App, index = 0): Promise<SimulatorOfHost> =>
  app.evaluate((at) => {
    const { status, state, serial, radio, log, errors, kinds } = (window as never as Host).simulators[at]!;
    return { status, state, serial, radio, log, errors, kinds };
  }, index);
const serial = async (app: App, index = 0): Promise<string> => (await kept(app, index)).serial;
/** Sends plain data; bytes go by the host's own functions. */
const send = (app: App, message: object): Promise<void> =>
  app.evaluate((one) => (window as never as Host).simulators[0]!.send(one), message);

/** Brings a program without any click, as hosts with their own Run button do. */
const flash = (app: App, source: string, index = 0, more: Readonly<Record<string, string>> = {}): Promise<void> =>
  app.evaluate(
    ({ text, at, others }) => {
      const simulator = (window as never as Host).simulators[at]!;
      simulator.files = { ...others, 'main.py': text };
      simulator.serial = '';
      simulator.flash();
    },
    { text: source, at: index, others: more },
  );
/** Types on the serial line, and waits for what comes back. */
async function type(app: App, data: string, answer: RegExp): Promise<void> {
  await app.evaluate(() => void ((window as never as Host).simulators[0]!.serial = ''));
  await send(app, { kind: 'serial_input', data });
  await expect.poll(() => serial(app), JSON.stringify(data)).toMatch(answer);
}

/** True if the lights of the board are to be seen, by the name that the editor's own tests look for. */
const isLit = (app: App): Promise<boolean> =>
  app.inFrame('iframe', () => {
    const lights = document.querySelector('#LEDsOn');
    return lights !== null && getComputedStyle(lights).visibility === 'visible';
  });
/** The lights that glow, row by row, read as the official simulator has them: column by column. */
const shown = (app: App): Promise<string> =>
  app.inFrame('iframe', () => {
    const lights = Array.from(document.querySelectorAll('#LEDsOn > *'));
    const at = (x: number, y: number): string => (Number(lights[x * 5 + y]?.getAttribute('opacity')) > 0 ? '#' : '.');
    return [0, 1, 2, 3, 4].map((y) => [0, 1, 2, 3, 4].map((x) => at(x, y)).join('')).join(' ');
  });
const pressPlay = async (app: App): Promise<void> => {
  await expect.poll(() => app.inFrame('iframe', () => document.querySelector('.play-button-container .play-button') !== null)).toBe(true); // prettier-ignore
  await app.inFrame('iframe', () => document.querySelector<HTMLElement>('.play-button')?.click());
};

const BLINK = 'from microbit import *\nprint("here")\ndisplay.show("1")\nwhile True:\n    sleep(20)\n';

test('play asks the editor for its program and runs it; stop and reset do as the editor wants', async ({ app }) => {
  await open(app);
  await app.evaluate((source) => {
    (window as never as Host).simulators[0]!.files = { 'main.py': source, 'helper.py': 'x = 1' };
  }, BLINK);
  expect(await isLit(app)).toBe(false);
  await pressPlay(app);
  await expect.poll(() => isLit(app)).toBe(true);
  await expect.poll(() => serial(app)).toBe('here\r\n');
  await expect.poll(() => shown(app)).toBe('..#.. .##.. ..#.. ..#.. .###.');
  expect((await kept(app)).kinds).toEqual(['ready', 'request_flash', 'log_delete', 'serial_output']);
  expect(await app.inFrame('iframe', () => document.querySelector('.code-editor, .pane-console'))).toBe(null);
  await send(app, { kind: 'stop' });
  await expect.poll(() => isLit(app)).toBe(false);
  await expect.poll(async () => (await kept(app)).kinds.at(-1)).toBe('state_change');
  await send(app, { kind: 'reset' });
  await expect.poll(() => serial(app)).toBe('here\r\nhere\r\n');
});

test('a program that is flashed before anyone clicked runs, and a second one ends the first', async ({ app }) => {
  await open(app);
  await flash(app, BLINK);
  await expect.poll(() => serial(app)).toBe('here\r\n');
  await flash(app, 'print("second")\n');
  await expect.poll(() => serial(app)).toMatch(/^second\r\n/);
  await expect.poll(() => serial(app)).toMatch(BANNER);
  const { kinds } = await kept(app);
  expect(kinds.slice(0, 5)).toEqual(['ready', 'log_delete', 'serial_output', 'state_change', 'log_delete']);
  await send(app, { kind: 'serial_input', data: 'print(6*7)\r' });
  await expect.poll(() => serial(app)).toContain('\r\n42\r\n');
  await send(app, { kind: 'serial_input', data: '\x04' });
  await expect.poll(() => serial(app)).toMatch(/soft reboot[^]*second\r\n/);
});

test('prints exactly what the command line prints, whatever the program', IN_ONE_ENGINE, async ({ app }) => {
  test.setTimeout(300_000);
  await open(app);
  for (const program of serialPrograms) {
    const expected = printedInNode(program);
    await flash(app, program.source);
    const { typed } = program;
    if (typed) {
      await expect.poll(() => serial(app), program.name).toMatch(new RegExp(`${typed.at.replace('?', '\\?')}$`));
      await send(app, { kind: 'serial_input', data: typed.text });
    }
    // The program's own text ends where the REPL greets; after an error the board first scrolls it over its display.
    const own = async (): Promise<string> => {
      const text = (await serial(app)).replaceAll('\r\n', '\n');
      const end = program.usesRepl === true ? -1 : text.search(BANNER);
      return (end < 0 ? text : text.slice(0, end)).trimEnd();
    };
    await expect.poll(own, program.name).toBe((await expected).trimEnd());
  }
});

test(
  'sensors are what the editor sets, without an echo, and what a finger does is told',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await open(app);
    await send(app, { kind: 'set_value', id: 'temperature', value: '-3' });
    await send(app, { kind: 'set_value', id: 'lightLevel', value: 300 });
    await flash(
      app,
      'from microbit import *\nprint(temperature(), display.read_light_level())\nwhile True:\n    if button_b.was_pressed(): print("B")\n    if accelerometer.was_gesture("shake"): print("shake")\n    if pin_logo.is_touched(): print("logo")\n    sleep(20)\n',
    );
    await expect.poll(() => serial(app)).toBe('-3 127\r\n');
    // In one breath, as a host's click does.
    await send(app, { kind: 'set_value', id: 'buttonB', value: 1 });
    await send(app, { kind: 'set_value', id: 'buttonB', value: 0 });
    await expect.poll(() => serial(app)).toContain('B\r\n');
    await send(app, { kind: 'set_value', id: 'gesture', value: 'shake' });
    await expect.poll(() => serial(app)).toContain('shake\r\n');
    expect((await kept(app)).kinds).not.toContain('state_change');
    await app.inFrame('iframe', () => {
      const key = (type: string): boolean =>
        document.querySelector('#Logo')!.dispatchEvent(new KeyboardEvent(type, { key: 'Enter', bubbles: true }));
      key('keydown');
      setTimeout(() => key('keyup'), 200);
    });
    await expect.poll(() => serial(app)).toContain('logo\r\n');
    await expect.poll(async () => (await kept(app)).state['pinLogo']?.['value']).toBe(0);
    expect((await kept(app)).kinds.filter((kind) => kind === 'state_change')).toHaveLength(2);
  },
);

test(
  'what the editor holds down and sets before a program runs is so for it and outlives it',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await open(app);
    for (const [id, value] of Object.entries({
      buttonA: 1,
      pin0: '1',
      lightLevel: '33',
      soundLevel: 200,
      compassHeading: 90,
      accelerometerX: -500,
    }))
      await send(app, { kind: 'set_value', id, value });
    const reads = 'from microbit import *\nsleep(100)\nprint(button_a.is_pressed(), pin0.is_touched(), display.read_light_level(), microphone.sound_level(), compass.heading(), accelerometer.get_x())\nwhile True: sleep(20)\n'; // prettier-ignore
    const expected = 'True True 33 200 90 -500\r\n';
    await flash(app, reads);
    await expect.poll(() => serial(app)).toBe(expected);
    await send(app, { kind: 'stop' });
    await expect.poll(async () => (await kept(app)).kinds.at(-1)).toBe('state_change');
    const { state } = await kept(app);
    expect(state['buttonA']).toMatchObject({ value: 1 });
    expect(state['compassHeading']).toMatchObject({ value: 90, unit: 'deg' });
    await flash(app, reads);
    await expect.poll(() => serial(app)).toBe(expected);
    // A gesture of the editor lasts half a second and is taken back.
    await flash(app, 'from microbit import *\nprint("wait")\nwhile not accelerometer.is_gesture("freefall"): sleep(20)\nprint("falls")\nwhile accelerometer.is_gesture("freefall"): sleep(20)\nprint("lies")\n'); // prettier-ignore
    await expect.poll(() => serial(app)).toContain('wait');
    await send(app, { kind: 'set_value', id: 'gesture', value: 'freefall' });
    await expect.poll(() => serial(app)).toContain('falls');
    await send(app, { kind: 'set_value', id: 'gesture', value: 'none' });
    await expect.poll(() => serial(app)).toContain('lies');
  },
);

test(
  'the terminal of the editor interrupts, pastes, speaks the raw REPL and starts again',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await open(app);
    await flash(app, 'from microbit import *\nprint("go")\nwhile True: sleep(20)\n');
    await expect.poll(() => serial(app)).toBe('go\r\n');
    await type(
      app,
      '\x03',
      /^Traceback \(most recent call last\):\r\n {2}File "main.py", line 3[^]*KeyboardInterrupt[^]*\r\n>>> $/,
    );
    await type(app, '\x05for i in range(3):\r\n    print("p", i)\r\n\x04', /=== \r\np 0\r\np 1\r\np 2\r\n>>> $/);
    await type(app, '\x01print("raw")\x04', /raw REPL; CTRL-B to exit\r\n>OKraw\r\n\x04\x04>$/);
    await type(app, '\x02', /MicroPython v[^]*>>> $/);
    await type(app, `x = "${'ü'.repeat(2000)}"\rlen(x)\r`, /\r\n2000\r\n>>> $/);
    await type(app, '\x04', /^\r\nMPY: soft reboot\r\ngo\r\n$/);
  },
);

test('many programs in one breath end in one run of the last; flash and reset together in one run', async ({ app }) => {
  await open(app);
  await app.evaluate(() => {
    const simulator = (window as never as Host).simulators[0]!;
    for (let run = 0; run < 30; run += 1) {
      simulator.files = { 'main.py': `print("run", ${String(run)})\nwhile True: pass\n` };
      simulator.flash();
      if (run % 3 === 0) simulator.send({ kind: 'stop' });
      if (run % 4 === 0) simulator.send({ kind: 'reset' });
    }
  });
  await expect.poll(() => serial(app)).toBe('run 29\r\n');
  await app.evaluate(() => {
    const simulator = (window as never as Host).simulators[0]!;
    simulator.serial = '';
    simulator.files = { 'main.py': 'print("once")\n' };
    simulator.flash();
    simulator.send({ kind: 'reset' });
  });
  await expect.poll(() => serial(app)).toMatch(/^once\r\nMicroPython/);
});

test('files that the page cannot hold are left out and told of; the program runs', IN_ONE_ENGINE, async ({ app }) => {
  await open(app);
  const others = Object.fromEntries(
    Array.from({ length: 40 }, (_, at) => [`mod${String(at)}.py`, `x = ${String(at)}\n`]),
  );
  await flash(app, 'import mod3\nprint(mod3.x)\nimport mod39\n', 0, others);
  await expect.poll(() => serial(app)).toMatch(/^3\r\nTraceback[^]*no module named 'mod39'/);
  expect((await kept(app)).errors).toEqual([expect.stringContaining('"mod19.py" is left out')]);
  await flash(app, '#'.repeat(300_000));
  await expect.poll(async () => (await kept(app)).errors.at(-1)).toContain('main.py has 300000 bytes');
});

test('a frame that is not shown yet is ready, and runs', async ({ app }) => {
  await open(app, [''], '&hidden');
  await flash(app, 'import radio\nradio.on()\nradio.config(group=7)\nprint("unseen")\nradio.send("hi")\n');
  await expect.poll(() => serial(app)).toMatch(/^unseen\r\n/);
  await expect.poll(async () => (await kept(app)).radio).toEqual(['hi']);
  const { kinds, state } = await kept(app);
  expect(state['radio']).toEqual({ type: 'radio', enabled: true, group: 7 });
  expect(kinds.indexOf('state_change')).toBeLessThan(kinds.indexOf('radio_output'));
});

test(
  'two boards hear each other by radio, and what comes too early is lost without harm',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await open(app, ['', '']);
    await app.evaluate(() => (window as never as Host).simulators[1]!.sendRadio('too early'));
    const listen = 'import radio\nfrom microbit import *\nradio.on()\nradio.config(group=7)\nwhile True:\n    m = radio.receive()\n    if m: print("got", m)\n    sleep(20)\n'; // prettier-ignore
    await flash(app, listen, 1);
    await expect
      .poll(async () => (await kept(app, 1)).state['radio'])
      .toEqual({ type: 'radio', enabled: true, group: 7 });
    await flash(app, 'import radio\nradio.on()\nradio.config(group=7)\nradio.send("hallo")\n');
    await expect.poll(() => serial(app, 1)).toBe('got hallo\r\n');
    expect((await kept(app)).radio).toEqual(['hallo']);
  },
);

test('the data log comes row by row, and is empty after a flash', IN_ONE_ENGINE, async ({ app }) => {
  await open(app);
  const logs = 'import log\nfrom microbit import *\nlog.set_labels("x")\nfor i in range(3): log.add(x=i)\nlog.add(y=9)\n'; // prettier-ignore
  await flash(app, logs);
  await expect.poll(async () => (await kept(app)).log.rows.length).toBe(4);
  const { log } = await kept(app);
  expect(log.headings.slice(1)).toEqual(['x', 'y']);
  expect(log.headings[0]).toMatch(/^Time/);
  expect(log.rows.map((row) => row[1])).toEqual(['0', '1', '2', '']);
  await flash(app, 'import log\nlog.add(z=1)\n');
  await expect.poll(async () => (await kept(app)).log.headings).toContain('z');
  expect((await kept(app)).log.rows).toHaveLength(1);
  // Full, and after the next flash not any more.
  await flash(app, 'import log\ntry:\n  while True: log.add(a="x" * 200)\nexcept OSError:\n  print("full")\n');
  await expect.poll(() => serial(app)).toContain('full');
  const isFull = async (): Promise<unknown> => (await kept(app)).state['dataLogging']?.['logFull'];
  await expect.poll(isFull).toBe(true);
  await flash(app, 'import log\nlog.add(a=1)\nlog.delete()\nprint("empty")\n');
  await expect.poll(() => serial(app)).toContain('empty');
  await expect.poll(isFull).toBe(false);
  await expect.poll(async () => (await kept(app)).log).toEqual({ headings: [], rows: [] });
});

test('language, words and sound are the editor’s', IN_ONE_ENGINE, async ({ app }) => {
  await open(app);
  const say = (language: string, translations: object): Promise<void> =>
    app.evaluate((one) => (window as never as Host).simulators[0]!.configure(one.language, one.translations), {
      language,
      translations,
    });
  const label = (css: string): Promise<string> =>
    app.inFrame('iframe', (selector) => document.querySelector(selector)?.getAttribute('aria-label') ?? '', css);
  await say('fr', { 'button-a': 'Bouton A', 'start-simulator': 'Démarrer' });
  await expect.poll(() => label('#ButtonA')).toBe('Bouton A');
  expect(await label('.play-button')).toBe('Démarrer');
  await expect.poll(() => app.inFrame('iframe', () => document.documentElement.lang)).toMatch(/^fr/); // its texts come late
  await send(app, { kind: 'mute' });
  await flash(app, 'import music\nmusic.play("c4:1")\nprint("muted")\n');
  await expect.poll(() => serial(app)).toContain('muted');
  await send(app, { kind: 'unmute' });
  for (const nonsense of [
    null,
    5,
    {},
    { kind: 'flash' },
    { kind: 'set_value', id: 4 },
    { kind: 'serial_input', data: {} },
  ])
    await app.evaluate((one) => (window as never as Host).simulators[0]!.send(one as object), nonsense);
  await flash(app, 'print("still there")\n');
  await expect.poll(() => serial(app)).toContain('still there');
  expect((await kept(app)).errors).toEqual([]);
});

test(
  'a program that imports a robot drives it in the arena; one for the Calliope mini has its board',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await open(app, ['', '?device=calliope-mini-3']);
    expect((await kept(app, 1)).state['pin3']).toMatchObject({ type: 'range', value: 0 });
    await flash(app, 'from mbrobot_plusV2 import *\nprint("drives")\nforward()\ndelay(300)\nstop()\n');
    await expect.poll(() => serial(app)).toContain('drives');
    await expect
      .poll(() => app.inFrame('iframe', () => document.querySelector('.pane-arena canvas') !== null))
      .toBe(true);
    await flash(app, 'from calliopemini import *\nprint("mini")\n', 1);
    await expect.poll(() => serial(app, 1)).toContain('mini');
  },
);
