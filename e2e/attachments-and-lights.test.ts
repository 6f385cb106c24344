import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { middleOf, paintOf, robotAt, seenFrom } from './arena';
import { expect, test, type App } from './app';
import { distance, drive, ends, sceneOf } from './course';
import { runInNode } from './in-node';
import { attribute, consoleIn, isThere, on, openApp, pasteProgram } from './page';
import { by, choose, gone, until } from './parts';
import { openDeviceSettings } from './pupil';
import { parseScene } from '../src/scene/parse';
import { defaultScene } from '../src/scene/scene';

/** Goes to an element as the keyboard would, and presses Enter there. */
async function enter(app: App, css: string): Promise<void> {
  await app.evaluate((selector) => document.querySelector<HTMLElement>(selector)?.focus(), css);
  await app.press('Enter');
}

/** Goes down a menu until a name is under the keyboard, and takes it. */
async function take(app: App, name: string): Promise<void> {
  const isAt = (): Promise<boolean> =>
    app.evaluate((text) => document.activeElement?.querySelector('.page-list-item-title')?.textContent === text, name);
  for (let step = 0; step < 12 && !(await isAt()); step += 1) await app.press('ArrowDown');
  expect(await isAt(), `${name} under the keyboard`).toBe(true);
  await app.press('Enter');
}

/** The pixels painted ahead of the robot's body, where a claw is: x ahead of the axle, y to the left, in mm. */
async function paintAhead(app: App) {
  const painted = seenFrom(await robotAt(app), await paintOf(app, 'moving', defaultScene().size));
  return painted.filter(({ x, y }) => x > 90 && x < 230 && Math.abs(y) < 90);
}

test(
  'a claw that is chosen is seen at once, and closes and opens as the program says',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en', robot: 'maqueen-plus-v2', speed: 'max', cone: false });
    await until(app, by('arena'));
    await expect.poll(async () => (await paintOf(app, 'moving', defaultScene().size)).length).toBeGreaterThan(0);
    await expect.poll(() => paintAhead(app)).toEqual([]);
    await openDeviceSettings(app);
    await until(app, by('option-P1'));
    await choose(app, 'P1', 'claw');
    await app.press('Escape');
    await gone(app, by('option-P1'));
    await expect.poll(async () => (await paintAhead(app)).length).toBeGreaterThan(20);

    /** From the outer edge of one jaw to that of the other, in mm. */
    const width = async (): Promise<number> => {
      const across = (await paintAhead(app)).map(({ y }) => y);
      return Math.max(...across) - Math.min(...across);
    };
    const endsSaid = async (): Promise<number> => (await consoleIn(app)).split('The program has ended.').length - 1;
    const turnTo = async (angle: number): Promise<void> => {
      const before = await endsSaid();
      await pasteProgram(app, `from mbrobot_plusV2 import *\nsetServo("P1", ${String(angle)})\ndelay(1000)`);
      await app.click(on('run'));
      await expect.poll(endsSaid).toBe(before + 1);
    };
    await turnTo(30);
    await expect.poll(width, 'open').toBeGreaterThan(75);
    await turnTo(90);
    await expect.poll(width, 'closed').toBeLessThan(62);
    await turnTo(30);
    await expect.poll(width, 'open again').toBeGreaterThan(75);
  },
);

test(
  'carry the block: the course brings the claw along, the block lies in the field and the robot has let go',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await drive(app, 'carry', 'Maqueen Lite');
    await ends(app, 'carry');
    const { x, y } = middleOf(await paintOf(app, 'blocks', sceneOf('carry').size));
    await expect.poll(async () => distance(await robotAt(app), [x, y])).toBeGreaterThan(150);
    expect([Math.abs(x - 1000) < 80, Math.abs(y - 650) < 70], `${String(x)}, ${String(y)}`).toEqual([true, true]);
    await openDeviceSettings(app);
    await until(app, by('option-S1'));
    expect(
      await app.evaluate((css) => document.querySelector<HTMLSelectElement>(css)?.value ?? null, by('option-S1')),
    ).toBe('claw');
  },
);

const RING = [
  'from microbit import *',
  'from neopixel import NeoPixel',
  'ring = NeoPixel(pin0, 24)',
  'ring[0] = (255, 0, 0)',
  'ring[8] = (0, 60, 0)',
  'ring.show()',
].join('\n');

test(
  'a LED ring shows itself when the program lights it; by keyboard it becomes a strip and goes onto the robot',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en', robot: 'maqueen-lite', device: 'microbit-v2' });
    expect(await isThere(app, by('lights'))).toBe(false);
    await pasteProgram(app, RING);
    await app.click(on('run'));
    const label = (): Promise<string | null> => attribute(app, `${by('lights')} canvas`, 'aria-label');
    await expect.poll(label).toBe('LED ring on pin 0: 24 lights, 2 lit');
    const litPixels = (): Promise<number> =>
      app.evaluate(
        (css) => {
          const canvas = document.querySelector<HTMLCanvasElement>(css);
          const context = canvas?.getContext('2d') ?? null;
          if (canvas === null || context === null || canvas.width === 0) return 0;
          const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
          return data.filter((red, i) => i % 4 === 0 && red > 200 && (data[i + 1] ?? 0) < 120).length;
        },
        `${by('lights')} canvas`,
      );
    await expect.poll(litPixels).toBeGreaterThan(10);

    const change = `${by('lights')} [aria-label="Change form and place"]`;
    await enter(app, change);
    await until(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');
    await take(app, 'Strip');
    await expect.poll(label).toBe('LED strip on pin 0: 24 lights, 2 lit');
    await gone(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');

    await enter(app, change);
    await until(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');
    await take(app, 'On the robot');
    await gone(app, `${by('lights')} canvas`);
    expect(await app.text(by('lights'))).toContain('on the robot');

    await app.reload();
    await until(app, on('editor'));
    await app.click(on('run'));
    await until(app, by('lights'));
    expect(await app.text(by('lights'))).toContain('on the robot');
    await enter(app, change);
    await until(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');
    await take(app, 'Beside the microcomputer');
    await expect.poll(label).toBe('LED strip on pin 0: 24 lights, 2 lit');
  },
);

test(
  'what the arena shows is switched by keyboard and kept: path, centre of rotation',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const isOn = (id: string): Promise<string | null> => attribute(app, by(`show-${id}`), 'aria-checked');
    await openApp(app, { language: 'en', robot: 'maqueen-lite', speed: 'max' });
    await enter(app, by('show'));
    await until(app, by('show-trace'));
    for (const [id, name] of [
      ['centre', 'Centre of rotation'],
      ['trace', 'Path'],
    ] as const) {
      expect(await isOn(id), name).toBe('false');
      await take(app, name);
      await expect.poll(() => isOn(id)).toBe('true'); // the menu stays open
    }
    await app.press('Escape');
    await gone(app, by('show-trace'));

    await app.reload();
    await until(app, on('editor'));
    await enter(app, by('show'));
    await until(app, by('show-trace'));
    for (const id of ['centre', 'trace']) expect(await isOn(id), id).toBe('true');
    await app.press('Escape');
    await gone(app, by('show-trace'));

    // The path goes from where the robot started to where it is.
    const { size } = defaultScene();
    const start = await robotAt(app);
    await pasteProgram(app, 'from mbrobot import *\nforward()\ndelay(1500)\nleftArc(0.2)\ndelay(1000)\nstop()');
    await app.click(on('run'));
    await expect.poll(() => consoleIn(app)).toContain('The program has ended.');
    await expect
      .poll(async () => {
        const path = await paintOf(app, 'trail', size);
        return [
          path.some(({ x, y }) => Math.abs(x - start.xMm - 20) < 10 && Math.abs(y - start.yMm) < 10),
          path.some(({ x, y }) => x > start.xMm + 150 && y > start.yMm + 20),
        ];
      })
      .toEqual([true, true]);
    await enter(app, by('show'));
    await until(app, by('show-trace'));
    await take(app, 'Path');
    await expect.poll(() => isOn('trace')).toBe('false');
    await expect.poll(() => app.evaluate(() => document.querySelectorAll('[data-testid=arena] canvas').length)).toBe(3);
  },
);

test(
  'a Maqueen on a Calliope mini: the arena says in a sentence what is plugged where, a button mends it',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'de', device: 'calliope-mini-3' });
    await pasteProgram(app, 'from mbrobot_plusV2 import *\nforward()');
    await until(app, `.pane-arena ${by('misplugged')}`);
    expect(await app.text(`.pane-arena ${by('misplugged')} p`)).toBe(
      'Der Maqueen Plus V2 gehört auf einen micro:bit V2. Hier steckt ein Calliope mini 3: Der Roboter hört nichts.',
    );
    await enter(app, `.pane-arena ${by('plug-in')}`);
    await gone(app, by('misplugged'));
    const start = await robotAt(app);
    await app.click(on('run'));
    await expect.poll(async () => (await robotAt(app)).xMm).toBeGreaterThan(start.xMm + 20);
  },
);

for (const theme of ['light', 'dark'] as const) {
  test(
    `axe finds nothing that shuts people out of options, lights and what the arena shows, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      const robotOptions = { callibot: { S1: 'claw', bumper: 'always' } };
      await openApp(app, { theme, language: 'en', robot: 'callibot', robotOptions, reality: 0.5, trace: true });
      await pasteProgram(app, `from calliopemini import *\n${RING.split('\n').slice(1).join('\n')}`);
      await app.click(on('run'));
      await until(app, `${by('lights')} canvas`);
      expect(await violationsOn(app), 'a ring').toEqual([]);
      await enter(app, `${by('lights')} [aria-label="Change form and place"]`);
      await until(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');
      expect(await violationsOn(app), 'its form and place').toEqual([]);
      await app.press('Escape');
      await gone(app, '[role=menu][aria-label="Lights on pin 0"] [role=menuitemradio]');
      await enter(app, by('show'));
      await until(app, by('show-trace'));
      expect(await violationsOn(app), 'what the arena shows').toEqual([]);
      await app.press('Escape');
      await gone(app, by('show-trace'));
      await openDeviceSettings(app);
      await until(app, `.device-card ${by('options-reset')}`);
      await until(app, `.device-card ${by('seed')}`);
      expect(await violationsOn(app), 'options of a used robot').toEqual([]);
    },
  );
}

const PROBE = process.env['PARCOURS_PROBE'] ?? '';

/** A used robot in an arena with everything that it can meet, and a program that asks and moves all that it has. */
interface Probe {
  readonly robot: string;
  readonly what: string;
  readonly options: Readonly<Record<string, string>>;
  readonly program: string;
  /** The output expected of the program. */
  readonly finds: readonly RegExp[];
}

const ARENA = parseScene(
  JSON.stringify({
    format: 'parcours-scene',
    version: 1,
    size: [1000, 800],
    robot: { at: [200, 300], heading: 0 },
    objects: [
      { id: 'near', type: 'block', at: [420, 300], size: [40, 40] },
      { id: 'far', type: 'block', at: [600, 520], size: [60, 60], turn: 1 },
      { id: 'still', type: 'fixed-block', at: [860, 560], size: [90, 90], turn: 1 },
      {
        id: 'line',
        type: 'stroke',
        points: [
          [520, 100],
          [560, 700],
          [900, 400],
        ],
        width: 25,
      },
      { id: 'wall', type: 'wall', from: [700, 100], to: [960, 330] },
    ],
  }),
);

const PROBES: readonly Probe[] = [
  {
    robot: 'maqueen-plus-v2',
    what: 'a Plus V2 with a claw',
    options: { P1: 'claw', analogPolarity: 'light-low', analogOrder: 'L2-first' },
    program: `
from microbit import *
from mbrobot_plusV2 import *
import music

eyes = [irL2, irL1, irM, irR1, irR2]
def tell(what):
    print(running_time(), what, getDistance(), [eye.read_digital() for eye in eyes], [eye.read_analog() for eye in eyes])

setServo("P1", 30)
delay(600)
setSpeed(45)
calibrate(3)
forward()
while getDistance() > 5:
    delay(20)
stop()
setServo("P1", 90)
delay(600)
tell("taken")
music.play(music.BA_DING, wait=False)
for move in (lambda: leftArc(0.15), forward, lambda: rightArc(0.2), right, backward, lambda: motL.rotate(-60)):
    move()
    for n in range(10):
        posRGB(n % 4, 25 * n, 255 - 25 * n, 80)
        setServo("P2", 20 * n)
        setLED(n % 2, 1)
        delay(130)
        tell(n)
stop()
setServo("P1", 20)
delay(500)
tell("let go")
1 / 0
`,
    finds: [/taken/, /\[[01, ]*0[01, ]*\] \[/, /let go/, /ZeroDivisionError/],
  },
  {
    robot: 'callibot',
    what: 'a Calli:bot with a bumper',
    options: { bumper: 'always' },
    program: `
from calliopemini import *
from callibot import *

def encoders():
    i2c.write(0x22, bytes([0x91]))
    return i2c.read(0x22, 9)[1:]

def supply():
    i2c.write(0x22, bytes([0x83]))
    return i2c.read(0x22, 3)

setAlarm(1)
setSpeed(35)
i2c.write(0x20, bytes([0x14, 60]))
forward()
touched = 0
while running_time() < 14000:
    feels = tsLeftValue(), tsRightValue(), tsValue()
    print(running_time(), feels, irLeftValue(), irRightValue(), getDistance(), encoders(), supply())
    if sum(feels):
        touched += 1
        print("touched", touched)
        i2c.write(0x20, bytes([0x14, 30 * touched % 180]))
        backward()
        delay(350)
        left()
        delay(260)
        forward() if touched % 2 else rightArc(0.3)
    setLED(touched % 2)
    i2c.write(0x22, bytes([3, touched % 4 + 1, 16, 8, 0]))
    delay(60)
stop()
setAlarm(0)
1 / 0
`,
    finds: [/touched 3/, /ZeroDivisionError/],
  },
  {
    robot: 'maqueen-lite',
    what: 'a Lite with a forklift',
    options: { S1: 'forklift', S2: 'push' },
    program: `
from microbit import *
from mbrobot import *
import neopixel

ring = neopixel.NeoPixel(pin16, 12)
def tell(what):
    print(running_time(), what, getDistance(), irLeft.read_digital(), irRight.read_digital())

setServo("S1", 0)
setServo("S2", 90)
delay(500)
setSpeed(50)
forward()
for n in range(22):
    delay(100)
    tell(n)
stop()
setServo("S1", 80)
delay(800)
tell("lifted")
for n in range(40):
    fillRGB(6 * n, 0, 255 - 6 * n)
    ring[n % 12] = (n, 255 - n, 7)
    ring.show()
    setServo("S2", 4 * n)
    if getDistance() < 9: backward()
    elif n % 10 < 5: leftArc(0.12)
    else: forward()
    delay(150)
    tell(n)
setServo("S1", 0)
beep()
stop()
delay(600)
tell("set down")
1 / 0
`,
    finds: [/lifted/, /set down/, /ZeroDivisionError/],
  },
];
import { soloRun } from '#simulation/run-setup';

for (const { robot, what, options, program, finds } of PROBES)
  test(
    `${what}, like a used one (0.7, number 3), does the same bit for bit as in Node`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      if (!('scene' in ARENA)) throw new Error(ARENA.problem);
      const setup = soloRun({
        scene: ARENA.scene,
        files: { 'main.py': program },
        robot,
        board: 'auto',
        seed: 3,
        robotOptions: options,
        reality: 0.7,
      });
      const run = { setup, untilMs: 16_000 };
      const inNode = await runInNode(run);
      for (const part of finds) expect(inNode.console).toMatch(part);
      const ideal = await runInNode({ ...run, setup: { ...setup, reality: 0 } });
      expect(ideal.traceHash).not.toBe(inNode.traceHash);
      await app.goto(PROBE);
      expect(await app.evaluate((task) => window.probe(task.setup, task.untilMs), run)).toEqual(inNode);
    },
  );
