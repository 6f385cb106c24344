import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { parseSceneValue } from '#scene/parse';
import { defaultScene, type Scene, type SceneObject, type Start } from '#scene/scene';
import { fitDevices } from './fit-devices';
import type { DeviceSetup, RunSetup } from './run-setup';
import { Simulation } from './simulation';
import { convoyOf } from './testing/convoy';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const lines = (...texts: string[]): string => texts.join('\n');

const board = (name: string, ...program: string[]): DeviceSetup => ({
  name,
  files: { 'main.py': lines('from microbit import *', 'import radio', ...program) },
  robot: 'none',
  board: 'microbit-v2',
});

const maqueen = (name: string, at: readonly [number, number], heading: number, ...program: string[]): DeviceSetup => ({
  name,
  files: { 'main.py': lines('from mbrobot import *', ...program) },
  robot: 'maqueen-lite',
  board: 'microbit-v2',
  start: { type: null, at, heading, scale: 1, options: {} },
});

type Devices = RunSetup['devices'];

const setupOf = (devices: Devices, change: Partial<RunSetup> = {}): RunSetup => ({
  scene: defaultScene(),
  devices,
  seed: 1,
  reality: 0,
  ...change,
});

async function run(ms: number, devices: Devices, change: Partial<RunSetup> = {}): Promise<Simulation> {
  const simulation = await Simulation.create(setupOf(devices, change), firmware);
  simulation.advanceTo(ms * 1000);
  return simulation;
}

const LISTEN = [
  'radio.on()',
  'while True:',
  '  message = radio.receive()',
  '  if message: print(message)',
  '  sleep(5)',
];

describe('a board with the arena’s senses', { timeout: 60_000 }, () => {
  const listens = (on: boolean) => {
    const singer = maqueen(
      'singer',
      [300, 300],
      0,
      'from microbit import *',
      'import music',
      'sleep(200)',
      'music.pitch(440, 300)',
    );
    const level = 'print(microphone.sound_level() > 100)';
    const listener = maqueen('listener', [300, 500], 0, 'from microbit import *', level, 'sleep(300)', level, 'sleep(400)', level); // prettier-ignore
    const inputs = [{ timeUs: 0, device: 'listener', action: { type: 'arena-senses', on } }] as const;
    return run(1500, [singer, listener], { inputs });
  };

  it('hears the tone of its neighbour, as long as it sounds', async () => {
    expect((await listens(true)).takeConsole(1)).toBe('False\nTrue\nFalse\n');
  });

  it('hears nothing while they are off, as they are at first', async () => {
    expect((await listens(false)).takeConsole(1)).toBe('False\nFalse\nFalse\n');
  });
});

describe('two boards', { timeout: 60_000 }, () => {
  it('hear each other by radio', async () => {
    const both = await run(1000, [
      board('sender', 'radio.on()', 'sleep(100)', 'for n in range(3):', '  radio.send("n=" + str(n))', '  sleep(50)'),
      board('receiver', ...LISTEN),
    ]);
    expect(both.takeConsole(1)).toBe('n=0\nn=1\nn=2\n');
    expect(both.takeConsole(0)).toBe('');
  });

  it('answer each other, whichever stands first', async () => {
    const ask = board('ask', 'radio.on()', 'sleep(50)', 'radio.send("2+3")', 'sleep(100)', 'print(radio.receive())');
    const answer = board('answer', 'radio.on()', 'while True:', '  t = radio.receive()', '  if t: radio.send(str(eval(t)))', '  sleep(1)'); // prettier-ignore
    expect((await run(500, [ask, answer])).takeConsole(0)).toBe('5\n');
    expect((await run(500, [answer, ask])).takeConsole(1)).toBe('5\n');
  });

  it.each([
    ['group', 'group=7'],
    ['channel', 'channel=9'],
    ['address', 'address=0x11223344'],
    ['data rate', 'data_rate=radio.RATE_2MBIT'],
  ])('hear nothing of each other when the %s differs, and everything when it is the same again', async (_, other) => {
    const send = ['radio.on()', 'sleep(100)', 'radio.send("one")', 'sleep(200)', `radio.config(${other})`, 'radio.send("two")']; // prettier-ignore
    const both = await run(600, [board('sender', ...send), board('receiver', `radio.config(${other})`, ...LISTEN)]);
    expect(both.takeConsole(1)).toBe('two\n');
  });

  it('lose what is too much for the queue', async () => {
    const send = ['radio.on()', 'sleep(100)', 'for n in range(10):', '  radio.send("x" * 28)'];
    const receive = ['radio.on()', 'sleep(400)', 'n = 0', 'while radio.receive(): n += 1', 'print(n)'];
    expect((await run(900, [board('sender', ...send), board('receiver', ...receive)])).takeConsole(1)).toBe('3\n');
  });

  it('know how strong a message was and when it came', async () => {
    const send = ['radio.on()', 'sleep(100)', 'radio.send("hello")'];
    const receive = ['radio.on()', 'sleep(300)', 'print(radio.receive_full())'];
    const both = await run(900, [board('sender', ...send), board('receiver', ...receive)]);
    const [, strength, time] = /, (-\d+), (\d+)\)/.exec(both.takeConsole(1)) ?? [];
    expect(Number(strength)).toBe(-24); // as close as two boards can be
    expect(Number(time)).toBeGreaterThan(100_000);
    expect(Number(time)).toBeLessThan(112_000);
  });
});

const SIGNAL = ['radio.on()', 'while True:', '  got = radio.receive_full()', '  if got: print(got[1])', '  delay(20)'];
const BEACON = ['import radio', 'radio.on()', 'while True:', '  radio.send("here")', '  delay(100)'];

describe('a message by radio', { timeout: 60_000 }, () => {
  it('is the weaker the farther away it comes from', async () => {
    const strengthAt = async (x: number): Promise<number> => {
      const hears = maqueen('hears', [100, 450], 0, 'import radio', ...SIGNAL);
      const both = await run(400, [maqueen('sends', [x, 450], 0, ...BEACON), hears]);
      return Number(both.takeConsole(1).split('\n')[0]);
    };
    const [near, middle, far] = [await strengthAt(300), await strengthAt(600), await strengthAt(1100)];
    expect([near, middle, far]).toEqual([-36, -44, -50]);
  });

  it('is weaker with less power', async () => {
    const sends = maqueen('sends', [1100, 450], 0, 'import radio', 'radio.config(power=0)', ...BEACON);
    const both = await run(400, [sends, maqueen('hears', [100, 450], 0, 'import radio', ...SIGNAL)]);
    expect(Number(both.takeConsole(1).split('\n')[0])).toBe(-80);
  });

  it('is lost now and then on used devices, always the same ones', async () => {
    const send = ['radio.on()', 'for n in range(300):', '  radio.send(str(n))', '  sleep(10)'];
    const devices: Devices = [board('sender', ...send), board('receiver', ...LISTEN)];
    const [used, again] = [await run(5000, devices, { reality: 1 }), await run(5000, devices, { reality: 1 })];
    const heard = used.takeConsole(1);
    expect(heard.trim().split('\n').length).toBeLessThan(300);
    expect(heard.trim().split('\n').length).toBeGreaterThan(280);
    expect(again.takeConsole(1)).toBe(heard);
  });

  it('is disturbed by another at the same time, where devices are used ones', async () => {
    const send = ['radio.on()', 'sleep(100)', 'for n in range(20):', '  radio.send("x" * 28)', '  sleep(10)'];
    const receive = ['radio.config(queue=60)', 'radio.on()', 'sleep(900)', 'n = 0', 'while radio.receive(): n += 1', 'print(n)']; // prettier-ignore
    const devices: Devices = [board('one', ...send), board('other', ...send), board('receiver', ...receive)];
    expect((await run(1500, devices)).takeConsole(2)).toBe('40\n');
    expect(Number((await run(1500, devices, { reality: 1 })).takeConsole(2))).toBeLessThan(10);
  });

  it('reaches all if it is put in by hand, or the one that is named', async () => {
    const devices: Devices = [board('a', ...LISTEN), board('b', ...LISTEN)];
    const inputs = [
      { timeUs: 100_000, action: { type: 'radio' as const, text: 'all' } },
      { timeUs: 200_000, device: 'b', action: { type: 'radio' as const, text: 'only b' } },
    ];
    const both = await run(500, devices, { inputs });
    expect([both.takeConsole(0), both.takeConsole(1)]).toEqual(['all\n', 'all\nonly b\n']);
  });
});

describe('several robots', { timeout: 60_000 }, () => {
  it('see each other with the ultrasonic sensor', async () => {
    const look = ['while True:', '  print(getDistance())', '  delay(100)'];
    const both = await run(150, [maqueen('looks', [300, 450], 0, ...look), maqueen('stands', [700, 450], 90, 'pass')]);
    const cm = Number(both.takeConsole(0).split('\n')[0]);
    expect(cm).toBeGreaterThan(25);
    expect(cm).toBeLessThan(32);
  });

  it('push each other', async () => {
    const both = await run(4000, [
      maqueen('stands', [700, 450], 90, 'pass'),
      maqueen('drives', [300, 450], 0, 'setSpeed(80)', 'forward()', 'delay(3000)', 'stop()'),
    ]);
    const { robot, others } = both.snapshot();
    expect(robot?.pose.xMm).toBeGreaterThan(705);
    expect(others[0]?.robot?.collisions).toBeGreaterThan(0);
  });

  it('find what another has moved', async () => {
    const block = { id: 'b', type: 'block', at: [700, 450], size: [60, 60] };
    const parsed = parseSceneValue({
      format: 'parcours-scene',
      version: 1,
      robot: { at: [300, 450] },
      objects: [block],
    });
    if (!('scene' in parsed)) throw new Error(parsed.problem);
    const look = ['while True:', '  print(getDistance())', '  delay(100)'];
    const both = await run(
      4000,
      [
        maqueen('drives', [300, 450], 0, 'setSpeed(60)', 'forward()', 'delay(2500)', 'stop()'),
        maqueen('looks', [1100, 450], 180, ...look),
      ],
      { scene: parsed.scene },
    );
    const distances = both.takeConsole(1).trim().split('\n').map(Number);
    expect(distances.at(-1)).toBeLessThan((distances[0] ?? 0) - 8);
  });

  it('take the course’s start and the places beside it', async () => {
    const { start: _, ...free } = maqueen('', [0, 0], 0, 'pass');
    const names = ['a', 'b', 'c', 'd'];
    const all = await run(20, names.map((name) => ({ ...free, name })) as unknown as Devices);
    const { robot, others } = all.snapshot();
    const poses = [robot, ...others.map((other) => other.robot)].map((it) => it?.pose);
    expect(poses[0]).toMatchObject({ xMm: 600, yMm: 450 });
    expect(new Set(poses.map((pose) => `${String(pose?.xMm)} ${String(pose?.yMm)}`)).size).toBe(4);
    expect(others.every((other) => other.robot?.collisions === 0)).toBe(true);
  });
});

describe('the starts of a course', { timeout: 60_000 }, () => {
  const start = (id: string, at: readonly [number, number], more: Partial<Start> = {}): Start => ({
    ...{ type: 'start', id, at, heading: 90, robot: null, options: {}, name: '', color: null },
    ...more,
  });
  const { start: _, ...free } = maqueen('', [0, 0], 0, 'pass');
  const robots = (...names: string[]) => names.map((name) => ({ ...free, name })) as unknown as Devices;
  const courseWith = (...objects: SceneObject[]): Scene => ({ ...defaultScene(), objects });
  const posesIn = async (scene: Scene, devices: Devices) => {
    const { robot, others } = (await run(20, devices, { scene })).snapshot();
    return [robot, ...others.map((other) => other.robot)].map((it) => it && [it.pose.xMm, it.pose.yMm]);
  };

  it('belong to the robots after the first in their order; a board without robot has none', async () => {
    const scene = courseWith(start('one', [200, 200]), start('two', [1000, 700], { heading: 0 }));
    const [first, ...others] = robots('a', 'b', 'c');
    const devices = [first, board('remote', 'pass'), ...others] as unknown as Devices;
    expect(await posesIn(scene, devices)).toEqual([[600, 450], null, [200, 200], [1000, 700]]);
  });

  it('may be fewer than robots: the next one stands beside the first', async () => {
    const [first, second, third] = await posesIn(courseWith(start('one', [200, 200])), robots('a', 'b', 'c'));
    expect([first, second]).toEqual([[600, 450], [200, 200]]); // prettier-ignore
    expect(Math.abs((third?.[1] ?? 0) - 450)).toBeGreaterThan(100);
  });

  it('choose the robot and its options where the device leaves it open', () => {
    const scene = courseWith(start('one', [200, 200], { robot: 'callibot', options: { S1: 'claw' } }));
    const fitted = fitDevices(setupOf([free, { ...free, name: 'b', robot: 'auto', board: 'auto' }], { scene }));
    const second = 'problem' in fitted ? null : fitted.devices[1]?.hardware;
    expect([second?.robot?.id, second?.options['S1']]).toEqual(['callibot', 'claw']);
  });

  it('are reported with device and place if they are in a wall or on another robot', () => {
    const problemOf = (...objects: SceneObject[]) => {
      const fitted = fitDevices(setupOf(robots('a', 'b'), { scene: courseWith(...objects) }));
      return 'problem' in fitted ? fitted.problem : '';
    };
    const wall: SceneObject = { type: 'wall', id: 'w', from: [200, 100], to: [200, 300], thickness: 10 };
    expect(problemOf(wall, start('one', [200, 200]))).toMatch(
      /^Device "b": objects\[1\]\.at: at \[200, 200\] the robot stands inside the wall "w"/,
    );
    expect(problemOf(start('one', [20, 200]))).toMatch(/^Device "b": objects\[0\]\.at: .* not wholly inside the arena/);
    expect(problemOf(start('one', [620, 450]))).toBe(
      'Device "b": At [620, 450] its robot stands on the robot of "a". Move one of them.',
    );
  });

  it('are not felt: a robot drives over one that nobody has', async () => {
    const drives = { ...free, name: 'a', files: { 'main.py': 'from mbrobot import *\nforward()' } };
    const poses = await run(2000, [drives], { scene: courseWith(start('one', [800, 450])) });
    expect(poses.snapshot().robot?.pose.xMm).toBeGreaterThan(900);
    expect(poses.snapshot().robot?.collisions).toBe(0);
  });
});

describe('one device among others', { timeout: 60_000 }, () => {
  const counts = board('counts', 'n = 0', 'while True:', '  n += 1', '  print(n)', '  sleep(100)');

  it.each([
    ['ends', ['print("over")']],
    ['fails', ['1 / 0']],
    ['spins', ['while True: pass']],
    ['spins inside one call', ['sum(range(10**9))']],
    ['runs out of memory', ['a = []', 'while True: a.append([0] * 20)']],
    ['floods the radio', ['radio.on()', 'while True: radio.send("x" * 28)']],
    ['floods the console', ['while True: print("x" * 80)']],
    ['resets itself', ['sleep(200)', 'reset()']],
    ['switches itself off', ['import power', 'power.off()']],
    ['panics', ['panic(20)']],
  ])('leaves the others alone when it %s', async (_, program) => {
    for (const devices of [
      [board('bad', ...program), counts],
      [counts, board('bad', ...program)],
    ] as const) {
      const both = await run(2000, devices);
      const printed = both.takeConsole(devices.indexOf(counts)).trim().split('\n');
      expect(printed.length).toBeGreaterThan(17);
      expect(printed.length).toBeLessThan(22);
    }
  });

  it('is the one whose buttons are pressed', async () => {
    const waits = (name: string) =>
      board(name, 'while True:', '  if button_a.was_pressed(): print("A")', '  sleep(20)');
    const both = await Simulation.create(setupOf([waits('left'), waits('right')]), firmware);
    both.advanceTo(300_000);
    both.input({ type: 'button', button: 'a', down: true }, 'right');
    both.input({ type: 'button', button: 'a', down: false }, 'right');
    both.advanceTo(900_000);
    expect([both.takeConsole(0), both.takeConsole(1)]).toEqual(['', 'A\n']);
    const again = await run(900, [waits('left'), waits('right')], { inputs: both.inputLog });
    expect([again.takeConsole(0), again.takeConsole(1)]).toEqual(['', 'A\n']);
    expect(() => both.input({ type: 'interrupt' }, 'middle')).toThrow(
      'There is no device "middle". Known are "left", "right".',
    );
  });

  it('ends with the others when the run is stopped', async () => {
    const both = await Simulation.create(setupOf([counts, { ...counts, name: 'too' }]), firmware);
    both.advanceTo(300_000);
    both.stop();
    both.advanceTo(400_000);
    expect(both.endings.map((end) => end?.kind)).toEqual(['stopped', 'stopped']);
  });

  it('is waited for until its program has ended, too', async () => {
    const both = await Simulation.create(setupOf([board('short'), board('long', 'sleep(500)')]), firmware);
    both.advanceProgramTo(10_000_000);
    expect(both.hasEnded).toBe(true);
    expect(both.nowUs).toBeGreaterThan(500_000);
    expect(both.nowUs).toBeLessThan(520_000);
  });
});

describe('a run of several devices is refused', () => {
  const refusal = (devices: readonly DeviceSetup[], scene: Scene = defaultScene()) =>
    expect(Simulation.create(setupOf(devices as unknown as Devices, { scene }), firmware)).rejects;

  it('if it has more than eight of them', () =>
    refusal(Array.from({ length: 9 }, (_, n) => board(`board ${n}`))).toThrow('9 devices are too many: at most 8'));

  it('if it has none', () => refusal([]).toThrow('at least one device'));

  it('if it has two of one name', () =>
    refusal([board('a'), board('b'), board('a')]).toThrow('Two devices are named "a". Give one of them another name.'));

  it('if it has a robot on another', () =>
    refusal([maqueen('a', [300, 300], 0), maqueen('b', [330, 300], 0)]).toThrow(
      'Device "b": At [330, 300] its robot stands on the robot of "a". Move one of them.',
    ));

  it('if it has a robot outside the arena', () =>
    refusal([maqueen('a', [300, 300], 0), maqueen('b', [10, 300], 0)]).toThrow(/^Device "b": .*not wholly inside/));

  it('if it has a robot for which there is no room', () => {
    const { start: _, ...free } = maqueen('b', [0, 0], 0);
    const scene = { ...defaultScene(), size: [200, 200] as const, robot: { ...defaultScene().robot, at: [100, 100] as const } }; // prettier-ignore
    return refusal([{ ...free, name: 'a' }, free], scene).toThrow(/^Device "b": There is no room for its robot/);
  });

  it('if it has an input for a device that is not there', async () => {
    const inputs = [{ timeUs: 0, device: 'x', action: { type: 'interrupt' as const } }];
    await expect(Simulation.create(setupOf([board('a')], { inputs }), firmware)).rejects.toThrow(
      '[0]: There is no device "x". Known are "a".',
    );
  });
});

/** Programs of which any may stand on any device. */
const PROGRAMS: readonly (readonly string[])[] = [
  ['radio.on()', 'import random', 'while True:', '  radio.send(str(random.randint(0, 99)))', '  sleep(random.randint(3, 40))'], // prettier-ignore
  ['radio.on()', 'while True:', '  got = radio.receive_full()', '  if got: print(got)', '  display.show(len(str(got)) % 10)'], // prettier-ignore
  ['n = 0', 'while n < 20000: n += 1', 'print(running_time())', '1 / 0'],
  ['while True:', '  print(accelerometer.get_values(), running_time())', '  sleep(33)'],
  [
    'import music',
    'music.play(music.DADADADUM, wait=False)',
    'display.scroll("Hi", wait=False)',
    'sleep(150)',
    'reset()',
  ],
];
const DRIVES: readonly (readonly string[])[] = [
  ['setSpeed(70)', 'while True:', '  forward()', '  delay(300)', '  right()', '  delay(110)'],
  ['while True:', '  if getDistance() < 15: left()', '  else: forward()', '  delay(20)'],
  ['import radio', 'radio.on()', 'while True:', '  forward() if radio.receive() else stop()', '  delay(7)'],
];

/** Number of random set-ups; a thousand take ten minutes. */
const SETUPS = Number(process.env['PARCOURS_DEVICE_SETUPS'] ?? 12);

describe('the same run', { timeout: 600_000 }, () => {
  it.each([
    [2, 'e7ace7badfa684721b1f1c6f1dd9e167cf54043a28de275c3a45af0f60cda5f9'],
    [4, '720d1f8d9c3ec741f59637f1b6fb839899742ea0a48bf1a2359f31feda1b7b0e'],
    [8, '1059f35bd4f785ceef1ce22507d2a7ff6641283cd9ed5ad5a4e06f1dab08b63e'],
  ])('of %s devices is what was recorded', async (count, traceHash) => {
    const simulation = await Simulation.create(convoyOf(count), firmware);
    simulation.advanceTo(20_000_000);
    expect(simulation.traceHash).toBe(traceHash);
    for (let n = 1; n < count; n++) expect(simulation.takeConsole(n)).toContain('ahead');
  });

  it('comes of any set-up, however it is cut into pieces', { timeout: 600_000 + SETUPS * 2000 }, async () => {
    for (let seed = 1; seed <= SETUPS; seed++) {
      const chance = createRng(seed);
      const pick = <T>(list: readonly T[]): T => list[Math.floor(chance.unit() * list.length)]!;
      const devices = Array.from({ length: 1 + Math.floor(chance.unit() * 8) }, (_, n) =>
        chance.unit() < 0.5
          ? board(`d${n}`, ...pick(PROGRAMS))
          : maqueen(`d${n}`, [150 + 250 * (n % 4), 200 + 350 * (n >> 2)], 90 * (n % 4), ...pick(DRIVES)),
      ) as unknown as Devices;
      const setup = setupOf(devices, { seed, reality: seed % 3 === 0 ? 0.7 : 0 });
      const told = async (pieceUs: () => number) => {
        const simulation = await Simulation.create(setup, firmware);
        while (simulation.nowUs < 700_000) simulation.advanceTo(Math.min(simulation.nowUs + pieceUs(), 700_000));
        simulation.advanceTo(720_000);
        const printed = devices.map((_, n) => simulation.takeConsole(n));
        const heap = devices.map((_, n) => simulation.heapFree(n));
        return { hash: simulation.traceHash, printed, heap, snapshot: simulation.snapshot() };
      };
      const whole = await told(() => 700_000);
      expect(await told(() => 1 + Math.floor(chance.unit() * 9000)), `seed ${seed}`).toEqual(whole);
    }
  });
});
