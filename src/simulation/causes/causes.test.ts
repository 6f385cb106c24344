import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { soloRun, type RunSetup } from '../run-setup';
import { Simulation } from '../simulation';
import { convoyOf } from '../testing/convoy';
import { Causes } from './causes';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

type Files = Readonly<Record<string, string>>;
const runOf = (files: Files | string, hardware: Partial<{ robot: string; board: string }> = {}): RunSetup =>
  soloRun({
    scene: defaultScene(),
    files: typeof files === 'string' ? { 'main.py': files } : files,
    ...{ robot: 'maqueen-lite', board: 'microbit-v2', ...hardware },
    ...{ seed: 3, reality: 0.5 },
  });

/** Which line each output owes what it is to, after some time: `display: 3 (0.5 s)`. */
async function causesOf(setup: RunSetup, ms = 1000, device = 0): Promise<readonly string[]> {
  const causes = new Causes();
  const run = await Simulation.create(setup, firmware, { set: causes.listener() });
  run.advanceTo(ms * 1000);
  return causes.at(device, ms * 1000).map(({ output, sinceUs, lines, again }) => {
    const place = lines.map(({ file, line }) => (file === 'main.py' ? `${line}` : `${file}:${line}`)).join(' < ');
    const more = again ? `, again ${again.map(({ line }) => line).join(' < ')}` : '';
    return `${output}: ${place}${more} (${(sinceUs / 1_000_000).toFixed(1)} s)`;
  });
}

describe('the line that made it', { timeout: 60_000 }, () => {
  it('is for a wheel the one by which it began to turn as it does, however often it is told again', async () => {
    const main = `from mbrobot import *
setSpeed(40)
for i in range(20):
    if i < 5:
        forward()
    elif i < 10:
        left()
    else:
        stop()
    delay(50)
`;
    expect(await causesOf(runOf(main), 200)).toEqual(['wheel-left: 5 (0.0 s)', 'wheel-right: 5 (0.0 s)']);
    expect(await causesOf(runOf(main), 450)).toEqual([
      'wheel-left: 7 (0.3 s)',
      expect.stringMatching(/^wheel-right: 5, again 7 /),
    ]);
    expect(await causesOf(runOf(main), 1000)).toEqual(['wheel-left: 9 (0.5 s)', 'wheel-right: 9 (0.5 s)']);
  });

  it('names the line that says the same last, besides', async () => {
    const main = 'from mbrobot import *\nforward()\ndelay(100)\nforward()\ndelay(500)';
    expect(await causesOf(runOf(main), 300)).toEqual([
      'wheel-left: 2, again 4 (0.0 s)',
      'wheel-right: 2, again 4 (0.0 s)',
    ]);
  });

  it('knows of a robot that was only told to stand, and of one that nobody told anything', async () => {
    expect(await causesOf(runOf('from mbrobot import *\nstop()'), 100)).toEqual([
      'wheel-left: 2 (0.0 s)',
      'wheel-right: 2 (0.0 s)',
    ]);
    expect(await causesOf(runOf('from mbrobot import *\nprint(getDistance())'), 100)).toEqual(['console: 2 (0.0 s)']);
  });

  it('tells the wheels and the lights apart', async () => {
    const main = `from microbit import *
i2c.write(0x10, bytes([0, 0, 90]))
i2c.write(0x10, bytes([2, 0, 90]))
pin8.write_digital(1)
pin12.write_digital(0)
`;
    expect(await causesOf(runOf(main), 500)).toEqual([
      'wheel-left: 2 (0.0 s)',
      'wheel-right: 3 (0.0 s)',
      'light-left: 4 (0.0 s)',
      'light-right: 5 (0.0 s)',
    ]);
  });

  it('is the line of a driver that is a file of the pupil’s, with the one that has called it', async () => {
    const files = {
      'main.py': 'import far\nfrom microbit import sleep\nsleep(200)\nfar.go(50)\nsleep(500)',
      'far.py':
        'from microbit import i2c\ndef go(speed):\n    send(0, speed)\ndef send(way, speed):\n    i2c.write(0x10, bytes([0, way, speed, way, speed]))',
    };
    expect(await causesOf(runOf(files), 500)).toEqual([
      'wheel-left: far.py:5 < far.py:3 < 4 (0.2 s)',
      'wheel-right: far.py:5 < far.py:3 < 4 (0.2 s)',
    ]);
  });

  it('holds for display, sound, pins, lights that are plugged in, servo, radio, log and each printed line', async () => {
    const main = `from microbit import *
import music, neopixel, radio, log
display.show(Image.HAPPY)
music.pitch(440, wait=False)
np = neopixel.NeoPixel(pin2, 3)
np[1] = (9, 0, 0)
np.show()
pin16.write_digital(1)
radio.on()
radio.send("x")
log.add(a=1)
print("one", 1)
display.show(Image.HAPPY)
display.set_pixel(0, 0, 5)
music.stop()
`;
    expect(await causesOf(runOf(main, { robot: 'none' }), 500)).toEqual([
      expect.stringMatching(/^display: 14 /),
      expect.stringMatching(/^sound: 15 /),
      expect.stringMatching(/^chain-P2: 7 /),
      expect.stringMatching(/^pin-P16: 8 /),
      expect.stringMatching(/^radio: 10 /),
      expect.stringMatching(/^log: 11 /),
      expect.stringMatching(/^console: 12 /),
    ]);
  });

  it.each([
    ['maqueen-plus-v1', 'from mbrobot_plus import *\nforward()\ndelay(300)\nstop()'],
    ['maqueen-plus-v2', 'from mbrobot_plusV2 import *\nforward()\ndelay(300)\nstop()'],
    ['callibot', 'from callibot import *\nforward()\ndelay(300)\nstop()'],
    ['bitbot-xl', 'from mbbitbot import *\nforward()\nsleep(300)\nstop()'],
    ['cutebot', 'from cutebot import *\ngo_forward()\nutime.sleep_ms(300)\nstop()'],
  ])('holds for the wheels of %s', async (robot, main) => {
    const board = robot === 'callibot' ? 'calliope-mini-3' : 'microbit-v2';
    const wheels = async (ms: number): Promise<unknown> =>
      (await causesOf(runOf(main, { robot, board }), ms)).filter((text) => text.startsWith('wheel'));
    expect(await wheels(200)).toEqual(['wheel-left: 2 (0.0 s)', 'wheel-right: 2 (0.0 s)']);
    expect(await wheels(900)).toEqual(['wheel-left: 4 (0.3 s)', 'wheel-right: 4 (0.3 s)']);
  });

  it('is the line that has begun what goes on by itself: a text that runs through, a tune', async () => {
    const main = `from microbit import *
import music
display.scroll("Hello", wait=False)
music.play(music.NYAN, wait=False)
for i in range(50):
    sleep(20)
`;
    expect(await causesOf(runOf(main, { robot: 'none' }), 900)).toEqual(['display: 3 (0.0 s)', 'sound: 4 (0.0 s)']);
  });

  it.each([
    [0, /^display: 10 /],
    [2, /^wheel-left: 19 /],
  ])('is told of device %i of three by its own program', async (device, expected) => {
    expect(await causesOf(convoyOf(3), 800, device)).toContainEqual(expect.stringMatching(expected));
  });

  it('changes nothing of a run: way, time, output and memory', async () => {
    for (const setup of [
      convoyOf(2),
      runOf(
        'from mbrobot import *\nimport music\nwhile True:\n    forward()\n    music.pitch(440, 20)\n    print(getDistance())\n    left()\n    delay(30)',
      ),
    ]) {
      const outcomes = [];
      for (const outlets of [{}, { set: new Causes().listener() }]) {
        const run = await Simulation.create(setup, firmware, outlets);
        run.advanceTo(2_000_000);
        outcomes.push([run.nowUs, run.traceHash, run.takeConsole(), run.heapFree(), run.snapshot()]);
      }
      expect(outcomes[1]).toEqual(outcomes[0]);
    }
  });

  it('counts once what several repetitions tell', async () => {
    const setup = runOf('from mbrobot import *\nfor i in range(100):\n    print(i)\n    delay(20)');
    const causes = new Causes();
    for (const ms of [700, 300, 900]) {
      const run = await Simulation.create(setup, firmware, { set: causes.listener() });
      run.advanceTo(ms * 1000);
    }
    const times = causes.events(0, 'console', 0, 900_000).map(({ sinceUs }) => sinceUs);
    expect(times.length).toBeGreaterThan(30);
    expect(new Set(times).size).toBe(times.length);
    expect(causes.events(0, 'console', times[3] ?? 0, times[5] ?? 0)).toHaveLength(3);
  });
});
