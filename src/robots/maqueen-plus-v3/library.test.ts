import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { I2cTarget } from '#board/wires/i2c-bus';
import { putOnFloor } from '../testing/floor';
import { runOnWires } from '../testing/wires';
import { maqueenPlusV3Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** The robot's end: each read gives these bytes. */
const chip = (bytes: readonly number[]): I2cTarget => ({
  write: () => undefined,
  read: (count) => Uint8Array.from(bytes.slice(0, count)),
});

/** The lidar's end as a stream: bytes one after the other, then FF. */
function stream(bytes: readonly number[]): I2cTarget {
  let taken = 0;
  return {
    write: () => undefined,
    read: (count) => {
      const piece = Uint8Array.from({ length: count }, (_, i) => bytes[taken + i] ?? 0xff);
      taken += count;
      return piece;
    },
  };
}

interface Surroundings {
  readonly robot?: readonly number[];
  readonly lidar?: readonly number[];
  /** False: nothing on the bus. */
  readonly isOn?: boolean;
  readonly forMs?: number;
}

/** Runs a program that has imported everything from the library, and listens to the wires. */
function run(program: string, { robot = [0, 0, 0, 0], lidar = [], isOn = true, forMs }: Surroundings = {}) {
  return runOnWires(`from mbrobot_plusV3 import *\n${program}`, {
    build: maqueenPlusV3Build,
    firmware,
    chips: isOn ? { 0x10: chip(robot), 0x33: stream(lidar) } : {},
    ...(forMs === undefined ? {} : { forMs }),
  });
}

/** The bytes sent by a program that ends without an exception. */
function bytesOf(program: string, surroundings?: Surroundings): readonly (readonly number[])[] {
  const { messages, exception } = run(program, surroundings);
  expect(exception).toBeNull();
  return messages;
}

describe('mbrobot_plusV3: driving, byte by byte (Tiger-Jython Robotics-Libraries mbrobot_plusV3.py)', () => {
  it.each([
    ['pass', []], // the import sends nothing
    ['forward()', [[0, 0, 50, 0, 50]]], // before the first setSpeed()
    ['backward()', [[0, 1, 50, 1, 50]]],
    ['left()', [[0, 1, 50, 0, 50]]],
    ['right()', [[0, 0, 50, 1, 50]]],
    ['stop()', [[0, 0, 0, 0, 0]]],
    ['resetSpeed(); forward()', [[0, 0, 134, 0, 134]]],
    ['setSpeed(110); forward()', [[0, 0, 22, 0, 22]]], // 278 is no byte
    ['setSpeed(-10); forward()', [[0, 0, 246, 0, 246]]], // neither is -10
    ['motL.rotate(50); motR.rotate(-30.7)', [[0, 0, 50, 0, 0], [0, 0, 50, 1, 30]]], // prettier-ignore
    ['motL.rotate(0); motR.rotate(200)', [[0, 1, 0, 0, 0], [0, 1, 0, 0, 100]]], // prettier-ignore
  ])('%s sends %j', (program, messages) => {
    expect(bytesOf(program)).toEqual(messages);
  });

  it('has the power bytes 14 38 62 86 134 206 254 for 0 10 20 30 50 80 100 percent', () => {
    const messages = bytesOf('for s in (0, 10, 20, 30, 50, 80, 100):\n    setSpeed(s)\n    forward()');
    expect(messages.map((message) => message[2])).toEqual([14, 38, 62, 86, 134, 206, 254]);
  });

  it.each([
    [
      50,
      [
        [0, 50],
        [15, 50],
        [16, 50],
        [19, 50],
        [25, 50],
        [31, 50],
      ],
    ],
    [
      100,
      [
        [0, 255],
        [15, 255],
        [27, 255],
        [37, 255],
        [55, 255],
        [80, 255],
      ],
    ],
  ])('sends for arcs of 5, 10, 20, 30, 50 and 100 cm at speed %i %j', (speed, powers) => {
    // prettier-ignore
    const arcs = bytesOf(`setSpeed(${speed})\nfor r in (.05, .1, .2, .3, .5, 1):\n    leftArc(r)\n    rightArc(r)`);
    expect(arcs).toEqual(powers.flatMap(([inner, outer]) => [[0, 0, inner, 0, outer], [0, 0, outer, 0, inner]])); // prettier-ignore
  });

  it('drives arcs with at least 25 percent, and takes whole ones within 100', () => {
    expect(bytesOf('setSpeed(10)\nleftArc(0.05)\nsetSpeed(250)\nleftArc(0.05)')).toEqual([
      [0, 0, 0, 0, 30],
      [0, 0, 0, 0, 255],
    ]);
  });
});

describe('mbrobot_plusV3: what the robot does by itself, byte by byte', () => {
  it.each([
    [
      'pidControlDistance(1, 300, 0)',
      [
        [64, 1],
        [85, 2],
        [65, 1],
        [66, 44],
        [60, 6],
      ],
    ],
    [
      'pidControlDistance(2, 7000, 0)',
      [
        [64, 2],
        [85, 2],
        [65, 0xea],
        [66, 0x60],
        [60, 6],
      ],
    ], // 60000: the original's
    [
      'pidControlAngle(90, 0)',
      [
        [67, 1],
        [86, 2],
        [68, 90],
        [60, 6],
      ],
    ],
    [
      'pidControlAngle(-45, 0)',
      [
        [67, 2],
        [86, 2],
        [68, 45],
        [60, 6],
      ],
    ],
    [
      'pidControlAngle(360, 0)',
      [
        [67, 1],
        [86, 2],
        [68, 104],
        [60, 6],
      ],
    ], // one byte
    ['pidControlStop()', [[60, 16]]],
    [
      'setPatrolSpeed(3); patrolling(1); patrolling(2)',
      [
        [63, 3],
        [60, 5],
        [60, 8],
      ],
    ],
    [
      'setIntersectionRunMode(1); setTRordRunMode(2)',
      [
        [69, 1],
        [70, 2],
      ],
    ],
    [
      'setLeftOrStraightRunMode(3); setRightOrStraightRunMode(4)',
      [
        [71, 3],
        [72, 4],
      ],
    ],
    [
      'setLEDs(1, 2); setLED(7)',
      [
        [11, 1],
        [12, 2],
        [11, 7],
        [12, 7],
      ],
    ],
    [
      'setLEDLeft(3); setLEDRight(4)',
      [
        [11, 3],
        [12, 4],
      ],
    ],
  ])('%s sends %j', (program, messages) => {
    // prettier-ignore
    expect(bytesOf(program)).toEqual(messages);
  });

  it('waits with interruption 1 while 87 reads 1: names it once and asks every 10 ms', () => {
    const { messages, hasEnded } = run('pidControlDistance(1, 1, 1)', { robot: [1], forMs: 500 });
    expect([messages.slice(-2), hasEnded]).toEqual([[[60, 6], [87]], false]);
    expect(run('pidControlAngle(1, 1)').hasEnded).toBe(true);
  });
});

describe('mbrobot_plusV3: sensors, byte by byte', () => {
  it('reads line sensors from 29: R2 is bit 0 and comes first, low byte first; 1 is light', () => {
    const robot = [0b01001, 1, 1, 2, 2, 3, 3, 4, 4, 255, 15];
    const digital = 'print(*[s.read_digital() for s in (irL2, irL1, irM, irR1, irR2, irLeft, irRight)])';
    expect(run(digital, { robot }).lines).toEqual(['1 0 1 1 0 0 1']);
    const analog = 'print(*[s.read_analog() for s in (irL2, irL1, irM, irR1, irR2)])';
    const { lines, messages } = run(analog, { robot });
    expect([lines, messages]).toEqual([['4095 1028 771 514 257'], Array(5).fill([29])]);
  });

  it('reads light from 78, high byte first: 1 is the left one', () => {
    const { lines, messages } = run('print(readLightIntensity(1), readLightIntensity(2))', { robot: [1, 244, 2, 0] });
    expect([lines, messages]).toEqual([['500 512'], [[78], [78]]]);
  });

  it('reads speeds after [76, 1], in fifths: 1 is the left one', () => {
    const { lines, messages } = run('print(readRealTimeSpeed(1), readRealTimeSpeed(2))', { robot: [65, 66] });
    expect([lines, messages]).toEqual([
      ['13.0 13.2'],
      [
        [76, 1],
        [76, 1],
      ],
    ]);
  });

  it('reads the junction from 61', () => {
    const { lines, messages } = run('print(intersectionDetecting())', { robot: [4] });
    expect([lines, messages]).toEqual([['4'], [[61]]]);
  });
});

describe('mbrobot_plusV3: the lidar, byte by byte', () => {
  const words = (...values: number[]): number[] => values.flatMap((value) => [value & 255, value >> 8]);

  it.each([
    ['getDistanceAt(3, 4)', [0x55, 0, 3, 3, 3, 4], [0xff, 0x53, 3, 2, 0, ...words(1239)], '123'],
    ['getDistanceAt(0, 0)', [0x55, 0, 3, 3, 0, 0], [0x53, 3, 2, 0, ...words(4000)], '400'],
    ['getDistanceAt(9, 9)', [0x55, 0, 3, 3, 9, 9], [0x63, 3, 1, 0, 7], '1023'],
    ['getDistanceColumn(2)', [0x55, 0, 2, 5, 2], [0x53, 5, 8, 0, ...words(10, 20, 30, 49)], '[1, 2, 3, 4]'],
    ['getDistanceRow(2)', [0x55, 0, 2, 6, 2], [0x53, 6, 8, 0, ...words(10, 20, 30, 49)], '[1, 2, 3, 4]'],
    ['getDistanceRow(8)', [0x55, 0, 2, 6, 8], [0x63, 6, 1, 0, 7], '[]'],
    ['len(getDistanceList())', [0x55, 0, 1, 2], [0x53, 2, 128, 0, ...Array<number>(128).fill(1)], '64'],
    [
      'getDistanceGrid()',
      [0x55, 0, 1, 2],
      [0x53, 2, 32, 0, ...words(...Array.from({ length: 16 }, (_, i) => 10 * i))],
      '[[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11], [12, 13, 14, 15]]',
    ],
  ])('%s sends %j', (call, message, lidar, printed) => {
    const { messages, lines } = run(`print(${call})`, { lidar });
    expect([messages, lines]).toEqual([[message], [printed]]);
  });

  it('asks for the four cells in the middle for getDistance(), and gives up after a second', () => {
    const { messages, lines } = run('print(getDistance())');
    expect(messages).toEqual([[3, 3], [4, 3], [3, 4], [4, 4]].map(([x, y]) => [0x55, 0, 3, 3, x, y])); // prettier-ignore
    expect(lines).toEqual(['1023']);
  });

  it('changes the mode, says so, waits 5 s, and then asks for other cells', () => {
    const program = 'setLidarMode(4)\nprint(running_time() >= 5000)\ngetDistanceAt(0, 0)\ngetDistance()';
    const { messages, lines } = run(program, { lidar: [0x53, 1, 0, 0], forMs: 12_000 });
    expect(lines).toEqual(['Switching Lidar Mode to 4x4.', 'Please wait up to 10 seconds.', 'True']);
    expect(messages[0]).toEqual([0x55, 0, 5, 1, 0, 0, 0, 4]);
    expect(messages[2]).toEqual([0x55, 0, 3, 3, 1, 1]);
  });

  it('waits for a lidar that has just been switched on, and gives up 4 s after the start', () => {
    const floor = putOnFloor(maqueenPlusV3Build);
    const { lines } = floor.run(
      firmware,
      'from mbrobot_plusV3 import *\nprint(getDistanceAt(0, 7), running_time() // 100)',
    );
    expect(lines).toEqual(['21 30']);
    const without = 'try:\n    getDistance()\nexcept OSError as e:\n    print(e, running_time() // 100)';
    expect(run(without, { isOn: false }).lines).toEqual(['[Errno 19] ENODEV 40']);
  });

  it('tries ten times to change the mode', () => {
    const { messages, exception } = run('setLidarMode()', { lidar: Array<number>(20).fill(0x63) });
    expect([messages.length, exception]).toEqual([10, 'RuntimeError: Failed to switch Lidar Mode']);
  });
});

describe('mbrobot_plusV3: servos, lights, sound, errors', () => {
  it.each([
    ['setServo("S1", 0)', 'P0', 25],
    ['setServo("P0", 45)', 'P0', 50],
    ['setServo("S2", 90)', 'P1', 77],
    ['setServo("S3", 180)', 'P2', 130],
  ])('%s makes pulses at %s of %i/1024 of 20 ms, and nothing on the bus', (program, pin, duty) => {
    const { messages, pwm, exception } = run(program);
    expect([messages, exception]).toEqual([[], null]);
    expect(pwm.at(-1)).toBe(`${pin}: 20000 µs, ${duty}/1024`);
  });

  it.each([
    ['setServo("P3", 1)', 'ValueError: Valid servo names: S1, S2, S3 or P0, P1, P2'],
    ['setServo("S1", 181)', 'ValueError: Invalid angle. Must be between 0 and 180'],
    ['posRGB(4, 0, 0, 0)', 'ValueError: invalid RGB-LED position. Must be 0,1,2 or 3.'],
    ['setLidarMode(6)', 'ValueError: Lidar mode must be 4 or 8'],
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

  it.each(['getDistance()', 'setLED(1)', 'patrolling(1)', 'readLightIntensity(1)'])(
    'passes the error of the bus on from %s',
    (program) => {
      expect(run(program, { isOn: false }).exception).toBe('OSError: [Errno 19] ENODEV');
    },
  );

  it('sounds an alarm with its comma, and a beep of 440 Hz', () => {
    expect(run('setAlarm(1)', { forMs: 300 }).exception).toBeNull();
    expect(run('beep()', { forMs: 100 }).tones.at(-1)).toBe(440);
  });
});
