import { describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import type { Side } from '#devices/dc-motor';
import { createController, SIDES, VERSION } from './controller';

interface Surroundings {
  readonly sides?: keyof typeof SIDES;
  /** The line sensors over black. */
  readonly black?: readonly Side[];
  readonly distanceCm?: number;
  readonly infraredCode?: number;
}

/** A controller with a log of its calls. */
function controller({ sides = 'maker', black = [], distanceCm = 0, infraredCode = 0 }: Surroundings = {}) {
  const motors: { left: number[]; right: number[]; sides: readonly Side[] }[] = [];
  const lights: [Side, boolean][] = [];
  const servos: [string, number][] = [];
  const colors: Rgb[] = [];
  const target = createController(
    {
      motors: ({ left, right }, touched) =>
        motors.push({
          left: [left.direction, left.speed],
          right: [right.direction, right.speed],
          sides: touched,
        }),
      light: (side, isLit) => lights.push([side, isLit]),
      servo: (port, angle) => servos.push([port, angle]),
      color: (color) => colors.push(color),
      isBright: (side) => !black.includes(side),
      brightness: (side) => (side === 'left' ? 61 : 62),
      distanceCm: () => distanceCm,
      infraredCode: () => infraredCode,
    },
    SIDES[sides],
  );
  const write = (...bytes: number[]): void => target.write(Uint8Array.from(bytes));
  const readFrom = (register: number, count: number): number[] => {
    write(register);
    return [...target.read(count)];
  };
  return { write, readFrom, motors, lights, servos, colors };
}

describe('MotionKit 2 controller: motors (chbijou/mpyCalliope I2CAdressenRegister.txt, tinysuperlab/MotionKitV2)', () => {
  it.each([
    { bytes: [0x00, 0, 30], left: [0, 30], right: [0, 0], sides: ['left'] },
    { bytes: [0x02, 1, 255], left: [0, 0], right: [1, 255], sides: ['right'] },
    { bytes: [0x00, 1, 50, 0, 60], left: [1, 50], right: [0, 60], sides: ['left', 'right'] },
    { bytes: [0x01, 70], left: [0, 70], right: [0, 0], sides: ['left'] },
  ])('$bytes sets left $left, right $right', ({ bytes, ...set }) => {
    const { write, motors } = controller();
    write(...bytes);
    expect(motors).toEqual([set]);
  });

  it('gives their four bytes back', () => {
    const { write, readFrom } = controller();
    write(0x00, 1, 50, 0, 60);
    expect(readFrom(0x00, 4)).toEqual([1, 50, 0, 60]);
  });
});

describe('MotionKit 2 controller: lights, servos, colours (the same list)', () => {
  it.each([
    { bytes: [0x0b, 1], lit: [['left', true]] },
    { bytes: [0x0c, 1], lit: [['right', true]] },
    { bytes: [0x0b, 7], lit: [['left', true]] }, // 0 off, everything else on
    { bytes: [0x0b, 1, 0], lit: [['left', true], ['right', false]] }, // prettier-ignore
  ])('$bytes switches $lit', ({ bytes, lit }) => {
    const { write, lights } = controller();
    write(...bytes);
    expect(lights).toEqual(lit);
  });

  it('[0x14, 45] and [0x15, 135] turn S1 and S2, [0x14, 10, 20] both; the angles can be read', () => {
    const { write, readFrom, servos } = controller();
    write(0x14, 45);
    write(0x15, 135);
    write(0x14, 10, 20);
    expect(servos).toEqual([['S1', 45], ['S2', 135], ['S1', 10], ['S2', 20]]); // prettier-ignore
    expect(readFrom(0x14, 2)).toEqual([10, 20]);
  });

  it('has one colour from three registers: one by one, or all in a write', () => {
    const { write, readFrom, colors } = controller();
    write(0x18, 200);
    write(0x19, 100);
    write(0x1a, 50);
    write(0x18, 1, 2, 3);
    expect(colors).toEqual([[200, 0, 0], [200, 100, 0], [200, 100, 50], [1, 2, 3]]); // prettier-ignore
    expect(readFrom(0x18, 3)).toEqual([1, 2, 3]);
  });
});

describe('MotionKit 2 controller: line sensors', () => {
  it.each([
    [[], 0],
    [['left'], 1],
    [['right'], 2],
    [['left', 'right'], 3], // “3: in the middle of the track”, chbijou/mpyCalliope mklib.py
  ] as const)('has for black below %j the bits %i at 0x1D (tinysuperlab/MotionKitV2 readPatrol)', (black, bits) => {
    expect(controller({ black }).readFrom(0x1d, 1)).toEqual([bits]);
  });

  it('gives one byte of brightness for the left at 0x1E, one for the right at 0x20 (chbijou’s list)', () => {
    const { readFrom } = controller();
    expect([readFrom(0x1e, 1), readFrom(0x20, 1), readFrom(0x1d, 4)]).toEqual([[61], [62], [0, 61, 0, 62]]);
  });
});

describe('MotionKit 2 controller: ultrasonic, infrared, version', () => {
  it.each([
    [20, [0, 20]],
    [300, [1, 44]],
    [-1, [255, 255]], // out of range: chbijou’s list
    [0, [0, 0]], // no value: the same
  ])('gives a distance of %i cm as %j at 0x28', (distanceCm, bytes) => {
    const { readFrom } = controller({ distanceCm });
    expect(readFrom(0x28, 2)).toEqual(bytes);
    expect(readFrom(0x29, 1)).toEqual([bytes[1]]); // byte by byte: tinysuperlab/MotionKitV2 ultrasonic
  });

  it.each([
    ['1', 0x00fd08f7, [0x00, 0xfd, 0x08, 0xf7]],
    ['red power', 0x00fd00ff, [0x00, 0xfd, 0x00, 0xff]],
    ['vol +', 0x00fd807f, [0x00, 0xfd, 0x80, 0x7f]],
    ['none', 0, [0, 0, 0, 0]],
  ])(
    'gives the code of the key “%s” with its highest byte first (tinysuperlab/MotionKitV2 irRead)',
    (_, code, bytes) => {
      expect(controller({ infraredCode: code }).readFrom(0x2b, 4)).toEqual(bytes);
    },
  );

  it('tells the length of its version text, at most 20, and the text, also in one read of 21 bytes (chbijou 00_Version.py)', () => {
    const { readFrom } = controller();
    const [length = 0, ...text] = readFrom(0x32, 21);
    expect(length).toBe(VERSION.length);
    expect(length).toBeLessThanOrEqual(20);
    expect(String.fromCharCode(...text.slice(0, length))).toBe(VERSION);
    expect(text.slice(length).every((byte) => byte === 0)).toBe(true);
    expect(readFrom(0x33, length)).toEqual(text.slice(0, length));
  });

  it('ignores what is written to its sensors and to registers that it does not have, which give 0', () => {
    const calls = controller({ distanceCm: 30 });
    for (const register of [0x0a, 0x1d, 0x28, 0x2b, 0x32, 0x50]) calls.write(register, 9);
    expect([calls.motors, calls.lights, calls.servos, calls.colors]).toEqual([[], [], [], []]);
    expect([calls.readFrom(0x50, 2), calls.readFrom(0x0a, 1), calls.readFrom(0x28, 2)]).toEqual([[0, 0], [0], [0, 30]]);
  });
});

describe('MotionKit 2 controller: left and right, on which the sources do not agree', () => {
  it.each([
    ['maker', 'left', 'left', 1],
    ['lights-swapped', 'left', 'right', 1], // callimk.py: setLEDRight writes 0x0B
    ['all-swapped', 'right', 'right', 2], // the Calliope editor’s MotionKitV2.py
  ] as const)('is by “%s”: 0x00 %s motor, 0x0B %s light, black on the left bit %i', (sides, motor, light, bits) => {
    const { write, readFrom, motors, lights } = controller({ sides, black: ['left'] });
    write(0x00, 0, 30);
    write(0x0b, 1);
    expect(motors).toEqual([{ left: [0, 0], right: [0, 0], sides: [motor], [motor]: [0, 30] }]);
    expect(lights).toEqual([[light, true]]);
    expect(readFrom(0x1d, 1)).toEqual([bits]);
    expect(readFrom(0x1e, 1)).toEqual([sides === 'all-swapped' ? 62 : 61]);
  });
});
