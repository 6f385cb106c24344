import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachWs2812 } from '#devices/ws2812';
import { runOnWires } from '../testing/wires';
import type { LineName } from '../maqueen-plus-frame';
import { createController } from './controller';
import { maqueenPlusV2Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Surroundings {
  /** False: no robot on the bus. */
  readonly isOn?: boolean;
  readonly distanceMm?: number;
  /** Sensors on black. */
  readonly black?: readonly LineName[];
  readonly forMs?: number;
}

/** Runs a program that has imported everything from the library, and listens to the wires. */
function run(program: string, { isOn = true, distanceMm = Infinity, black = [], forMs }: Surroundings = {}) {
  const values: Record<LineName, number> = { R2: 101, R1: 102, M: 103, L1: 104, L2: 105 };
  const controller = createController(
    {
      motors: () => undefined,
      leds: () => undefined,
      isBright: (name) => !black.includes(name),
      brightness: (name) => values[name],
    },
    { version: '2.1', analogOrder: 'R2-first' },
  );
  let rgb: readonly Rgb[] = [];
  const result = runOnWires(`from mbrobot_plusV2 import *\n${program}`, {
    build: maqueenPlusV2Build,
    firmware,
    chips: isOn ? { 0x10: controller } : {},
    connect: (board, clock) => {
      attachHcSr04(clock, { trigger: board.wire('P13'), echo: board.wire('P14') }, () => distanceMm);
      const chain = attachWs2812(board.wire('P15'), 4);
      board.wire('P15').onStream(() => (rgb = chain.colors()));
    },
    ...(forMs === undefined ? {} : { forMs }),
  });
  return { ...result, rgb };
}

/** The bytes sent to 0x10 by a program that ends without an exception. */
function bytesOf(program: string, surroundings?: Surroundings): readonly (readonly number[])[] {
  const { messages, exception } = run(program, surroundings);
  expect(exception).toBeNull();
  return messages;
}

describe('mbrobot_plusV2: driving, byte by byte (Tiger-Jython Robotics-Libraries mbrobot_plusV2.py)', () => {
  it.each([
    ['pass', []], // the import sends nothing
    ['setSpeed(80)', []],
    ['forward()', [[0, 0, 50, 0, 50]]],
    ['backward()', [[0, 1, 50, 1, 50]]],
    ['left()', [[0, 1, 50, 0, 50]]],
    ['right()', [[0, 0, 50, 1, 50]]],
    ['stop()', [[0, 0, 0, 0, 0]]],
    ['setSpeed(80); resetSpeed(); forward()', [[0, 0, 50, 0, 50]]],
    ['setSpeed(0); forward()', [[0, 0, 0, 0, 0]]],
    ['setSpeed(-20); forward()', [[0, 0, 0, 0, 0]]],
    ['setSpeed(500); forward()', [[0, 0, 255, 0, 255]]],
    ['setSpeed(77.9); forward()', [[0, 0, 97, 0, 97]]],
  ])('%s sends %j', (program, messages) => {
    expect(bytesOf(program)).toEqual(messages);
  });

  it('has the power bytes 21 27 33 39 50 59 77 109 162 255 for 10 to 100 percent', () => {
    const messages = bytesOf('for s in range(10, 101, 10):\n    setSpeed(s)\n    forward()');
    expect(messages.map((message) => message[2])).toEqual([21, 27, 33, 39, 50, 59, 77, 109, 162, 255]);
  });

  it.each([
    ['leftArc(0.05)', [0, 0, 0, 0, 50]], // below 6 cm the inner wheel stands
    ['leftArc(0.1)', [0, 0, 15, 0, 50]],
    ['rightArc(0.2)', [0, 0, 50, 0, 16]],
    ['leftArc(0.3)', [0, 0, 19, 0, 50]],
    ['leftArc(0.5)', [0, 0, 25, 0, 50]],
    ['leftArc(1)', [0, 0, 31, 0, 50]],
    ['setSpeed(10); leftArc(0.2)', [0, 0, 16, 0, 30]], // at least 25 percent
    ['setSpeed(70); leftArc(0.2)', [0, 0, 18, 0, 77]],
    ['setSpeed(100); leftArc(0.2)', [0, 0, 27, 0, 255]],
    ['calibrate(20, 30); leftArc(0.2)', [0, 0, 16, 0, 50]], // offset and differential are for straight driving
    ['calibrate(0, 0, -50); leftArc(0.41)', [0, 0, 0x10, 0, 50]], // the formula divides by 0 there
  ])('%s sends %j', (program, message) => {
    expect(bytesOf(program)).toEqual([message]);
  });

  it.each([
    ['calibrate(10)', 60, 60],
    ['calibrate(99)', 100, 100], // at most 50
    ['calibrate(-99)', 36, 36], // at least −14
    ['calibrate(0, 20)', 40, 60], // half of 20 slower left, half faster right at speed 50
    ['calibrate(0, -20)', 60, 40],
    ['setSpeed(100); calibrate(0, 20)', 235, 255],
  ])('%s makes forward() send the powers %i and %i', (program, left, right) => {
    expect(bytesOf(`${program}\nforward()`)).toEqual([[0, 0, left, 0, right]]);
  });

  it('lets one motor turn and keeps the other one', () => {
    expect(bytesOf('motL.rotate(50)\nmotR.rotate(-30)\nmotL.rotate(0)\nmotR.rotate(200)')).toEqual([
      [0, 0, 50, 0, 0],
      [0, 0, 50, 1, 33],
      [0, 1, 0, 1, 33],
      [0, 1, 0, 0, 255],
    ]);
  });
});

describe('mbrobot_plusV2: servos, pulse by pulse', () => {
  it.each([
    ['setServo("P0", 0)', 'P0', 25],
    ['setServo("P1", 90)', 'P1', 77],
    ['setServo("P2", 180)', 'P2', 130],
    ['setServo("S1", 45)', 'P0', 50],
    ['setServo("S2", 135.9)', 'P1', 102],
    ['setMinServoDuty(51); setServo("P0", 0)', 'P0', 51],
    ['setMaxServoDuty(102); setServo("P0", 180)', 'P0', 101],
    ['setMinAngleVal(51); setMaxAngleVal(102); setServo("P0", 90)', 'P0', 75],
  ])('%s makes pulses at %s of %i/1024 of 20 ms, and nothing on the bus', (program, pin, duty) => {
    const { messages, pwm, exception } = run(program);
    expect([messages, exception]).toEqual([[], null]);
    expect(pwm.at(-1)).toBe(`${pin}: 20000 µs, ${duty}/1024`);
  });
});

describe('mbrobot_plusV2: errors', () => {
  it.each([
    ['setServo("P3", 1)', "ValueError: Unknown Servo. Please use 'P0', 'P1' or 'P2'."],
    ['setServo("P0", 181)', 'ValueError: Invalid angle. Must be between 0 and 180'],
    ['setServo("P0", -1)', 'ValueError: Invalid angle. Must be between 0 and 180'],
    ['posRGB(4, 0, 0, 0)', 'ValueError: invalid RGB-LED position. Must be 0,1,2 or 3.'],
    ['setRGB(-1, 0, 0, 0)', 'ValueError: invalid RGB-LED position. Must be 0,1,2 or 3.'],
  ])('%s raises %s', (program, exception) => {
    expect(run(program).exception).toBe(exception);
  });

  it.each(['forward()', 'stop()', 'leftArc(0.2)', 'motL.rotate(10)', 'irM.read_digital()', 'irM.read_analog()'])(
    'asks to switch the robot on when it does not answer to %s',
    (program) => {
      const message = 'RuntimeError: Please connect to Maqueen robot and switch it on.';
      expect(run(program, { isOn: false }).exception).toBe(message);
    },
  );

  it.each(['setLED(1)', 'ir_read_values_as_byte()'])('%s gives the bus error as it is: ENODEV', (program) => {
    expect(run(program, { isOn: false }).exception).toBe('OSError: [Errno 19] ENODEV');
  });
});

describe('mbrobot_plusV2: sensors', () => {
  const all = 'irL2, irL1, irM, irR1, irR2';

  it.each([
    [[], '1 1 1 1 1'],
    [['L2'], '0 1 1 1 1'],
    [['L1'], '1 0 1 1 1'],
    [['M'], '1 1 0 1 1'],
    [['R1'], '1 1 1 0 1'],
    [['R2'], '1 1 1 1 0'],
  ] as const)('with %j on black, L2 L1 M R1 R2 read %s', (black, expected) => {
    const { lines, messages } = run(`print(*[s.read_digital() for s in (${all})])`, { black });
    expect(lines).toEqual([expected]);
    expect(messages).toEqual(Array(5).fill([0x1d]));
  });

  it('reads the values 105 104 103 102 101 from left to right', () => {
    expect(run(`print(*[s.read_analog() for s in (${all})])`).lines).toEqual(['105 104 103 102 101']);
  });

  it('has irLeft for L1 and irRight for R1', () => {
    expect(run('print(irLeft is irL1, irRight is irR1)').lines).toEqual(['True True']);
  });

  it('gives all bits turned around: −5 with M alone on black, and masks for them', () => {
    const program = 'b = ir_read_values_as_byte()\nprint(b, [1 if b & m else 0 for m in IR.masks], IR.M, IR.L2)';
    expect(run(program, { black: ['M'] }).lines).toEqual(['-5 [1, 1, 0, 1, 1] 2 4']);
  });

  it.each([
    [50, 5],
    [304, 30],
    [700, 70],
    [1000, 100],
    [4400, 440],
    [Infinity, 255],
  ])('getDistance() for a gap of %d mm is %i', (distanceMm, expected) => {
    expect(run('print(getDistance())', { distanceMm }).lines).toEqual([String(expected)]);
  });
});

describe('mbrobot_plusV2: lights and sound', () => {
  it.each([
    ['setLED(1)', [[0x0b, 1, 1]]],
    ['setLED(1, 0)', [[0x0b, 1, 0]]],
    ['setLED(0, stateR=1)', [[0x0b, 0, 1]]],
    ['setLED(LEDState.ON); setLED(LEDState.OFF)', [[0x0b, 1, 1], [0x0b, 0, 0]]], // prettier-ignore
    ['setLEDLeft(LEDState.RED); setLEDRight(1); setLEDLeft(0)', [[0x0b, 1, 0], [0x0b, 1, 1], [0x0b, 0, 1]]], // prettier-ignore
  ])('%s sends %j', (program, messages) => {
    expect(bytesOf(program)).toEqual(messages);
  });

  it.each([
    ['fillRGB(1, 2, 3)', '1,2,3 1,2,3 1,2,3 1,2,3'],
    ['setRGB(1, 2, 3)', '1,2,3 1,2,3 1,2,3 1,2,3'],
    ['setRGB(red=1, green=2, blue=3)', '1,2,3 1,2,3 1,2,3 1,2,3'],
    ['setRGB(2, 1, 2, 3)', '0,0,0 0,0,0 1,2,3 0,0,0'],
    ['setRGB(position=0, red=1, green=2, blue=3)', '1,2,3 0,0,0 0,0,0 0,0,0'],
    ['posRGB(3, 1, 2, 3)', '0,0,0 0,0,0 0,0,0 1,2,3'],
    ['fillRGB(1, 2, 3); clearRGB()', '0,0,0 0,0,0 0,0,0 0,0,0'],
    ['np_rgb_pixels[1] = (5, 6, 7); np_rgb_pixels.show()', '0,0,0 5,6,7 0,0,0 0,0,0'],
  ])('%s makes the colour lights %s', (program, colors) => {
    const { rgb, exception } = run(program);
    expect(exception).toBeNull();
    expect(rgb.map(String).join(' ')).toBe(colors);
  });

  it('beeps at 440 Hz for 200 ms and goes on meanwhile', () => {
    const { lines, tones } = run(
      'import utime\nt = utime.ticks_ms()\nbeep()\nprint(utime.ticks_ms() - t < 20)\ndelay(500)',
    );
    expect(lines).toEqual(['True']);
    expect([tones[0], tones.at(-1)]).toEqual([440, 0]);
  });

  it('sounds the alarm at 523 Hz (C5) in the background until it is switched off', () => {
    const { tones } = run('setAlarm(1)\ndelay(2000)\nsetAlarm(0)\ndelay(100)');
    expect(new Set(tones.filter((tone) => tone > 0))).toEqual(new Set([523]));
    expect(tones.filter((tone) => tone > 0).length).toBeGreaterThan(2);
    expect(tones.at(-1)).toBe(0);
  });
});
