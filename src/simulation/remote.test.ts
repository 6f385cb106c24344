import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import type { InputEvent } from './input';
import { fitRun } from './run-problem';
import type { DeviceSetup } from './run-setup';
import { Simulation } from './simulation';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const device = (name: string, robot: string, program: string, more: Partial<DeviceSetup> = {}): DeviceSetup => ({
  ...{ name, robot, board: 'auto', files: { 'main.py': program } },
  ...more,
});

/** The lines that each device has printed after this many seconds. */
async function printed(
  devices: readonly [DeviceSetup, ...DeviceSetup[]],
  inputs: readonly InputEvent[],
  seconds: number,
) {
  const simulation = await Simulation.create({ scene: defaultScene(), devices, seed: 1, reality: 0, inputs }, firmware);
  simulation.advanceTo(seconds * 1_000_000);
  return devices.map((_, place) => simulation.takeConsole(place).trim().split(/\s*\n/));
}

/** The problem of inputs that are given now; `null`: there is none. */
function problemOf(devices: readonly [DeviceSetup, ...DeviceSetup[]], inputs: readonly InputEvent[]): string | null {
  const fitted = fitRun({ scene: defaultScene(), devices, seed: 1, reality: 0, inputs }, true);
  return 'problem' in fitted ? fitted.problem : null;
}

const remote = (atMs: number, key: 'up' | 'left' | '7', forMs: number): InputEvent[] =>
  [true, false].map((down) => ({
    timeUs: (atMs + (down ? 0 : forMs)) * 1000,
    action: { type: 'remote', key, down },
  }));

/** Measures the silences only, as drivers of MakeCode's kind and those with time_pulse_us do. */
const SILENCES = `
from microbit import *
import machine
pin16.set_pull(pin16.NO_PULL)
while True:
    if machine.time_pulse_us(pin16, 0, 100000) < 8000: continue
    gap = machine.time_pulse_us(pin16, 1, 10000)
    if 2000 < gap < 2500: print('repeat')
    if not 4000 < gap < 5000: continue
    code = 0
    for bit in range(32):
        gap = machine.time_pulse_us(pin16, 1, 10000)
        if 400 < gap < 700: pass
        elif 1500 < gap < 1800: code |= 1 << bit
        else: print('odd', gap)
    print('%08X' % code)
`;

/** Polls the pin and the clock. */
const POLLS = `
from microbit import *
import utime
def edge(level):
    begin = utime.ticks_us()
    while pin16.read_digital() != level:
        if utime.ticks_diff(utime.ticks_us(), begin) > 200000: return -1
    return utime.ticks_us()
pin16.set_pull(pin16.PULL_UP)
while True:
    low = edge(0)
    if low < 0: continue
    high = edge(1)
    if high - low < 8000: continue
    start = edge(0)
    if start - high < 4000: continue
    bits = []
    for bit in range(32):
        rise = edge(1)
        bits.append(1 if edge(0) - rise > 1100 else 0)
    print(sum(bits[16 + place] << place for place in range(8)))
`;

describe('the infrared remote control', () => {
  it.each([
    ['callibot', 'the Calli:bot has no infrared receiver'],
    ['bitbot-xl', 'the bit:bot XL has no infrared receiver'],
    ['none', 'a micro:bit V2 without a robot has no infrared receiver'],
  ])('is refused where nothing receives it: robot %s', (robot, said) => {
    expect(problemOf([device('a', robot, 'pass')], remote(500, 'up', 100))).toContain(
      `[0]: remote: nothing receives the key "up", as ${said}. Robots with one: maqueen`,
    );
  });

  it('needs one device that hears it, unless one is named', () => {
    const both = [device('a', 'none', 'pass'), device('b', 'maqueen-lite', 'pass')] as const;
    expect(problemOf(both, remote(500, 'up', 100))).toBeNull();
    const named = remote(500, 'up', 100).map((event) => ({ ...event, device: 'a' }));
    expect(problemOf(both, named)).toContain('nothing receives');
  });

  it('has no effect in a recording of before whose robot does not hear it', async () => {
    const devices = [device('a', 'callibot', "print('here')")] as const;
    expect(await printed(devices, remote(500, 'up', 100), 1)).toEqual([['here']]);
  });

  it('is decoded by a program that measures the pulses on pin 16: frame, then a repeat every 110 ms', async () => {
    const inputs = [...remote(500, 'up', 240), ...remote(1500, 'left', 60), ...remote(2000, '7', 60)];
    const [lines] = await printed([device('1', 'maqueen-lite', SILENCES)], inputs, 2.5);
    expect(lines).toEqual(['F50ABF00', 'repeat', 'repeat', 'FB04BF00', 'E718BF00']);
  });

  it('is decoded by a program that polls the pin', async () => {
    const inputs = [...remote(500, 'up', 60), ...remote(1500, 'left', 60)];
    const [lines] = await printed([device('1', 'maqueen-lite', POLLS)], inputs, 2.5);
    expect(lines).toEqual(['10', '4']);
  });

  it.each(['maqueen-plus-v1', 'maqueen-plus-v2', 'maqueen-plus-v3', 'cutebot'])('is heard by %s', async (robot) => {
    const [lines] = await printed([device('1', robot, SILENCES)], remote(500, 'up', 60), 1);
    expect(lines).toEqual(['F50ABF00']);
  });

  it('is heard by the MotionKit 2 in its register 0x2B', async () => {
    const program =
      'from calliopemini import *\nwhile True:\n    i2c.write(0x10, b"\\x2b")\n    code = i2c.read(0x10, 4)\n    if any(code): print(code); break';
    const [lines] = await printed([device('1', 'motionkit-2', program)], remote(500, 'up', 200), 1);
    expect(lines).toEqual([String.raw`b'\x00\xfdP\xaf'`]);
  });

  it('reaches every robot, or the one that is named', async () => {
    const devices = [device('one', 'maqueen-lite', SILENCES), device('two', 'maqueen-lite', SILENCES)] as const;
    const named = remote(1500, 'left', 60).map((event) => ({ ...event, device: 'two' }));
    const [one, two] = await printed(devices, [...remote(500, 'up', 60), ...named], 2);
    expect(one).toEqual(['F50ABF00']);
    expect(two).toEqual(['F50ABF00', 'FB04BF00']);
  });

  it('shows in the picture of the run which key came last and whether it is held', async () => {
    const devices = [device('1', 'maqueen-lite', '')] as const;
    const run = { scene: defaultScene(), devices, seed: 1, reality: 0, inputs: remote(500, 'up', 200) };
    const simulation = await Simulation.create(run, firmware);
    const seen = [400_000, 600_000, 900_000].map((us) => {
      simulation.advanceTo(us);
      return simulation.snapshot().infrared;
    });
    expect(seen).toEqual([undefined, { key: 'up', isDown: true }, { key: 'up', isDown: false }]);
  });
});

describe('a gamepad in the hand', () => {
  const program =
    'from microbit import *\npin13.set_pull(pin13.PULL_UP)\nwhile True:\n    print(pin1.read_analog(), pin2.read_analog(), pin13.read_digital())\n    sleep(400)';
  const pad = device('pad', 'none', program, { robotOptions: { inHand: 'gamepad' } });
  const robot = device('robot', 'maqueen-lite', '');
  const inputs: InputEvent[] = [
    { timeUs: 300_000, device: 'pad', action: { type: 'stick', x: 0.5, y: -1 } },
    { timeUs: 700_000, device: 'pad', action: { type: 'gamepad', key: 'C', down: true } },
  ];

  it('has a stick and keys', async () => {
    const [, lines] = await printed([robot, pad], inputs, 1);
    expect(lines).toEqual(['512 512 1', '767 0 1', '767 0 0']);
  });

  it('is read by the library controller: stick from -1 to 1, keys like the buttons of the board', async () => {
    const asked = [
      'from controller import *\nfrom microbit import sleep',
      'while True:\n    sleep(300)',
      '    print(joystick.get_x(), joystick.get_y(), joystick.get_z(), button_green.is_pressed(), button_c.get_presses(), button_blue.was_pressed())',
    ];
    const tap = [450, 520].map((ms, place): InputEvent => {
      const action = { type: 'gamepad', key: 'F', down: place === 0 } as const;
      return { timeUs: ms * 1000, device: 'pad', action };
    });
    const [, lines] = await printed(
      [robot, { ...pad, files: { 'main.py': asked.join('\n') } }],
      [...inputs, ...tap],
      1.25,
    );
    const [rest, moved, held] = lines ?? [];
    expect(rest).toMatch(/^0\.(0|498\d*) (0\.0|-1\.0) 0 False 0 False$/);
    expect(moved).toMatch(/^0\.498\d* -1\.0 0 False 0 True$/);
    expect(held).toMatch(/^0\.498\d* -1\.0 0 True 1 False$/);
  });

  it('is refused on a device that has none, with the way out', async () => {
    const refused = printed([robot, { ...pad, robotOptions: {} }], inputs, 1);
    await expect(refused).rejects.toThrow('[0]: This device has no gamepad. Give it one: --device');
  });
});
