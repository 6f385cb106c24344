import { describe, expect, it } from 'vitest';
import type { LineName } from '../maqueen-plus-frame';
import { createController, type ControllerOptions } from './controller';

const USUAL: ControllerOptions = { version: '2.1', analogOrder: 'R2-first' };

/** A controller with a log of its calls, over a ground that is black below the named sensors. */
function controller(options: Partial<ControllerOptions> = {}, black: readonly LineName[] = []) {
  const motors: number[][] = [];
  const leds: number[][] = [];
  const values: Record<LineName, number> = { R2: 11, R1: 12, M: 13, L1: 14, L2: 15 };
  const target = createController(
    {
      motors: ({ left, right }) => motors.push([...left, ...right]),
      leds: (left, right) => leds.push([left, right]),
      isBright: (name) => !black.includes(name),
      brightness: (name) => values[name],
    },
    { ...USUAL, ...options },
  );
  const write = (...bytes: number[]): void => target.write(Uint8Array.from(bytes));
  const readFrom = (register: number, count: number): number[] => {
    write(register);
    return [...target.read(count)];
  };
  return { write, readFrom, motors, leds };
}

describe('Maqueen Plus V2 controller: motors', () => {
  it.each([
    [
      [0x00, 0, 100],
      [0, 100, 0, 0],
    ], // DFRobot maqueenPlusV2.ts, one motor
    [
      [0x02, 1, 80],
      [0, 0, 1, 80],
    ],
    [
      [0x00, 0, 50, 1, 60],
      [0, 50, 1, 60],
    ], // Tiger-Jython mbrobot_plusV2.py, both
    [
      [0x00, 1],
      [1, 0, 0, 0],
    ],
    [
      [0x03, 77],
      [0, 0, 0, 77],
    ],
  ])('%j sets the registers 0 to 3 to %j', (message, expected) => {
    const { write, motors, readFrom } = controller();
    write(...message);
    expect(motors).toEqual([expected]);
    expect(readFrom(0x00, 4)).toEqual(expected);
  });

  it('gives direction and speed of one motor back (almasy/micropython-maqueen-plus reads two bytes)', () => {
    const { write, readFrom } = controller();
    write(0x00, 0, 50, 1, 60);
    expect([readFrom(0x00, 2), readFrom(0x02, 2)]).toEqual([
      [0, 50],
      [1, 60],
    ]);
  });
});

describe('Maqueen Plus V2 controller: red lights', () => {
  it.each([
    [
      [0x0b, 1, 0],
      [1, 0],
    ],
    [
      [0x0b, 1, 1],
      [1, 1],
    ],
    [
      [0x0c, 1],
      [0, 1],
    ],
    [
      [0x0b, 3],
      [1, 0],
    ], // a colour, as the V3 has
  ])('%j lights %j', (message, expected) => {
    const { write, leds, motors } = controller();
    write(...message);
    expect(leds).toEqual([expected]);
    expect(motors).toEqual([]);
  });

  it('keeps one while the other is set', () => {
    const { write, leds } = controller();
    write(0x0b, 1);
    write(0x0c, 1);
    write(0x0b, 0);
    expect(leds.at(-1)).toEqual([0, 1]);
  });
});

describe('Maqueen Plus V2 controller: line sensors', () => {
  it.each([
    ['R2', 0b00001],
    ['R1', 0b00010],
    ['M', 0b00100],
    ['L1', 0b01000],
    ['L2', 0b10000],
  ] as const)('has 1 in the bit of %s alone while only that one is on black', (name, bits) => {
    expect(controller({}, [name]).readFrom(0x1d, 1)).toEqual([bits]);
  });

  it('gives five words, low byte first, R2 at 0x1E', () => {
    expect(controller().readFrom(0x1e, 10)).toEqual([11, 0, 12, 0, 13, 0, 14, 0, 15, 0]);
    expect(controller().readFrom(0x24, 2)).toEqual([14, 0]);
  });

  it('gives bits and words in one read of 11 bytes from 0x1D (Tiger-Jython mbrobot_plusV2.py)', () => {
    expect(controller({}, ['M']).readFrom(0x1d, 11)).toEqual([4, 11, 0, 12, 0, 13, 0, 14, 0, 15, 0]);
  });

  it('has L2 at 0x1E with the option, the bits as before', () => {
    const { readFrom } = controller({ analogOrder: 'L2-first' }, ['R2']);
    expect(readFrom(0x1d, 11)).toEqual([1, 15, 0, 14, 0, 13, 0, 12, 0, 11, 0]);
  });
});

describe('Maqueen Plus V2 controller: version and the rest', () => {
  it.each(['2.0', '2.1'] as const)('tells its version %s in the last three letters', (version) => {
    const { readFrom } = controller({ version });
    const [length = 0] = readFrom(0x32, 1);
    const text = String.fromCharCode(...readFrom(0x33, length));
    expect(text).toBe(`MBT0021-EN-${version}`);
  });

  it('ignores the V3’s reset register 0x49 and the V1’s servos 0x14 to 0x16, and reads 0 there', () => {
    const { write, readFrom, motors, leds } = controller();
    write(0x49, 1);
    write(0x14, 90, 90, 90);
    write(0x32, 0);
    expect([motors, leds]).toEqual([[], []]);
    expect([readFrom(0x49, 1), readFrom(0x14, 3), readFrom(0x32, 1)]).toEqual([[0], [0, 0, 0], [14]]);
  });
});
