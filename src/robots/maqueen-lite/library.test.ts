import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachWs2812 } from '#devices/ws2812';
import { runOnWires } from '../testing/wires';
import { createController } from './controller';
import { maqueenLiteBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Surroundings {
  /** False: no robot on the bus. */
  readonly isOn?: boolean;
  readonly distanceMm?: number;
  /** Levels of the line sensors, left and right. */
  readonly bright?: readonly [0 | 1, 0 | 1];
  readonly forMs?: number;
}

/** Runs a program with the robot's libraries and listens to the wires. */
function run(program: string, { isOn = true, distanceMm = Infinity, bright = [1, 0], forMs }: Surroundings = {}) {
  const controller = createController({ motors: () => undefined, servo: () => undefined });
  let rgb: readonly Rgb[] = [];
  const result = runOnWires(program, {
    build: maqueenLiteBuild,
    firmware,
    chips: isOn ? { 0x10: controller } : {},
    connect: (board, clock) => {
      attachHcSr04(clock, { trigger: board.wire('P1'), echo: board.wire('P2') }, () => distanceMm);
      board.wire('P13').connect('left').drive(bright[0]);
      board.wire('P14').connect('right').drive(bright[1]);
      const chain = attachWs2812(board.wire('P15'), 4);
      board.wire('P15').onStream(() => (rgb = chain.colors()));
    },
    ...(forMs === undefined ? {} : { forMs }),
  });
  return { ...result, rgb, leds: [result.board.wire('P8').level, result.board.wire('P12').level] };
}

/** The bytes sent to 0x10 by a program that has imported everything from mbrobot. */
const bytesOf = (program: string) => {
  const { messages, exception } = run(`from mbrobot import *\n${program}`);
  expect(exception).toBeNull();
  return messages;
};

/** `Type: message` of the exception that ends a program. */
const exceptionOf = (program: string, surroundings?: Surroundings): string | null =>
  run(`from mbrobot import *\n${program}`, surroundings).exception;

describe('mbrobot: driving, byte by byte (Tiger-Jython Robotics-Libraries mbrobot.py)', () => {
  it.each([
    ['forward()', [0, 0, 40, 0, 40]], // the module starts with power 40
    ['backward()', [0, 1, 40, 1, 40]],
    ['left()', [0, 1, 40, 0, 40]],
    ['right()', [0, 0, 40, 1, 40]],
    ['stop()', [0, 0, 0, 0, 0]],
    ['resetSpeed(); forward()', [0, 0, 39, 0, 39]],
    ['setSpeed(0); forward()', [0, 0, 0, 0, 0]],
    ['setSpeed(-20); forward()', [0, 0, 0, 0, 0]],
    ['setSpeed(500); forward()', [0, 0, 255, 0, 255]],
    ['setSpeed(77.9); forward()', [0, 0, 86, 0, 86]],
  ])('%s sends %j', (program, message) => {
    expect(bytesOf(program)).toEqual([message]);
  });

  it('has the power bytes 15 19 23 30 39 48 65 98 155 255 for 10 to 100 percent', () => {
    const messages = bytesOf('for s in range(10, 101, 10):\n    setSpeed(s)\n    forward()');
    expect(messages.map((message) => message[2])).toEqual([15, 19, 23, 30, 39, 48, 65, 98, 155, 255]);
  });

  it('sends nothing for setSpeed alone', () => {
    expect(bytesOf('setSpeed(80)')).toEqual([]);
  });

  it.each([
    ['leftArc(0.02)', [0, 0, 0, 0, 39]],
    ['leftArc(0.15)', [0, 0, 19, 0, 39]],
    ['rightArc(0.2)', [0, 0, 39, 0, 21]],
    ['rightArc(0.3)', [0, 0, 65, 0, 33]],
    ['leftArc(0.4)', [0, 0, 43, 0, 98]],
    ['leftArc(1)', [0, 0, 112, 0, 255]],
    ['setSpeed(100); leftArc(0.2)', [0, 0, 43, 0, 255]],
    ['setSpeed(30); leftArc(0.2)', [0, 0, 23, 0, 48]],
    ['calibrate(20, 30); leftArc(0.2)', [0, 0, 21, 0, 39]], // power offset and differential are for straight driving
    ['calibrate(0, 0, 50); leftArc(0.2)', [0, 0, 18, 0, 39]],
  ])('%s sends %j', (program, message) => {
    expect(bytesOf(program)).toEqual([message]);
  });

  it.each([
    ['calibrate(10)', 49, 49],
    ['calibrate(99)', 89, 89], // at most 50
    ['calibrate(-99)', 29, 29], // at least −10
    ['calibrate(0, 20)', 29, 49], // half of 20 slower left, half faster right at speed 50
    ['calibrate(0, -20)', 49, 29],
    ['setSpeed(100); calibrate(0, 20)', 235, 255],
  ])('%s makes forward() send the powers %i and %i', (program, left, right) => {
    expect(bytesOf(`${program}\nforward()`)).toEqual([[0, 0, left, 0, right]]);
  });

  it('lets one motor turn and keeps the other one: motL.rotate(50), motR.rotate(-30), motL.rotate(0)', () => {
    expect(bytesOf('motL.rotate(50)\nmotR.rotate(-30)\nmotL.rotate(0)\nmotR.rotate(200)')).toEqual([
      [0, 0, 39, 0, 0],
      [0, 0, 39, 1, 23],
      [0, 1, 0, 1, 23],
      [0, 1, 0, 0, 255],
    ]);
  });

  it('sets servos S1 and S2, also under the names P0 and P1', () => {
    expect(bytesOf('setServo("S1", 90)\nsetServo("S2", 180)\nsetServo("P0", 0)\nsetServo("P1", 1)')).toEqual([
      [0x14, 90],
      [0x15, 180],
      [0x14, 0],
      [0x15, 1],
    ]);
  });
});

describe('mbrobot: errors', () => {
  it.each([
    ['setServo("S3", 1)', "ValueError: Unknown Servo. Please use 'S1' or 'S2'."],
    ['setServo("S1", 181)', 'ValueError: Invalid angle. Must be between 0 and 180'],
    ['setServo("S1", -1)', 'ValueError: Invalid angle. Must be between 0 and 180'],
    ['posRGB(-1, 0, 0, 0)', 'ValueError: invalid RGB-LED position. Must be 0,1,2 or 3.'],
    ['setRGB(4, 0, 0, 0)', 'ValueError: invalid RGB-LED position. Must be 0,1,2 or 3.'],
    ['irLeft.read_analog()', 'NameError: Maqueen Lite does not support reading analog sensor values.'],
  ])('%s raises %s', (program, exception) => {
    expect(exceptionOf(program)).toBe(exception);
  });

  it.each(['forward()', 'stop()', 'leftArc(0.2)', 'motL.rotate(10)', 'setServo("S1", 1)'])(
    'asks to switch the robot on when it does not answer to %s',
    (program) => {
      const message = 'RuntimeError: Please connect to Maqueen robot and switch it on.';
      expect(exceptionOf(program, { isOn: false })).toBe(message);
    },
  );
});

describe('mbrobot: sensors, lights and sound', () => {
  it('reads the line sensors: 1 bright on the left, 0 dark on the right', () => {
    const { lines } = run('from mbrobot import *\nprint(irLeft.read_digital(), irRight.read_digital())');
    expect(lines).toEqual(['1 0']);
  });

  it.each([
    [50, 5],
    [100, 10],
    [304, 30],
    [700, 70],
    [1000, 100],
    [2000, 200],
    [4400, 440],
    [Infinity, 255],
  ])('getDistance() for a gap of %d mm is %i', (distanceMm, expected) => {
    const { lines } = run('from mbrobot import *\nprint(getDistance())', { distanceMm });
    expect(lines).toEqual([String(expected)]);
  });

  it.each([
    ['setLED(1)', [1, 1]],
    ['setLED(1)\nsetLED(0)', [0, 0]],
    ['setLED(1, 0)', [1, 0]],
    ['setLED(0, 1)', [0, 1]],
    ['setLEDLeft(1)', [1, 0]],
    ['setLEDRight(1)', [0, 1]],
  ])('%s makes the red lights %j', (program, expected) => {
    expect(run(`from mbrobot import *\n${program}`).leds).toEqual(expected);
  });

  it('fills, sets and clears the colour lights', () => {
    const filled = run('from mbrobot import *\nfillRGB(1, 2, 3)\nsetRGB(2, 9, 8, 7)');
    expect(filled.rgb).toEqual([
      [1, 2, 3],
      [1, 2, 3],
      [9, 8, 7],
      [1, 2, 3],
    ]);
    const cleared = run('from mbrobot import *\nfillRGB(1, 2, 3)\nclearRGB()');
    expect(cleared.rgb).toEqual(Array(4).fill([0, 0, 0]));
  });

  it('takes setRGB with three values for all four lights, and posRGB for one, as on the Plus V2', () => {
    const { rgb } = run(
      'from mbrobot import *\nsetRGB(1, 2, 3)\nposRGB(0, 9, 8, 7)\nsetRGB(position=3, red=4, green=5, blue=6)',
    );
    expect(rgb).toEqual([
      [9, 8, 7],
      [1, 2, 3],
      [1, 2, 3],
      [4, 5, 6],
    ]);
  });

  it('hands out the colour lights as np_rgb_pixels', () => {
    const { rgb } = run('from mbrobot import *\nnp_rgb_pixels[3] = (5, 6, 7)\nnp_rgb_pixels.show()');
    expect(rgb[3]).toEqual([5, 6, 7]);
  });

  it('beeps at 440 Hz for 200 ms and goes on meanwhile', () => {
    const program =
      'from mbrobot import *\nimport utime\nt = utime.ticks_ms()\nbeep()\nprint(utime.ticks_ms() - t < 20)\ndelay(500)';
    const { lines, tones } = run(program);
    expect(lines).toEqual(['True']);
    expect(tones.slice(0, 1)).toEqual([440]);
    expect(tones.at(-1)).toBe(0);
  });

  it('sounds the alarm at 523 Hz (C5) in the background until it is switched off', () => {
    const { tones } = run('from mbrobot import *\nsetAlarm(1)\ndelay(2000)\nsetAlarm(0)\ndelay(100)');
    expect(new Set(tones.filter((tone) => tone > 0))).toEqual(new Set([523]));
    expect(tones.filter((tone) => tone > 0).length).toBeGreaterThan(2);
    expect(tones.at(-1)).toBe(0);
  });

  it('sleeps with delay: 300 ms', () => {
    const { lines } = run(
      'from mbrobot import *\nimport utime\nt = utime.ticks_ms()\ndelay(300)\nprint(utime.ticks_ms() - t)',
    );
    expect(Math.abs(Number(lines[0]) - 300)).toBeLessThanOrEqual(1);
  });
});

describe('mbrobotmot and mbalarm (Tiger-Jython Aplu-Libraries)', () => {
  it('drives single motors with power bytes in three-byte messages', () => {
    const program = 'from mbrobotmot import *\nmotL.rotate(50)\nmotR.rotate(-70)\nmotR.rotate(0)';
    expect(run(program).messages).toEqual([
      [0, 0, 50],
      [2, 1, 70],
      [2, 0, 0],
    ]);
  });

  it('prints a hint and waits for ever when the robot is off', () => {
    const { lines, hasEnded } = run('from mbrobotmot import *\nmotL.rotate(50)\nprint("no")', { isOn: false });
    expect(lines).toEqual(['Please switch on mbRobot!']);
    expect(hasEnded).toBe(false);
  });

  it('measures 30 cm and lights both lamps', () => {
    const program = 'from mbrobotmot import *\nsetLED(1)\nprint(getDistance(), irLeft.read_digital())';
    const { lines, leds } = run(program, { distanceMm: 300 });
    expect(lines).toEqual(['30 1']);
    expect(leds).toEqual([1, 1]);
  });

  it('has an alarm one octave higher, 1047 Hz (C6), and a beep of 2000 Hz', () => {
    const alarm = run('from mbalarm import *\nimport microbit\nsetAlarm(1)\nmicrobit.sleep(1000)\nsetAlarm(0)');
    expect(Math.abs((alarm.tones[0] ?? 0) - 1047)).toBeLessThan(3);
    const beep = run('from mbalarm import *\nbeep()');
    expect(beep.tones[0]).toBe(2000);
  });
});

describe('drivers in other styles', () => {
  it('measures 30 cm by watching the echo pin with ticks_us', () => {
    const program = `
from microbit import pin1, pin2
import utime
pin1.write_digital(0)
utime.sleep_us(2)
pin1.write_digital(1)
utime.sleep_us(10)
pin1.write_digital(0)
while pin2.read_digital() == 0:
    start = utime.ticks_us()
while pin2.read_digital() == 1:
    end = utime.ticks_us()
print(round(utime.ticks_diff(end, start) * 0.0343 / 2))`;
    expect(run(program, { distanceMm: 300 }).lines).toEqual(['30']);
  });

  it('measures 30 cm with a first pulse of 1 ms and a second one of 20 ms (DFRobot pxt-maqueen)', () => {
    const program = `
from microbit import pin1, pin2, sleep
import machine
pin1.write_digital(1)
sleep(1)
pin1.write_digital(0)
if pin2.read_digital() == 0:
    pin1.write_digital(1)
    sleep(20)
    pin1.write_digital(0)
    print(round(machine.time_pulse_us(pin2, 1, 500 * 58) / 59))`;
    expect(run(program, { distanceMm: 300 }).lines).toEqual(['30']);
  });

  it('finds the robot by scanning the bus and reads its version and motors back', () => {
    const program = `
from microbit import i2c
print(i2c.scan())
i2c.write(0x10, bytes([0x32]))
length = i2c.read(0x10, 1)[0]
i2c.write(0x10, b'\x33')
print(str(i2c.read(0x10, length), 'ascii'))
i2c.write(0x10, bytearray([0, 0, 100]))
i2c.write(0x10, bytearray([2, 1, 80]), False)
i2c.write(0x10, b'\x00', repeat=True)
print(list(i2c.read(0x10, 4)))`;
    expect(run(program).lines).toEqual(['[16]', 'ROB0148-EN-4.0', '[0, 100, 1, 80]']);
  });
});
