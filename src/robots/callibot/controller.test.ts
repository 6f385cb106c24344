import { describe, expect, it } from 'vitest';
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Side } from '#devices/dc-motor';
import { createController, type ControllerParts, type Model } from './controller';

interface Senses {
  readonly bright?: readonly Side[];
  readonly pressed?: readonly Side[];
  readonly distanceMm?: number;
  readonly pulses?: Record<Side, number>;
}

/** A controller with a log of what it told its parts, and a short form to talk to each of its devices. */
function callibot(model: Model = '2E', senses: Senses = {}) {
  const { bright = [], pressed = [], distanceMm = 0, pulses = { left: 0, right: 0 } } = senses;
  const motors: number[][] = [];
  const servos: [string, number][] = [];
  const red = { left: false, right: false };
  const rgb: number[][] = [[], [], [], []];
  const asked = { bumper: 0, distance: 0 };
  const parts: ControllerParts = {
    motors: (left, right) => motors.push([left.direction, left.power, right.direction, right.power]),
    servo: (port, angleDeg) => servos.push([port, angleDeg]),
    redLight: (side, isLit) => void (red[side] = isLit),
    colorLight: (index, color) => void (rgb[index] = [...color]),
    isBright: (side) => bright.includes(side),
    isPressed: (side) => {
      asked.bumper++;
      return pressed.includes(side);
    },
    lineMv: (side) => (side === 'left' ? 0x0a0b : 0x0102),
    distanceMm: () => {
      asked.distance++;
      return distanceMm;
    },
    supplyMv: () => 4800,
    pulses: (side) => pulses[side],
  };
  const controller = createController(parts, model);
  const wire = (target: I2cTarget | null) => ({
    write: (...bytes: number[]): void => target!.write(Uint8Array.from(bytes)),
    read: (count: number): number[] => [...target!.read(count)],
  });
  const x22 = wire(controller.registers);
  const register = (number: number, count: number): number[] => {
    x22.write(number);
    return x22.read(count);
  };
  const devices = { x20: wire(controller.motors), x21: wire(controller.lights), x22, register };
  return { ...devices, controller, motors, servos, red, rgb, asked, pulses };
}

describe('Calli:bot 0x20: motors', () => {
  it.each([
    [
      [0x00, 0, 90],
      [0, 90, 0, 0],
    ],
    [
      [0x00, 1, 255],
      [1, 255, 0, 0],
    ],
    [
      [0x02, 1, 80],
      [0, 0, 1, 80],
    ],
    [
      [0x00, 0, 90, 1, 80],
      [0, 90, 1, 80],
    ],
  ])('takes %j as left direction and power, right direction and power %j', (message, told) => {
    const { x20, motors } = callibot();
    x20.write(...message);
    expect(motors).toEqual([told]);
  });

  it('keeps the left motor when only the right one is written', () => {
    const { x20, motors } = callibot();
    x20.write(0x00, 0, 90);
    x20.write(0x02, 0, 60);
    expect(motors.at(-1)).toEqual([0, 90, 0, 60]);
  });

  it('moves nothing for a direction without a power or an empty write', () => {
    const { x20, motors } = callibot();
    x20.write(0x00, 1);
    x20.write();
    expect(motors).toEqual([[1, 0, 0, 0]]);
  });

  it('gives the motor bytes back, also those that came by 0x22', () => {
    const { x20, x22 } = callibot();
    x22.write(0x02, 3, 0, 50, 1, 60);
    x20.write(0x00);
    expect(x20.read(4)).toEqual([0, 50, 1, 60]);
  });
});

describe('Calli:bot 0x20: servos', () => {
  it('turns S1 to 30° for [0x14, 30], S2 to 120° for [0x15, 120]', () => {
    const { x20, servos } = callibot();
    x20.write(0x14, 30);
    x20.write(0x15, 120);
    expect(servos).toEqual([
      ['S1', 30],
      ['S2', 120],
    ]);
  });

  it('turns both for [0x14, 10, 20]', () => {
    const { x20, servos } = callibot();
    x20.write(0x14, 10, 20);
    expect(servos).toEqual([
      ['S1', 10],
      ['S2', 20],
    ]);
  });
});

describe('Calli:bot 0x21: lights', () => {
  it.each([
    [0, false, false],
    [1, true, false],
    [2, false, true],
    [3, true, true],
    [0xfe, false, true], // chbijou/mpyCalliope writes the other bits, too
  ])('shows mask %i of [0, mask] as left %s, right %s', (mask, left, right) => {
    const { x21, red } = callibot();
    x21.write(0, mask);
    expect(red).toEqual({ left, right });
  });

  it.each([
    [1, [0, 255, 0]],
    [2, [255, 0, 0]],
    [3, [255, 255, 0]],
    [4, [0, 0, 255]],
    [5, [0, 255, 255]],
    [6, [255, 0, 255]],
    [7, [255, 255, 255]],
    [0, [0, 0, 0]],
  ])('has colour %i of the old byte as %j at full brightness', (color, rgb) => {
    const lights = callibot();
    lights.x21.write(1, 0xf0 | color);
    expect(lights.rgb[0]).toEqual(rgb);
  });

  it('dims by the upper four bits: 1/15 for 0x12, dark for 0x02, a third for KN-ts brightness 3 (0x52)', () => {
    const { x21, rgb } = callibot();
    x21.write(1, 0x12, 0x02, 0x52);
    expect(rgb.slice(0, 3)).toEqual([
      [17, 0, 0],
      [0, 0, 0],
      [85, 0, 0],
    ]);
  });

  it('sets red lights and all four colour lights in one write', () => {
    const { x21, red, rgb } = callibot();
    x21.write(0, 3, 0xf1, 0xf2, 0xf4, 0xf7);
    expect(red).toEqual({ left: true, right: true });
    expect(rgb).toEqual([
      [0, 255, 0],
      [255, 0, 0],
      [0, 0, 255],
      [255, 255, 255],
    ]);
  });
});

describe('Calli:bot 0x21: sensors', () => {
  it.each([
    [{ bright: [] }, 0x80],
    [{ bright: ['right'] }, 0x81],
    [{ bright: ['left'] }, 0x82],
    [{ bright: ['left', 'right'] }, 0x83],
    [{ pressed: ['right'] }, 0x84],
    [{ pressed: ['left'] }, 0x88],
    [{ pressed: ['left', 'right'], bright: ['left', 'right'] }, 0x8f],
  ] as const)('reads %j as %i', (senses, byte) => {
    expect(callibot('2E', senses).x21.read(1)).toEqual([byte]);
  });

  it('has bit 7 on a Calli:bot 2, not on a 1, which has no bumper either', () => {
    const senses: Senses = { pressed: ['left', 'right'], bright: ['left'] };
    expect(callibot('2', senses).x21.read(1)).toEqual([0x8e]);
    const old = callibot('1', senses);
    expect(old.x21.read(1)).toEqual([0x02]);
    expect(old.asked.bumper).toBe(0);
  });

  it('gives 1234 mm with the high byte first, then zeros', () => {
    expect(callibot('2E', { distanceMm: 1234 }).x21.read(5)).toEqual([0x80, 0x04, 0xd2, 0, 0]);
    expect(callibot('1', { distanceMm: 1234 }).x21.read(3)).toEqual([0, 0x04, 0xd2]);
  });

  it('does not measure a distance when only the first byte is read', () => {
    const { x21, asked } = callibot();
    x21.read(1);
    expect(asked.distance).toBe(0);
  });
});

describe('Calli:bot 0x22: what is written', () => {
  it.each([
    [
      [2, 1, 0, 90],
      [0, 90, 0, 0],
    ],
    [
      [2, 2, 1, 80],
      [0, 0, 1, 80],
    ],
    [
      [2, 3, 0, 90, 1, 80],
      [0, 90, 1, 80],
    ],
    [
      [2, 3, 1, 70],
      [1, 70, 1, 70],
    ],
  ])('takes %j as left direction and power, right direction and power %j', (message, told) => {
    const { x22, motors } = callibot();
    x22.write(...message);
    expect(motors).toEqual([told]);
  });

  it('sets no motor for the mask 0 or a register alone', () => {
    const { x22, motors } = callibot();
    x22.write(2, 0, 0, 90);
    x22.write(2);
    expect(motors).toEqual([]);
  });

  it('has 0 … 16 for each part of the colour lights 1 … 4', () => {
    const { x22, rgb } = callibot();
    x22.write(3, 1, 16, 8, 0);
    x22.write(3, 2, 1, 2, 3);
    x22.write(3, 3, 99, 0, 0); // more than 16
    x22.write(3, 4, 16); // red alone
    expect(rgb).toEqual([
      [255, 128, 0],
      [16, 32, 48],
      [255, 0, 0],
      [255, 0, 0],
    ]);
  });

  it('has 5 for the left and 6 for the right red light, any brightness lights them', () => {
    const { x22, red } = callibot();
    x22.write(3, 5, 16);
    x22.write(3, 6, 1, 0, 0); // chbijou/mpyCalliope sends five bytes
    expect(red).toEqual({ left: true, right: true });
    x22.write(3, 5, 0);
    expect(red).toEqual({ left: false, right: true });
  });

  it('accepts the power light and the line sensor lights', () => {
    const { x22, red, rgb } = callibot();
    for (const light of [0, 7, 8]) x22.write(3, light, 16);
    expect([red, rgb]).toEqual([{ left: false, right: false }, [[], [], [], []]]);
  });

  it('stops motors and puts out lights for [1], and leaves the servos where they are', () => {
    const { x20, x21, x22, motors, red, rgb, servos } = callibot();
    x20.write(0, 0, 90, 0, 90);
    x20.write(0x14, 50);
    x21.write(0, 3, 0xf7, 0xf7, 0xf7, 0xf7);
    x22.write(1);
    expect(motors.at(-1)).toEqual([0, 0, 0, 0]);
    expect(red).toEqual({ left: false, right: false });
    expect(rgb).toEqual(Array.from({ length: 4 }, () => [0, 0, 0]));
    expect(servos).toEqual([['S1', 50]]);
  });
});

describe('Calli:bot 0x22: what is read', () => {
  it('gives the switches at 0x80 without bit 7, and before any register was chosen', () => {
    const { x22, register } = callibot('2E', { bright: ['left'], pressed: ['right'] });
    expect(x22.read(1)).toEqual([6]);
    expect(register(0x80, 1)).toEqual([6]);
  });

  it('gives the switches for a register that is not there, too', () => {
    expect(callibot('2E', { bright: ['right'] }).register(0x99, 2)).toEqual([1, 0]);
  });

  it('gives 1234 mm at 0x81 with the low byte first', () => {
    expect(callibot('2E', { distanceMm: 1234 }).register(0x81, 3)).toEqual([0x81, 0xd2, 0x04]);
  });

  it('gives type 3 at 0x82 for a 2E, 2 for a 2, then eight bytes of version and number', () => {
    expect(callibot('2E').register(0x82, 10)).toEqual([0x82, 3, 4, 3, 2, 1, 0, 0, 0, 1]);
    expect(callibot('2').register(0x82, 2)).toEqual([0x82, 2]);
  });

  it('gives 4800 mV at 0x83', () => {
    expect(callibot().register(0x83, 3)).toEqual([0x83, 0xc0, 0x12]);
  });

  it('gives the line sensors at 0x84, right first, low bytes first', () => {
    expect(callibot().register(0x84, 5)).toEqual([0x84, 0x02, 0x01, 0x0b, 0x0a]);
  });

  it('gives the encoders at 0x91, left first, signed, lowest byte first', () => {
    const { register } = callibot('2E', { pulses: { left: 70_000, right: -2 } });
    expect(register(0x91, 9)).toEqual([0x91, 0x70, 0x11, 0x01, 0x00, 0xfe, 0xff, 0xff, 0xff]);
  });

  it.each([
    [1, 5, -7],
    [2, 105, 3],
    [3, 5, 3],
  ])('counts anew after [5, %i]: %i left, %i right', (mask, left, right) => {
    const { x22, register, pulses } = callibot('2E', { pulses: { left: 100, right: -10 } });
    x22.write(5, mask);
    pulses.left += 5;
    pulses.right += 3;
    const int32 = (bytes: number[]): number => new DataView(Uint8Array.from(bytes).buffer).getInt32(0, true);
    const answer = register(0x91, 9);
    expect([int32(answer.slice(1, 5)), int32(answer.slice(5))]).toEqual([left, right]);
  });

  it('takes a selection with more bytes behind it (chbijou/mpyCalliope)', () => {
    const { x22 } = callibot('2E', { distanceMm: 300 });
    x22.write(0x81, 0, 0);
    expect(x22.read(3)).toEqual([0x81, 0x2c, 0x01]);
    expect(x22.read(3)).toEqual([0x81, 0x2c, 0x01]);
  });
});

describe('Calli:bot 0x22 on older robots', () => {
  it('is not there on a Calli:bot 1', () => {
    expect(callibot('1').controller.registers).toBeNull();
  });

  it('has neither supply voltage nor encoders on a Calli:bot 2: it gives the switches instead', () => {
    const { x22, register } = callibot('2', { bright: ['left', 'right'], pulses: { left: 9, right: 9 } });
    x22.write(5, 3);
    expect(register(0x83, 3)).toEqual([3, 0, 0]);
    expect(register(0x91, 9)).toEqual([3, 0, 0, 0, 0, 0, 0, 0, 0]);
  });
});
