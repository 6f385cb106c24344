import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Board } from '#board/board';
import type { Rgb } from '#core/rgb';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachWs2812 } from '#devices/ws2812';
import { runOnWires } from '../testing/wires';
import { bitbotXlBuild, LINE_ADDRESS } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Surroundings {
  readonly distanceMm?: number;
  /** The byte at 0x1C; left out: nobody answers. */
  readonly line?: number;
  /** Voltages at P1 and P2, as shares of the supply. */
  readonly light?: readonly [number, number];
}

/** Left forward, left backward, right forward, right backward: 4tronix/BitBot `bitbot.ts`, select_model XL. */
const MOTOR_PINS = ['P16', 'P8', 'P14', 'P12'] as const;

/** The value of `write_analog` that is on a wire now. */
const powerOn = (board: Board, pin: string): number => Math.round((board.wire(pin).pwm?.dutyFraction ?? 0) * 1024);

/** Runs a program that has imported everything from mbbitbot, and listens to the wires. */
function run(program: string, { distanceMm = Infinity, line, light = [0, 0] }: Surroundings = {}) {
  let rgb: readonly Rgb[] = [];
  const result = runOnWires(`from mbbitbot import *\n${program}`, {
    build: bitbotXlBuild,
    firmware,
    chips:
      line === undefined
        ? {}
        : { [LINE_ADDRESS]: { write: () => undefined, read: (n) => new Uint8Array(n).fill(line) } },
    connect: (board, clock) => {
      const sonar = board.wire('P15');
      attachHcSr04(clock, { trigger: sonar, echo: sonar }, () => distanceMm);
      light.forEach((share, i) =>
        board
          .wire(`P${i + 1}`)
          .connect('light')
          .driveAnalog(share),
      );
      const arms = attachWs2812(board.wire('P13'), 12);
      board.wire('P13').onStream(() => (rgb = arms.colors()));
    },
    forMs: 1000,
  });
  return { ...result, rgb, powers: MOTOR_PINS.map((pin) => powerOn(result.board, pin)) };
}

/** The powers that a program leaves on the motor pins. */
function powersOf(program: string): readonly number[] {
  const { powers, exception } = run(program);
  expect(exception).toBeNull();
  return powers;
}

describe('mbbitbot: powers on P16, P8, P14, P12 (Tiger-Jython Robotics-Libraries mbbitbot.py)', () => {
  it.each([
    ['forward()', [200, 0, 200, 0]], // the module starts with 200 of 1023
    ['backward()', [0, 200, 0, 200]],
    ['right()', [0, 200, 200, 0]], // its own names are the wrong way round
    ['left()', [200, 0, 0, 200]],
    ['forward()\nstop()', [0, 0, 0, 0]],
    ['setSpeed(50)\nforward()', [512, 0, 512, 0]], // 511.5
    ['setSpeed(300)\nforward()', [1023, 0, 1023, 0]],
    ['setSpeed(-5)\nforward()', [0, 0, 0, 0]],
    ['leftArc(1)', [100, 0, 200, 0]], // r / (r + 1) of the power inside
    ['rightArc(0.25)', [200, 0, 40, 0]],
    ['w(1, 2, 3, 4)', [1, 2, 3, 4]],
    ['w(0, 5, 0, 6)', [0, 5, 0, 6]],
  ])('%j gives %j', (program, powers) => expect(powersOf(program)).toEqual(powers));

  it('sends nothing when it is imported, and nothing for setSpeed alone', () => {
    expect(powersOf('setSpeed(90)')).toEqual([0, 0, 0, 0]);
  });

  it('does nothing for powers of which some are negative and none is positive', () => {
    expect(powersOf('forward()\nw(-200, 0, -200, 0)')).toEqual([200, 0, 200, 0]);
  });

  it('ends with a ValueError for a negative power beside a positive one', () => {
    expect(run('w(200, 0, -200, 0)').exception).toMatch(/^ValueError/);
  });
});

describe('mbbitbot: calibrate()', () => {
  it('fails with the NameError of the original', () => {
    expect(run('calibrate(10)').exception).toBe("NameError: name 'arcScaling' isn't defined");
  });

  const caught = (call: string) => `try:\n    ${call}\nexcept NameError:\n    pass\n`;
  it.each([
    ['calibrate(0, 10)', 'forward()', [210, 0, 190, 0]],
    ['calibrate(0, -99)', 'backward()', [0, 150, 0, 250]], // at most 50 each way
    ['calibrate(10)', 'forward()', [200, 0, 200, 0]], // the offset waits for the next setSpeed
    ['calibrate(10)', 'setSpeed(20)\nforward()', [307, 0, 307, 0]],
    ['calibrate(0, 10)', 'stop()', [0, 0, 0, 0]],
  ])('has set what it was given before it fails: %s, then %j gives %j', (call, program, powers) => {
    expect(powersOf(caught(call) + program)).toEqual(powers);
  });

  it('has no turn on the spot after a differential: the pin of the wheel that stands would get a negative power', () => {
    expect(run(caught('calibrate(0, 10)') + 'left()').exception).toMatch(/^ValueError/);
  });
});

describe('mbbitbot: sensors', () => {
  it.each([
    [50, 4], // 0.01715 cm for each µs, cut off
    [100, 9],
    [304, 30],
    [1000, 99],
    [2000, 199],
  ])('getDistance() for a gap of %d mm is %i, or one more', (distanceMm, expected) => {
    const { lines } = run('print(getDistance())', { distanceMm });
    expect(Number(lines[0]) - expected).toBeGreaterThanOrEqual(0);
    expect(Number(lines[0]) - expected).toBeLessThanOrEqual(1);
  });

  it('getDistance() waits for ever when nothing throws the sound back', () => {
    const { lines, hasEnded } = run('print(getDistance())');
    expect([lines, hasEnded]).toEqual([[], false]);
  });

  it.each([
    [0x50, '0 0'],
    [0x51, '1 0'],
    [0x52, '0 1'],
    [0x53, '1 1'],
  ])('getLine() takes bit 0 and bit 1 of the byte 0x%s at 0x1C', (line, expected) => {
    expect(run('print(getLine(0), getLine(1))', { line }).lines).toEqual([expected]);
  });

  it('getLine() gives 0 when nobody answers', () => {
    const { lines, exception } = run('print(getLine(0), getLine(1))');
    expect([lines, exception]).toEqual([['0 0'], null]);
  });

  it('getLight(0) reads P1, getLight(1) P2, any other number gives None', () => {
    const { lines } = run('print(getLight(0), getLight(1), getLight(2))', { light: [0.25, 0.75] });
    expect(lines).toEqual(['256 768 None']);
  });
});

describe('mbbitbot: lights on P13, and names of the board', () => {
  it('fill() colours all twelve, set_led() one and leaves the others', () => {
    const { rgb } = run('fill(1, 2, 3)\nset_led(11, 9, 8, 7)');
    expect(rgb).toEqual([...Array(11).fill([1, 2, 3]), [9, 8, 7]]);
  });

  it('has no light 12', () => expect(run('set_led(12, 1, 1, 1)').exception).toMatch(/^IndexError/));

  it('hands on the names of the board, NeoPixel and the clock, as the original does', () => {
    const { lines, exception } = run('sleep(1)\nsleep_us(1)\nprint(type(ticks_us()) is int, NeoPixel(pin2, 3)[0])');
    expect([lines, exception]).toEqual([['True (0, 0, 0)'], null]);
  });
});
