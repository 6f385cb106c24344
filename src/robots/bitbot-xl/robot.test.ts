/** The wires of the bit:bot XL, one by one. 4T = 4tronix/BitBot `bitbot.ts`, GMC = gmc-code/PC-Microbit-Extension. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { OnSet } from '../robot';
import { nothingAround, putOnFloor, type FloorSetup } from '../testing/floor';
import { bitbotXlBuild, EEPROM_ADDRESS, LINE_ADDRESS } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const stand = (setup?: FloorSetup) => putOnFloor(bitbotXlBuild, setup);
const half = { periodUs: 20_000, dutyFraction: 0.5 };

/** A black line along the robot's path, its middle this many mm to its left. */
const lineAt = (leftMm: number, widthMm: number): FloorSetup => ({
  prepare: (world) => {
    const pointsMm = [800, 1200].map((x) => ({ x, y: 1000 + leftMm }));
    world.addStroke({ pointsMm, widthMm, reflectance: 0 });
  },
});

const wallAt = (x: number): FloorSetup => ({
  prepare: (world) => world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 }),
});

describe('bit:bot XL, its motors (4T select_model; GMC BitBotXL_info)', () => {
  it.each([
    ['P16', 'left wheel forward', { left: 0.5, right: 0 }],
    ['P8', 'left wheel backward', { left: -0.5, right: 0 }],
    ['P14', 'right wheel forward', { left: 0, right: 0.5 }],
    ['P12', 'right wheel backward', { left: 0, right: -0.5 }],
  ])('has at %s: %s', (pin, _, duty) => {
    const { board, robot } = stand();
    board.wire(pin).connect('test').drivePwm(half);
    expect(robot.state().duty).toEqual(duty);
  });

  it('stands with both pins of each motor high, as 4T brakes', () => {
    const { board, robot } = stand();
    for (const pin of ['P16', 'P8', 'P14', 'P12']) board.wire(pin).connect('test').drive(1);
    expect(robot.state().duty).toEqual({ left: 0, right: 0 });
  });

  it('tells of a motor that the program sets by either of its pins, with its duty', () => {
    const told: (readonly [string, string | number])[] = [];
    const onSet: OnSet = (output, value) => told.push([output, value]);
    const { board, chassis, robot, ...rest } = stand();
    robot.detach();
    const again = bitbotXlBuild.attach({ ...rest, ...nothingAround, board, chassis, onSet });
    told.length = 0;
    board.wire('P14').connect('test').drivePwm(half);
    board.wire('P8').connect('test').drivePwm(half);
    expect(told).toEqual([
      ['wheel-right', 0.5],
      ['wheel-left', -0.5],
    ]);
    again.detach();
    expect([chassis.duty(0), chassis.duty(1)]).toEqual([0, 0]);
  });
});

describe('bit:bot XL, its line sensors at I2C 0x1C (4T readLine, getVersionCode)', () => {
  const byteOf = (setup?: FloorSetup): number => {
    const { board } = stand(setup);
    return board.i2c.read(LINE_ADDRESS, 1).bytes[0] ?? -1;
  };

  it('gives one byte without a register: 0x50 on the bare floor, as bits 4 to 7 are 5 for the v1.2', () => {
    expect(byteOf()).toBe(0x50);
  });

  it.each([
    ['left alone: bit 0', 8, 0x51],
    ['right alone: bit 1', -8, 0x52],
  ])('has 1 on a black line under the %s', (_, leftMm, byte) => expect(byteOf(lineAt(leftMm, 10))).toBe(byte));

  it('has both bits on a line of 25 mm', () => expect(byteOf(lineAt(0, 25))).toBe(0x53));

  it('follows the floor while it drives, and says in the picture what each sensor sees', () => {
    const { board, robot, passMs } = stand(lineAt(8, 10));
    expect(robot.state().lineSensors.map(({ name, bright }) => [name, bright])).toEqual([
      ['left', false],
      ['right', true],
    ]);
    for (const pin of ['P16', 'P14']) board.wire(pin).connect('test').drivePwm(half);
    passMs(1500);
    expect(board.i2c.read(LINE_ADDRESS, 1).bytes[0]).toBe(0x50);
  });

  it('is a port expander: register 2 turns inputs round (NXP PCA9557 data sheet)', () => {
    const { send, readFrom } = stand();
    send(LINE_ADDRESS, 2, 0xf3);
    expect(readFrom(LINE_ADDRESS, 0, 1)).toEqual([0x53]);
  });
});

describe('bit:bot XL, its EEPROM at I2C 0x50 (4T rdEEROM, wrEEROM)', () => {
  it('has no bias in its first three bytes and keeps what is written: two bytes of address, high one first', () => {
    const { send, board } = stand();
    send(EEPROM_ADDRESS, 0, 0);
    expect([...board.i2c.read(EEPROM_ADDRESS, 3).bytes]).toEqual([0, 0, 0]);
    send(EEPROM_ADDRESS, 0, 1, 0xf6);
    send(EEPROM_ADDRESS, 0, 1);
    expect([...board.i2c.read(EEPROM_ADDRESS, 1).bytes]).toEqual([0xf6]);
  });

  it('has no chip of the PRO at 0x22', () => expect(stand().board.i2c.answers(0x22)).toBe(false));
});

describe('bit:bot XL, its light sensors (4T readLight: left P2, right P1)', () => {
  it.each([
    [0, 0],
    [127, 0.498],
    [255, 1],
  ])('have at light level %i the voltage %f of the supply, at the next step', (level, share) => {
    const { board, passMs } = stand();
    board.sensors.set('lightLevel', level);
    passMs(8);
    for (const pin of ['P1', 'P2']) expect(board.wire(pin).fraction).toBeCloseTo(share, 3);
  });
});

describe('bit:bot XL, its twelve lights at P13 (4T fire)', () => {
  it('shows green, red, blue as sent, light 0 first, and reports each', () => {
    const { board, robot } = stand();
    board.wire('P13').stream(Uint8Array.from({ length: 36 }, (_, i) => i));
    const { rgb } = robot.state();
    expect(rgb).toHaveLength(12);
    expect([rgb[0], rgb[11]]).toEqual([
      [1, 0, 2],
      [34, 33, 35],
    ]);
  });
});

describe('bit:bot XL, its ultrasonic sensor at P15 (4T sonar: trigger and echo on one pin)', () => {
  it('answers a trigger with an echo of 1746 µs for a wall 30 cm ahead of it, and rests at low', () => {
    const { board, clock, passMs } = stand(wallAt(1000 + 70 + 300 + 5));
    const wire = board.wire('P15');
    const end = wire.connect('test');
    const edges: [number, number][] = [];
    wire.onLevel((level) => edges.push([clock.nowUs, level]));
    end.drive(1);
    end.drive(0);
    end.release();
    passMs(30);
    const [, , rise, fall] = edges;
    expect(edges.map(([, level]) => level)).toEqual([1, 0, 1, 0]);
    expect(Math.abs((fall?.[0] ?? 0) - (rise?.[0] ?? 0) - 1746)).toBeLessThanOrEqual(1);
  });
});

describe('bit:bot XL, driven with mbbitbot', () => {
  const drive = (program: string, forMs = 1500, setup?: FloorSetup) => {
    const floor = stand(setup);
    const { lines, exception } = floor.run(firmware, `from mbbitbot import *\n${program}`, forMs);
    expect(exception).toBeNull();
    return { ...floor, lines };
  };

  it.each([
    ['forward()', 1],
    ['backward()', -1],
  ])('%s drives straight on, 20 cm in about a second', (program, direction) => {
    const { xMm, yMm } = drive(program).chassis.pose();
    expect((xMm - 1000) * direction).toBeGreaterThan(200);
    expect((xMm - 1000) * direction).toBeLessThan(350);
    expect(Math.abs(yMm - 1000)).toBeLessThan(0.1);
  });

  it.each([
    ['left()', -1],
    ['right()', 1],
    ['leftArc(1)', 1],
    ['rightArc(1)', -1],
  ])('%s turns to the side that the original turns to', (program, turn) => {
    expect(drive(program).chassis.turnedRad() * turn).toBeGreaterThan(1);
  });

  it('setSpeed() decides how far it gets: 8 nowhere, 20 less than 50, 50 less than 100', () => {
    const paths = [8, 20, 50, 100].map((percent) => drive(`setSpeed(${percent})\nforward()`).chassis.pathMm());
    expect(paths[0]).toBe(0);
    expect([...paths].sort((a, b) => a - b)).toEqual(paths);
    expect(paths[2]! / paths[1]!).toBeGreaterThan(1.3);
  });

  it('stop() makes both wheels stand', () => {
    const { chassis } = drive('forward()\nsleep(800)\nstop()');
    expect([chassis.wheelSpeedMmPerS(0), chassis.wheelSpeedMmPerS(1)]).toEqual([0, 0]);
  });

  it.each([5, 42, 100])('getDistance() gives %i for a wall so many cm and a half ahead', (cm) => {
    const { lines } = drive('print(getDistance())', 500, wallAt(1000 + 70 + cm * 10 + 5 + 5));
    expect(lines).toEqual([String(cm)]);
  });

  it('its pupils’ program follows a line round two bends of 30 cm and ends on it', () => {
    const bend = Array.from({ length: 31 }, (_, i) => {
      const angle = (Math.PI * i) / 30 - Math.PI / 2;
      return { x: 1400 + 300 * Math.cos(angle), y: 1300 + 300 * Math.sin(angle) };
    });
    const pointsMm = [{ x: 900, y: 1000 }, ...bend, { x: 700, y: 1600 }];
    const prepare: FloorSetup['prepare'] = (world) => world.addStroke({ pointsMm, widthMm: 25, reflectance: 0 });
    const { chassis, robot } = drive(readFileSync(`${import.meta.dirname}/examples/line.py`, 'utf8'), 8000, {
      prepare,
    });
    expect(chassis.pathMm()).toBeGreaterThan(1000);
    expect(chassis.turnedRad()).toBeGreaterThan(2.5);
    expect(robot.state().lineSensors.some(({ bright }) => !bright)).toBe(true);
  });
});
