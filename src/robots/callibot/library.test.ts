import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { createBench } from '#board/testing/bench';
import { createVm } from '#vm/run/vm';
import { callibotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Surroundings {
  /** False: no robot on the bus. */
  readonly isOn?: boolean;
  /** The answer of 0x21: the switches, and the distance in mm. */
  readonly switches?: number;
  readonly distanceMm?: number;
  readonly forMs?: number;
}

/** Runs a program with the robot's libraries and listens to the bus: [address, bytes written …]. */
function run(program: string, { isOn = true, switches = 0x80, distanceMm = 0, forMs = 2000 }: Surroundings = {}) {
  const { board, clock } = createBench(calliopeMini3);
  const messages: number[][] = [];
  const readCounts: number[] = [];
  for (const address of isOn ? [0x20, 0x21] : []) {
    board.i2c.attach(address, {
      write: (bytes) => void messages.push([address, ...bytes]),
      read: (count) => {
        readCounts.push(count);
        return Uint8Array.of(switches, distanceMm >> 8, distanceMm & 255).slice(0, count);
      },
    });
  }
  const tones: number[] = [];
  board.wire('P0').onPwm((pwm) => tones.push(pwm ? Math.round(1_000_000 / pwm.periodUs) : 0));
  let output = '';
  const write = (text: string): void => void (output += text);
  const files = { 'main.py': program };
  const vm = createVm({ firmware, board, clock, files, libraries: callibotBuild.libraries, seed: 1, write });
  vm.resume(forMs * 1000);
  const lines = output.split(/\r?\n/).filter((line) => line !== '');
  const { ended } = vm;
  const exception = ended?.exception ? `${ended.exception.type}: ${ended.exception.message}` : null;
  return { messages, readCounts, lines, exception, hasEnded: ended !== null, tones };
}

/** The bytes that a program which has imported everything from callibot writes to the motors at 0x20. */
function motorBytes(program: string): number[][] {
  const { messages, exception } = run(`from callibot import *\n${program}`);
  expect(exception).toBeNull();
  return messages.filter(([address]) => address === 0x20).map(([, ...bytes]) => bytes);
}

const printed = (program: string, surroundings?: Surroundings): readonly string[] => {
  const { lines, exception } = run(`from callibot import *\n${program}`, surroundings);
  expect(exception).toBeNull();
  return lines;
};

describe('callibot: driving, byte by byte (Tiger-Jython Robotics-Libraries callibot.py 1.3)', () => {
  it.each([
    ['forward()', 0, 90, 0, 90], // speed 50: power 90
    ['backward()', 1, 90, 1, 90],
    ['left()', 1, 99, 0, 99], // a tenth more
    ['right()', 0, 99, 1, 99],
    ['stop()', 0, 0, 0, 0],
    ['exit()', 0, 0, 0, 0],
    ['setSpeed(0); forward()', 0, 40, 0, 40],
    ['setSpeed(100); left()', 1, 154, 0, 154],
    ['setSpeed(215); forward()', 0, 255, 0, 255],
    ['setSpeed(250); forward()', 0, 34, 0, 34], // no limit: 290 does not fit into a byte
    ['setSpeed(-100); forward()', 0, 196, 0, 196], // nor does −60
    ['setSpeed(-100); left()', 0, 190, 1, 190],
    ['leftArc(0.05)', 0, 0, 0, 90], // below 6 cm the inner wheel stands
    ['leftArc(0.1)', 0, 21, 0, 90],
    ['leftArc(0.2)', 0, 46, 0, 90],
    ['rightArc(0.2)', 0, 90, 0, 46],
    ['rightArc(0.5)', 0, 90, 0, 67],
    ['setSpeed(100); leftArc(0.3)', 0, 84, 0, 140],
    ['setSpeed(-100); leftArc(0.2)', 1, 60, 1, 31], // backward
    ['setSpeed(-100); rightArc(0.2)', 1, 31, 1, 60],
    ['w(1, 0, 20, 30)', 1, 20, 0, 30],
  ])('%s sends left [%i, %i], right [%i, %i]', (program, dirL, powerL, dirR, powerR) => {
    expect(motorBytes(program)).toEqual([
      [0, dirL, powerL],
      [2, dirR, powerR],
    ]);
  });

  it('sends nothing for setSpeed alone', () => {
    expect(motorBytes('setSpeed(80)')).toEqual([]);
  });

  it('has motL and motR of TigerJython’s simulated robot: one motor each, power 50 more', () => {
    expect(motorBytes('motL.rotate(40); motR.rotate(-40); motR.rotate(0)')).toEqual([
      [0, 0, 90],
      [2, 1, 90],
      [2, 0, 0],
    ]);
  });
});

describe('callibot: red lights', () => {
  it.each([
    ['setLEDLeft(1)', 1],
    ['setLEDRight(1)', 2],
    ['setLED(1)', 3],
    ['setLEDLeft(0)', 0],
    ['setLEDRight(0)', 0],
    ['setLED(0)', 0],
    ['setLED(2)', 0], // only 1 is on
  ])('%s first turns both off, then sends mask %i', (program, mask) => {
    expect(run(`from callibot import *\n${program}`).messages).toEqual([
      [0x21, 0, 0],
      [0x21, 0, mask],
    ]);
  });
});

describe('callibot: sensors', () => {
  const values = 'print(irLeftValue(), irRightValue(), tsValue(), tsLeftValue(), tsRightValue())';

  it.each([
    [0x80, '0 0 0 0 0'],
    [0x81, '0 1 0 0 0'],
    [0x82, '1 0 0 0 0'],
    [0x83, '1 1 0 0 0'],
    [0x84, '0 0 0 0 1'],
    [0x87, '0 0 0 0 1'], // both line sensors on light ground: only the bumper counts
    [0x88, '0 0 0 1 0'],
    [0x8b, '0 0 0 1 0'],
    [0x8c, '0 0 1 0 0'],
    [0x8f, '0 0 1 0 0'],
    [0x8a, '0 0 0 0 0'], // bumper left and one line sensor: a quirk of the library
    [0x03, '0 0 0 0 0'], // a Calli:bot 1
  ])('gives for the byte %i: line left, right, bumper both, left, right = %s', (switches, line) => {
    expect(printed(values, { switches })).toEqual([line]);
  });

  it('reads one byte for each of them and three for the distance', () => {
    const { readCounts } = run(`from callibot import *\n${values}\ngetDistance()`);
    expect(readCounts).toEqual([1, 1, 1, 1, 1, 3]);
  });

  it.each([
    [1234, '123.4'],
    [20, '2.0'],
    [4500, '450.0'],
  ])('gives %i mm as %s cm', (distanceMm, text) => {
    expect(printed('print(getDistance())', { distanceMm })).toEqual([text]);
  });

  it('has the spelling of TigerJython’s simulated robot, which looks at its own bit alone', () => {
    const program = [
      'print(irLeft.read_digital(), irRight.read_digital())',
      'print(ts.getValue(), tsLeft.getValue(), tsRight.getValue())',
    ].join('\n');
    expect(printed(program, { switches: 0x8a })).toEqual(['1 0', '0 1 0']);
    expect(printed(program, { switches: 0x8d })).toEqual(['0 1', '1 1 1']);
  });
});

describe('callibot: the rest', () => {
  it('has delay in milliseconds, and sleep and i2c of the board', () => {
    const program = 'from calliope_mini import running_time\na = running_time()\ndelay(300)\nsleep(200)\n';
    expect(printed(`${program}print(499 <= running_time() - a <= 502, i2c.scan())`)).toEqual(['True [32, 33]']);
  });

  it('plays the alarm of cbalarm', () => {
    const { tones } = run('from callibot import *\nsetAlarm(1)\ndelay(300)\nsetAlarm(0)');
    expect(tones).toContain(1047);
    expect(tones.at(-1)).toBe(0);
  });

  it.each(['forward()', 'setLED(1)', 'irLeftValue()', 'getDistance()', 'tsValue()'])(
    'prints “Please switch on Robot!” once and waits for ever when %s finds no robot',
    (call) => {
      const { lines, hasEnded } = run(`from callibot import *\n${call}\nprint("after")`, { isOn: false });
      expect(lines).toEqual(['Please switch on Robot!']);
      expect(hasEnded).toBe(false);
    },
  );

  it('can be imported as a module, and under the other names of the board', () => {
    const { messages, exception } = run('from calliopemini import *\nimport callibot\ncallibot.forward()');
    expect(exception).toBeNull();
    expect(messages).toHaveLength(2);
  });
});

describe('callibotmot, byte by byte', () => {
  it.each([
    ['motL.rotate(40)', [0x20, 0, 0, 90]],
    ['motL.rotate(-40)', [0x20, 0, 1, 90]],
    ['motL.rotate(0)', [0x20, 0, 0, 0]],
    ['motR.rotate(100)', [0x20, 2, 0, 150]],
    ['motR.rotate(-205)', [0x20, 2, 1, 255]],
    ['motR.rotate(210)', [0x20, 2, 0, 4]], // 260 does not fit into a byte
    ['setLED(1)', [0x21, 0, 3]],
    ['setLED(0)', [0x21, 0, 0]],
  ])('%s sends %j', (program, message) => {
    expect(run(`from callibotmot import *\n${program}`).messages).toEqual([message]);
  });

  it('prints “Please switch on mbRobot!” and waits for ever without a robot; setLED raises the bus error', () => {
    const { lines, hasEnded } = run('from callibotmot import *\nmotL.rotate(10)', { isOn: false });
    expect([lines, hasEnded]).toEqual([['Please switch on mbRobot!'], false]);
    expect(run('from callibotmot import *\nsetLED(1)', { isOn: false }).exception).toContain('OSError');
  });
});

describe('cbalarm', () => {
  it('plays c6 at 0, 0.25, 0.75, 1.0 and 1.5 s, and so on until setAlarm(0)', () => {
    const { tones } = run(
      'from cbalarm import *\nfrom calliope_mini import sleep\nsetAlarm(1)\nsleep(1700)\nsetAlarm(0)',
    );
    expect(tones.filter((hz) => hz > 0)).toEqual([1047, 1047, 1047, 1047, 1047]);
    expect(tones.at(-1)).toBe(0);
  });

  it('beeps with 2000 Hz', () => {
    expect(run('from cbalarm import *\nbeep()').tones).toContain(2000);
  });
});
