import { readFileSync } from 'node:fs';
import { defaultScene } from '../src/scene/scene';
import type { InputAction, InputEvent } from '../src/simulation/input';
import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { convoyOf } from '../src/simulation/testing/convoy';
import { courseRun } from '../src/simulation/testing/course-run';
import { runInNode, sweepInNode } from './in-node';

/** The recorded trajectories: the same list that the unit tests compare in Node. */
interface GoldenRun {
  readonly folder: string;
  readonly forMs: number;
  readonly seed: number;
  readonly traceHash: string;
}

const read = (path: string): string => readFileSync(new URL(`../courses/${path}`, import.meta.url), 'utf8');
const { runs } = JSON.parse(read('golden.json')) as { readonly runs: readonly GoldenRun[] };
const PROBE = process.env['PARCOURS_PROBE'] ?? '';

test.describe.configure({ retries: 0 }); // what differs once is not the same run everywhere

test('every ready course is driven bit for bit as in Node', async ({ app }) => {
  test.setTimeout(180_000); // nineteen minutes of driving
  await app.goto(PROBE); // one page for all of them: most of the time of a short run is its opening
  const other: string[] = [];
  for (const { folder, forMs, seed, traceHash } of runs) {
    const setup = courseRun(folder, seed);
    const result = await app.evaluate(({ run, untilMs }) => window.probe(run, untilMs), { run: setup, untilMs: forMs });
    if (result.traceHash !== traceHash) other.push(folder);
  }
  expect(other).toEqual([]);
});

/** Everything on the bare board that has a rhythm of its own, chance, or figures that are computed. */
const ALL_AT_ONCE = `
from microbit import *
import audio, log, math, music, radio, random

def tell(*what):
    print(running_time(), *what)

@run_every(ms=330)
def beat():
    tell("beat", display.get_pixel(2, 2), microphone.sound_level(), "%.3f" % math.sin(running_time()))

log.set_labels("n", "chance")
radio.on()
random.seed(7)
music.play(music.DADADADUM, wait=False)
display.scroll("Hi 5!", delay=70, wait=False)
for n in range(40):
    x, y, z = accelerometer.get_values()
    tell(n, x, y, z, accelerometer.current_gesture(), accelerometer.get_gestures(), compass.heading())
    tell(random.random(), random.randint(1, 6), random.choice("abc"), button_a.get_presses(), pin1.is_touched())
    message = radio.receive_full()
    if message:
        tell("got", message)
        radio.send("got " + str(n))
    if n == 15: audio.play(Sound.GIGGLE, wait=False)
    if n % 8 == 0: log.add(n=n, chance=random.uniform(-1, 1))
    sleep(random.randint(20, 90))
tell(temperature(), display.read_light_level(), accelerometer.get_strength(), sum(math.sqrt(i) for i in range(99)))
1 / 0
`;
import { soloRun } from '#simulation/run-setup';
const at = (ms: number, action: InputAction): InputEvent => ({ timeUs: ms * 1000, action });
const HANDS: readonly InputEvent[] = [
  at(200, { type: 'button', button: 'a', down: true }),
  at(290, { type: 'button', button: 'a', down: false }),
  at(400, { type: 'sensor', id: 'gesture', value: 'shake' }),
  at(500, { type: 'radio', text: 'hello' }),
  at(700, { type: 'sensor', id: 'accelerometerX', value: 777 }),
  at(900, { type: 'touch', pad: 'pin1', down: true }),
  at(1000, { type: 'sensor', id: 'compassHeading', value: 123 }),
  at(1100, { type: 'sensor', id: 'gesture', value: 'freefall' }),
  at(1400, { type: 'radio', bytes: [1, 0, 1, 72, 105] }),
  at(1500, { type: 'sensor', id: 'soundLevel', value: 130 }),
];

test('a program with display, music, radio, gestures and chance says the same at the same µs as in Node', async ({
  app,
}) => {
  const files = { 'main.py': ALL_AT_ONCE };
  const setup = soloRun({
    scene: defaultScene(),
    files,
    robot: 'none',
    board: 'auto',
    seed: 3,
    reality: 0,
    inputs: HANDS,
  });
  const run = { setup, untilMs: 8000 };
  const inNode = await runInNode(run);
  for (const part of ['beat', "'shake'", 'hello', 'ZeroDivisionError']) expect(inNode.console).toContain(part);
  for (const part of ['sound', 'radio', 'log']) expect(inNode.told.join('\n')).toContain(part);
  await app.goto(PROBE);
  expect(await app.evaluate((task) => window.probe(task.setup, task.untilMs), run)).toEqual(inNode);
});

for (const [count, engines] of [
  [2, IN_ONE_ENGINE],
  [4, {}],
  [8, IN_ONE_ENGINE],
] as const)
  test(
    `${count} devices that talk by radio and drive around each other do the same as in Node`,
    engines,
    async ({ app }) => {
      const run = { setup: convoyOf(count, { reality: count === 4 ? 0.5 : 0 }), untilMs: 6000 };
      const inNode = await runInNode(run);
      for (const part of count > 2 ? ['ahead', 'near'] : ['ahead']) expect(inNode.console).toContain(part);
      await app.goto(PROBE);
      expect(await app.evaluate((task) => window.probe(task.setup, task.untilMs), run)).toEqual(inNode);
    },
  );

test('a sweep of a number and used robots has the same table as in Node', async ({ app }) => {
  const setup = { ...courseRun('gate', 1), reality: 1 };
  const vary = ['main.py:6=40,55', 'seed=1..3/1'];
  const inNode = await sweepInNode({ setup, vary });
  expect((JSON.parse(inNode) as { readonly runs: readonly object[] }).runs).toHaveLength(6);
  await app.goto(PROBE);
  expect(await app.evaluate((task) => window.sweep(task.setup, task.vary), { setup, vary })).toBe(inNode);
});
