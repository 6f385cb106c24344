import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SoundEvent } from '#board/sound/sound-event';
import { importedModules } from '#python/imports';
import { parseSceneValue } from '#scene/parse';
import { defaultScene, type Scene } from '#scene/scene';
import { chooseHardware, hardwareIds, type Hardware, type HardwareWish } from './hardware';
import type { RadioPacket, TimedLogEvent } from './outlets';
import { soloRun, type SoloSetup } from './run-setup';
import { Simulation } from './simulation';
import { createTraceHash } from './trace';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const lines = (...texts: string[]): string => texts.join('\n');

function setupOf(program: string, change: Partial<SoloSetup> = {}) {
  const base = {
    scene: defaultScene(),
    files: { 'main.py': program },
    robot: 'auto',
    board: 'auto',
    seed: 1,
    reality: 0,
  };
  return soloRun({ ...base, ...change });
}

const start = (program: string, change: Partial<SoloSetup> = {}) =>
  Simulation.create(setupOf(program, change), firmware);

async function runFor(program: string, ms: number, change: Partial<SoloSetup> = {}): Promise<Simulation> {
  const simulation = await start(program, change);
  simulation.advanceTo(ms * 1000);
  return simulation;
}

function sceneWith(...objects: object[]): Scene {
  const parsed = parseSceneValue({ format: 'parcours-scene', version: 1, robot: { at: [300, 450] }, objects });
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

const sceneWithOptions = (type: string, options: Readonly<Record<string, string>>): Scene => ({
  ...defaultScene(),
  robot: { ...defaultScene().robot, type, options },
});

function chosen(wish: HardwareWish): Hardware {
  const hardware = chooseHardware(wish);
  if ('problem' in hardware) throw new Error(hardware.problem);
  return hardware;
}

const guessed = (program: string): Hardware =>
  chosen({ scene: defaultScene(), imports: new Set(importedModules(program)), robot: 'auto', board: 'auto' });

const drive = lines('from mbrobot import *', 'forward()', 'delay(1000)', 'leftArc(0.2)', 'delay(1000)', 'stop()');

describe('a run', { timeout: 30_000 }, () => {
  it('drives the robot that the program steers, and prints what it prints', async () => {
    const simulation = await runFor(`${drive}\nprint('there')`, 3000);
    expect(simulation.snapshot().robot?.pose.xMm).toBeGreaterThan(700);
    expect(simulation.takeConsole()).toBe('there\n');
    expect(simulation.takeConsole()).toBe('');
  });

  it('goes on after the program has ended: the motors keep turning', async () => {
    const simulation = await start(lines('from mbrobot import *', 'forward()'));
    simulation.advanceProgramTo(500_000);
    expect(simulation.ended).toMatchObject({ kind: 'finished', exception: null });
    expect(simulation.nowUs).toBeLessThan(100_000);
    simulation.advanceTo(1_000_000);
    expect(simulation.snapshot().running).toBe('world');
    expect(simulation.snapshot().robot?.pose.xMm).toBeGreaterThan(680);
  });

  it('tells an exception with its line', async () => {
    const simulation = await runFor(lines('x = 1', 'def f():', '  return x / 0', 'f()'), 100);
    expect(simulation.ended).toMatchObject({ kind: 'exception', exception: { type: 'ZeroDivisionError', line: 3 } });
    expect(simulation.takeConsole()).toMatch(/Traceback[^]*File "main.py", line 3, in f\n/);
  });

  it('is the same to the last bit whatever the pieces in which time passes', async () => {
    const program = lines(drive, 'import random', 'while True:', '  delay(random.randrange(50))', '  right()');
    const whole = await runFor(program, 4000);
    const pieces = await start(program);
    for (let us = 0; us <= 4_000_000; us += 777) pieces.advanceTo(us);
    pieces.advanceTo(4_000_000);
    expect(pieces.traceHash).toBe(whole.traceHash);
    expect(pieces.nowUs).toBe(whole.nowUs);
    const otherSeed = await runFor(program, 4000, { seed: 2 });
    expect(otherSeed.traceHash).not.toBe(whole.traceHash);
  });

  it('begins anew with every creation', async () => {
    const first = await runFor(drive, 2500);
    const again = await runFor(drive, 2500);
    expect(again.traceHash).toBe(first.traceHash);
    expect(again.snapshot()).toEqual(first.snapshot());
  });

  it('gives each row of the trace once, so that a day of them needs no memory', async () => {
    const simulation = await runFor(drive, 1000, { keepTrace: true });
    simulation.takeTrace();
    expect(simulation.takeTrace()).toEqual([]);
    simulation.advanceTo(simulation.nowUs + 40_000);
    expect(simulation.takeTrace().map((row) => row.timeUs)).toEqual([1_020_000, 1_040_000]);
  });

  it('keeps a row of the trace every 20 ms, beginning at 0, when asked to', async () => {
    const simulation = await runFor(drive, 1000, { keepTrace: true });
    const trace = simulation.takeTrace();
    expect(trace.map((row) => row.timeUs)).toEqual(Array.from({ length: 51 }, (_, n) => n * 20_000));
    expect(trace[0]).toMatchObject({ xMm: 600, yMm: 450, headingRad: 0, collisions: 0 });
    expect((await runFor(drive, 1000)).takeTrace()).toEqual([]);
  });

  it('drives twice as fast at scale 2, and sees the line with sensors twice as far apart', async () => {
    const program = lines('from mbrobot import *', 'forward()', 'delay(2000)', 'stop()');
    const scene = { ...defaultScene(), size: [3000, 900] as const };
    const pathOf = async (scale: number) => {
      const simulation = await runFor(program, 3000, { scene: { ...scene, robot: { ...scene.robot, scale } } });
      return simulation.snapshot().robot?.pathMm ?? 0;
    };
    expect((await pathOf(2)) / (await pathOf(1))).toBeCloseTo(2, 1);
    const wide = sceneWith({
      id: 's',
      type: 'stroke',
      points: [
        [300, 464],
        [400, 464],
      ],
      width: 10,
    });
    const asks = lines('from mbrobot import *', 'print(irLeft.read_digital(), irRight.read_digital())');
    const simulation = await runFor(asks, 100, { scene: { ...wide, robot: { ...wide.robot, scale: 2 } } });
    expect(simulation.takeConsole()).toBe('0 1\n');
  });

  it('counts collisions and stops at a wall', async () => {
    const simulation = await runFor(lines('from mbrobot import *', 'forward()'), 10_000);
    const robot = simulation.snapshot().robot;
    expect(robot?.collisions).toBe(1);
    expect(robot?.pose.xMm).toBeGreaterThan(1130);
    expect(robot?.pose.xMm).toBeLessThan(1145);
  });

  it('shows blocks by their id, and pushes them', async () => {
    const scene = sceneWith({ id: 'box', type: 'block', at: [500, 450], size: [50, 50] });
    const simulation = await runFor(lines('from mbrobot import *', 'setSpeed(80)', 'forward()'), 2000, { scene });
    expect(simulation.snapshot().blocks.box?.xMm).toBeGreaterThan(550);
  });

  it('lets the line sensors read what the course paints', async () => {
    const scene = sceneWith({
      id: 's',
      type: 'stroke',
      points: [
        [300, 457],
        [400, 457],
      ],
      width: 10,
    });
    const program = lines('from mbrobot import *', 'print(irLeft.read_digital(), irRight.read_digital())');
    expect((await runFor(program, 100, { scene })).takeConsole()).toBe('0 1\n');
  });
});

describe('input from outside', { timeout: 30_000 }, () => {
  const watch = lines(
    'from microbit import *',
    'was = False',
    'while True:',
    '  now = button_a.is_pressed()',
    '  if now != was:',
    '    print(running_time(), now)',
    '    was = now',
  );

  it('takes effect at the next step of the world and is logged with that time', async () => {
    const simulation = await start(watch);
    simulation.advanceTo(101_000);
    simulation.input({ type: 'button', button: 'a', down: true });
    simulation.advanceTo(300_000);
    simulation.input({ type: 'button', button: 'a', down: false });
    simulation.advanceTo(500_000);
    expect(simulation.inputLog.map((event) => event.timeUs)).toEqual([104_000, 304_000]);
    expect(simulation.takeConsole()).toMatch(/^1\d\d True\n3\d\d False\n$/);
  });

  it('replays from its log to the same run', async () => {
    const program = lines(
      'from mbrobot import *',
      'from microbit import *',
      'while True:',
      '  if button_a.is_pressed():',
      '    left()',
      '  else:',
      '    forward()',
      '  delay(7)',
    );
    const live = await start(program);
    for (const [us, down] of [
      [333_333, true],
      [700_001, false],
      [900_123, true],
    ] as const) {
      live.advanceTo(us);
      live.input({ type: 'button', button: 'a', down });
    }
    live.advanceTo(1_500_000);
    live.input({ type: 'place', pose: { xMm: 300, yMm: 200, headingDeg: 45 } });
    live.advanceTo(3_000_000);
    const replayed = await runFor(program, 3000, { inputs: live.inputLog });
    expect(replayed.traceHash).toBe(live.traceHash);
    expect(replayed.inputLog).toEqual(live.inputLog);
  });

  it('may be there from the start: at 0 ms the button is down before the program begins', async () => {
    const inputs = [{ timeUs: 0, action: { type: 'sensor', id: 'lightLevel', value: 10 } } as const];
    const program = lines('from microbit import *', 'print(display.read_light_level())');
    expect((await runFor(program, 200, { inputs })).takeConsole()).toBe('10\n');
  });

  it('takes accelerations beyond 2 g, which the program feels as far as it has set the range, and so does the replay', async () => {
    const program = lines(
      'from microbit import *',
      'sleep(30)',
      'print(accelerometer.get_x())',
      'accelerometer.set_range(8)',
      'microphone.set_threshold(SoundEvent.LOUD, 200)',
      'sleep(100)',
      'print(accelerometer.get_x(), accelerometer.get_y())',
    );
    const inputs = [{ timeUs: 0, action: { type: 'sensor', id: 'accelerometerX', value: 7000 } } as const];
    const live = await start(program, { inputs });
    live.advanceTo(50_000);
    live.input({ type: 'sensor', id: 'accelerometerY', value: -7500 });
    live.advanceTo(300_000);
    expect(live.takeConsole()).toBe('2000\n2000 -7500\n');
    expect(live.snapshot()).toMatchObject({ accelerometerRangeMg: 8000, soundThresholds: { quiet: 75, loud: 200 } });
    const replayed = await runFor(program, 300, { inputs: live.inputLog });
    expect(replayed.takeConsole()).toBe('2000\n2000 -7500\n');
    expect(() => live.input({ type: 'sensor', id: 'accelerometerX', value: 8001 })).toThrow('within -8000 … 8000 mg');
  });

  it('puts the robot and blocks where the hand puts them', async () => {
    const scene = sceneWith({ id: 'box', type: 'block', at: [500, 450], size: [50, 50] });
    const simulation = await start('', { scene });
    simulation.input({ type: 'place', pose: { xMm: 700, yMm: 200, headingDeg: 90 } });
    simulation.input({ type: 'place-block', id: 'box', pose: { xMm: 100, yMm: 100, headingDeg: 45 } });
    simulation.advanceTo(100_000);
    const { robot, blocks } = simulation.snapshot();
    expect(robot?.pose).toMatchObject({ xMm: 700, yMm: 200 });
    expect(robot?.pose.headingRad).toBeCloseTo(Math.PI / 2, 9);
    expect(blocks.box?.xMm).toBeCloseTo(100, 6);
  });

  it('feeds the serial line', async () => {
    const inputs = [{ timeUs: 50_000, action: { type: 'serial', text: 'Ada\r' } } as const];
    const simulation = await runFor("print('Hello', input('Name? '))", 500, { inputs });
    expect(simulation.takeConsole()).toContain('Hello Ada');
  });

  it('interrupts a program that never ends, and so does the replay', async () => {
    const simulation = await start('while True: pass');
    simulation.advanceTo(100_000);
    simulation.interrupt();
    simulation.advanceTo(200_000);
    expect(simulation.ended).toMatchObject({ kind: 'stopped', exception: { type: 'KeyboardInterrupt' } });
    const replayed = await runFor('while True: pass', 200, { inputs: simulation.inputLog });
    expect(replayed.ended).toEqual(simulation.ended);
  });

  it.each([
    [{ type: 'sensor', id: 'lightLevel', value: 999 }, /lightLevel: 999 is not a number within 0 … 255/],
    [{ type: 'sensor', id: 'smell', value: 1 }, /no sensor "smell"\. Known are/],
    [{ type: 'touch', pad: 'pin7', down: true }, /no sensor "pin7"/],
    [{ type: 'place', pose: { xMm: -1, yMm: 2, headingDeg: 0 } }, /xMm: -1 is not within 0 … 1200/],
    [{ type: 'place', pose: { xMm: 1, yMm: NaN, headingDeg: 0 } }, /yMm: NaN/],
    [
      { type: 'place-block', id: 'q', pose: { xMm: 1, yMm: 2, headingDeg: 0 } },
      /no movable block "q"\. This course has none/,
    ],
  ] as const)('refuses %j', async (action, message) => {
    const simulation = await start('');
    expect(() => simulation.input(action)).toThrow(message);
    const inputs = [{ timeUs: 0, action }];
    await expect(start('', { inputs })).rejects.toThrow(message);
    await expect(start('', { inputs })).rejects.toThrow('[0]: ');
  });
});

describe('what a run tells the outside', { timeout: 30_000 }, () => {
  const outside = { robot: 'none' };

  it('is each packet sent by radio, with its time, and what comes by radio reaches the program', async () => {
    const packets: RadioPacket[] = [];
    const program = lines(
      'import radio',
      'from microbit import *',
      'radio.config(group=7)',
      'while True:',
      '  text = radio.receive()',
      '  if text:',
      '    radio.send(text + "!")',
      '  sleep(10)',
    );
    const inputs = [{ timeUs: 100_000, action: { type: 'radio' as const, text: 'go' } }];
    const simulation = await Simulation.create(setupOf(program, { ...outside, inputs }), firmware, {
      radio: (packet) => packets.push(packet),
    });
    simulation.advanceTo(300_000);
    expect(packets.map(({ bytes }) => String.fromCharCode(...bytes))).toEqual(['\x01\x00\x01go!']);
    expect(packets[0]?.group).toBe(7);
    expect(packets[0]?.timeUs).toBeGreaterThan(100_000);
    expect(packets[0]?.timeUs).toBeLessThan(120_000);
  });

  it('is each row of the data log with its headings', async () => {
    const events: TimedLogEvent[] = [];
    const program = lines('import log', 'log.set_labels("light", timestamp=None)', 'log.add(light=3)', 'log.delete()');
    const simulation = await Simulation.create(setupOf(program, outside), firmware, {
      log: (event) => events.push(event),
    });
    simulation.advanceTo(500_000);
    const rows = events.filter(({ type }) => type === 'row');
    expect(rows.at(-1)).toMatchObject({ headings: ['light'], values: ['3'] });
    expect(events.at(-1)?.type).toBe('clear');
  });

  it('is the tone of the music, when it begins and when it ends', async () => {
    const heard: SoundEvent[] = [];
    const program = lines('import music', 'music.pitch(440, 100)');
    const simulation = await Simulation.create(setupOf(program, outside), firmware, {
      sound: (event) => heard.push(event),
    });
    simulation.advanceTo(500_000);
    const tones = heard.flatMap((event) => (event.type === 'tone' ? [event] : []));
    expect(tones.map(({ hz }) => hz && Math.round(hz))).toEqual([440, null]);
    expect(((tones[1]?.timeUs ?? 0) - (tones[0]?.timeUs ?? 0)) / 1000).toBeCloseTo(100, -1);
  });

  it('is what every sensor feels, and what the arena lets it feel when that is switched on', async () => {
    const inputs = [
      { timeUs: 0, action: { type: 'sensor' as const, id: 'lightLevel', value: 9 } },
      { timeUs: 50_000, action: { type: 'arena-senses' as const, on: true } },
    ];
    const simulation = await start('', { inputs });
    simulation.advanceTo(20_000);
    expect(simulation.snapshot().sensors).toMatchObject({ lightLevel: 9, temperature: 21, gesture: 'none' });
    simulation.advanceTo(60_000);
    expect(simulation.snapshot()).toMatchObject({
      arenaSenses: true,
      sensors: { lightLevel: 255, compassHeading: 90 },
    });
  });
});

describe('what a run is made of', { timeout: 30_000 }, () => {
  it('is a Maqueen Lite on a micro:bit V2 unless something else is asked for', async () => {
    expect((await start('')).snapshot().robot?.type).toBe('maqueen-lite');
    expect((await start('', { robot: 'none' })).snapshot().robot).toBeNull();
  });

  it('answers a driver with OSError 19 when there is no robot', async () => {
    const program = lines(
      'from microbit import i2c',
      'try:',
      '  i2c.write(0x10, bytes(3))',
      'except OSError as e:',
      '  print(e)',
    );
    expect((await runFor(program, 100, { robot: 'none' })).takeConsole()).toMatch(/19/);
  });

  it.each([
    [{ robot: 'tank' }, /Unknown robot "tank"\. Known robots: maqueen-lite, .*none\./],
    [{ board: 'arduino' }, 'Unknown board "arduino". Known boards: microbit-v2, calliope-mini-3.'],
    [{ scene: sceneWithOptions('tank', {}) }, /^robot\.type: Unknown robot "tank"\. Known robots: maqueen-lite, /],
    [
      { scene: { ...defaultScene(), board: 'arduino' } },
      /^board: Unknown board "arduino"\. Known boards: microbit-v2, /,
    ],
    [{ firmware: 'v9' }, 'Unknown firmware "v9". Known firmwares of the micro:bit V2: v2.1.2, newest.'],
    [{ reality: 1.5 }, 'Reality 1.5 is not within 0 (ideal) … 1 (like a used school robot).'],
    [
      { robot: 'maqueen-lite', robotOptions: { S9: 'claw' } },
      /Maqueen Lite: there is no option "S9"\. Known: S1, S2, /,
    ],
    [
      { robot: 'maqueen-lite', robotOptions: { S1: 'laser' } },
      /Maqueen Lite: "laser" is no choice of S1\. Known: none/,
    ],
  ])('is refused for %j', async (change, message) => {
    await expect(start('', change)).rejects.toThrow(message);
  });

  it('is a Calliope mini 3 on a Calli:bot when the program imports its module', async () => {
    const program = lines('from calliopemini import *', 'display.show("7")');
    const simulation = await runFor(program, 50, hardwareIds(guessed(program)));
    const { board, robot, rgb, motors } = simulation.snapshot();
    expect({ board, robot: robot?.type, lights: rgb.length, motors }).toEqual({
      board: 'calliope-mini-3',
      robot: 'callibot',
      lights: 3,
      motors: [0, 0],
    });
  });

  it.each([
    ['maqueen-lite', 'calliope-mini-3', 0x10],
    ['callibot', 'microbit-v2', 0x20],
  ])('gives ENODEV when a %s stands on a %s', async (robot, board, address) => {
    const program = lines(
      'from microbit import i2c',
      'try:',
      `  i2c.write(${address}, bytes(3))`,
      'except OSError as e:',
      '  print(e.args[0])',
    );
    const simulation = await runFor(program, 100, { robot, board });
    expect(simulation.takeConsole()).toBe('19\n');
    expect(simulation.snapshot().robot?.type).toBe(robot);
  });

  it.each([
    ['from mbrobot import *', 'maqueen-lite', 'microbit-v2'],
    ['import maqueen', 'maqueen-lite', 'microbit-v2'],
    ['from mbrobot_plusV2 import *', 'maqueen-plus-v2', 'microbit-v2'],
    ['import MaqueenPlus_V2', 'maqueen-plus-v2', 'microbit-v2'],
    ['from mbrobot_plus import forward', 'maqueen-plus-v1', 'microbit-v2'],
    ['import callibotmot', 'callibot', 'calliope-mini-3'],
    ['from callibot2 import Callibot2', 'callibot', 'calliope-mini-3'],
    ['from microbit import *', 'maqueen-lite', 'microbit-v2'],
  ])('is chosen by "%s": a %s on a %s', (program, robot, board) => {
    const hardware = guessed(program);
    expect([hardware.robot?.id, hardware.board.id]).toEqual([robot, board]);
  });

  it('takes the options of the course, and those wished for before them', () => {
    const wish = {
      scene: sceneWithOptions('maqueen-lite', { echo: 'long-pulse' }),
      imports: new Set<string>(),
      robot: 'auto',
      board: 'auto',
    };
    expect(chosen(wish).options['echo']).toBe('long-pulse');
    expect(chosen({ ...wish, robotOptions: { echo: 'none' } }).options['echo']).toBe('none');
  });

  it('refuses a course that names an option its robot does not have, and overlooks it for another robot', () => {
    const scene = sceneWithOptions('maqueen-lite', { model: '2E' });
    const wish = { scene, imports: new Set<string>(), robot: 'auto', board: 'auto' };
    expect(chooseHardware(wish)).toEqual({
      problem: expect.stringMatching(/^robot\.options: there is no option "model"/),
    });
    expect(chosen({ ...wish, robot: 'callibot' }).options['model']).toBe('2E');
  });

  it('is refused when the real outline of the robot stands in a wall', async () => {
    const scene = sceneWith({ id: 'w', type: 'wall', from: [350, 400], to: [350, 500] });
    await expect(start('', { scene })).rejects.toThrow(
      /robot.at: at \[300, 450\] the robot stands inside the wall "w"/,
    );
  });
});

describe('the fingerprint of a trajectory', () => {
  it('is the SHA-256 of its rows: time in ms, x, y and heading as little-endian doubles', () => {
    const hash = createTraceHash();
    // printf of the 32 bytes of (20, 1.5, -0 as 0, 3) into sha256sum
    expect(hash.hex()).toBe('e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855');
    hash.add(20_000, 1.5, -0, 3);
    expect(hash.hex()).toBe('2757c988030ead90f0d9eeb70e259bc0db49de4032bca2114703394aa3d58cca');
  });
});
