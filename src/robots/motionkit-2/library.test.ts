import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { createBench } from '#board/testing/bench';
import { createVm } from '#vm/run/vm';
import { motionkit2Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Surroundings {
  /** False: no robot on the bus. */
  readonly isOn?: boolean;
  /** The answer to every read. */
  readonly answer?: readonly number[];
  /** The program before the import. */
  readonly before?: string;
}

/** Runs a program that has imported everything from callimk and listens to the bus. */
function run(program: string, { isOn = true, answer = [0, 0], before = '' }: Surroundings = {}) {
  const { board, clock } = createBench(calliopeMini3);
  const messages: number[][] = [];
  const times: number[] = [];
  const read = (count: number): Uint8Array => {
    messages.push([-count]);
    times.push(clock.nowUs);
    return Uint8Array.from(answer.slice(0, count));
  };
  const hear = (bytes: Uint8Array): void => {
    messages.push([...bytes]);
    times.push(clock.nowUs);
  };
  if (isOn) board.i2c.attach(0x10, { write: hear, read });
  let output = '';
  const write = (text: string): void => void (output += text);
  const files = { 'main.py': `${before}\nfrom callimk import *\n${program}` };
  const vm = createVm({ firmware, board, clock, files, libraries: motionkit2Build.libraries, seed: 1, write });
  vm.resume(2_000_000);
  const lines = output.split(/\r?\n/).filter((line) => line !== '');
  const exception = vm.ended?.exception ?? null;
  return { messages, times, lines, exception: exception && `${exception.type}: ${exception.message}` };
}

/** The transfers of a program: the bytes of a write, or minus the number of bytes read. */
function transfers(program: string): number[][] {
  const { messages, exception } = run(program);
  expect(exception).toBeNull();
  return messages;
}

const both = (dirL: number, speedL: number, dirR: number, speedR: number) => [
  [0x00, dirL, speedL],
  [0x02, dirR, speedR],
];

describe('callimk: driving, byte by byte (Tiger-Jython/Robotics-Libraries calliope/callimk.py)', () => {
  it.each([
    ['forward()', both(0, 30, 0, 30)], // power 30 at the start
    ['backward()', both(1, 30, 1, 30)],
    ['left()', both(1, 30, 0, 30)],
    ['right()', both(0, 30, 1, 30)],
    ['stop()', both(0, 0, 0, 0)],
    ['exit()', both(0, 0, 0, 0)],
    ['setSpeed(100); forward()', both(0, 100, 0, 100)],
    ['setSpeed(3); forward()', both(0, 15, 0, 15)], // at least 15
    ['setSpeed(-40); left()', both(1, 15, 0, 15)],
    ['setSpeed(300); forward()', both(0, 44, 0, 44)], // no limit: 300 does not fit into a byte
    ['leftArc(0.05)', both(0, 0, 0, 30)], // below 9 cm the inner wheel stands
    ['leftArc(0.09)', both(0, 0, 0, 30)],
    ['leftArc(0.2)', both(0, 11, 0, 30)],
    ['rightArc(0.2)', both(0, 30, 0, 11)],
    ['rightArc(0.5)', both(0, 30, 0, 20)],
    ['setSpeed(100); leftArc(0.3)', both(0, 51, 0, 100)], // 1 − v² / 200000 = 0.95
    ['setSpeed(255); rightArc(1)', both(0, 255, 0, 143)],
    ['w(1, 0, 20, 40)', both(1, 20, 0, 40)],
    ['motorL(1, 200)', [[0x00, 1, 200]]],
    ['motorR(0, 90)', [[0x02, 0, 90]]],
    ['setSpeed(80)', []],
  ])('%s sends %j', (program, messages) => {
    expect(transfers(program)).toEqual(messages);
  });
});

describe('callimk: lights and servos, byte by byte', () => {
  it.each([
    ['led(0, 1)', [[0x0b, 1]]],
    ['led(1, 1)', [[0x0c, 1]]],
    ['led(2, 0)', [[0x0c, 0]]], // everything but 0
    ['setLEDLeft(1)', [[0x0c, 1]]], // the register that maker and list call right
    ['setLEDRight(1)', [[0x0b, 1]]],
    ['setLED(1)', [[0x0c, 1], [0x0b, 1]]], // prettier-ignore
    ['setLED(0)', [[0x0c, 0], [0x0b, 0]]], // prettier-ignore
    ['rgbLED(200, 100, 50)', [[0x18, 200], [0x19, 100], [0x1a, 50]]], // prettier-ignore
    ['setServo("S1", 45)', [[0x14, 45]]],
    ['setServo("S2", 180)', [[0x15, 180]]],
  ])('%s sends %j', (program, messages) => {
    expect(transfers(program)).toEqual(messages);
  });

  it('tells which servos there are when it is asked for another one', () => {
    expect(run('setServo("P0", 45)').exception).toBe("ValueError: Unknown servo. Please use 'S1' or 'S2'.");
  });
});

describe('callimk: sensors', () => {
  it.each([
    [[0], '1 1'],
    [[1], '0 1'],
    [[2], '1 0'],
    [[3], '0 0'],
  ])('gives for the byte %j of 0x1D irLeftValue() irRightValue() = %s: 1 bright, 0 dark', (answer, printed) => {
    const { lines, messages } = run('print(irLeftValue(), irRightValue())', { answer });
    expect(lines).toEqual([printed]);
    expect(messages).toEqual([[0x1d], [-1], [0x1d], [-1]]);
  });

  it.each([
    [[0, 20], '20'],
    [[1, 44], '300'],
    [[255, 255], '65535'], // −1, as it stands there
    [[0, 0], '0'],
  ])('gives for the bytes %j of 0x28 getDistance() = %s, 20 ms after it asked', (answer, printed) => {
    const { lines, messages, times } = run('print(getDistance())', { answer });
    expect(lines).toEqual([printed]);
    expect(messages).toEqual([[0x28], [-2]]);
    expect(Math.round((times[1]! - times[0]!) / 1000)).toBe(20);
  });
});

describe('callimk: the rest', () => {
  it('brings delay in milliseconds, and sleep, i2c and gc as the library of that name does', () => {
    const program = 'from calliope_mini import running_time\na = running_time()\ndelay(300)\nsleep(200)\n';
    const { lines } = run(`${program}gc.collect()\nprint(499 <= running_time() - a <= 502, i2c.scan())`);
    expect(lines).toEqual(['True [16]']);
  });

  it('opens the bus when it is imported, on the wires of the robot', () => {
    const before = 'from calliope_mini import *\ni2c.init(scl=pin0, sda=pin1)\nprint(i2c.scan())';
    expect(run('print(i2c.scan())', { before }).lines).toEqual(['[]', '[16]']);
  });

  it.each(['forward()', 'setLED(1)', 'irLeftValue()', 'getDistance()', 'setServo("S1", 9)'])(
    'lets the error of the bus through when %s finds no robot',
    (call) => {
      expect(run(call, { isOn: false }).exception).toContain('OSError: [Errno 19] ENODEV');
    },
  );
});
