import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV2Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV2Build, setup);
  const { lines, exception } = floor.run(firmware, `from microbit import *\n${program}`, 2500);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A wall this many cm ahead of the distance sensor. */
const wallAhead = (cm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1000 + 76 + cm * 10 + 5;
    world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 });
  },
});

describe('Maqueen Plus V2, the ways in which drivers of strangers talk to it', () => {
  it('is found by i2c.scan() and tells its version, first the length, then the text (lawther/maqueenplus)', () => {
    const { lines } = drive(`
print(0x10 in i2c.scan())
i2c.write(0x10, bytes([0x32]))
count = int.from_bytes(i2c.read(0x10, 1), "big")
i2c.write(0x10, bytes([0x33]))
text = i2c.read(0x10, count).decode("ascii")
print(text, int(text[-3:][0]), int(text[-3:][2]))`);
    expect(lines).toEqual(['True', 'MBT0021-EN-2.1 2 1']);
  });

  it('drives with three bytes per motor, reads direction and speed back, and turns around (almasy/micropython-maqueen-plus)', () => {
    const { lines, chassis } = drive(`
for register in (0, 2):
    i2c.write(0x10, bytes((register, 0, 60)))
sleep(300)
i2c.write(0x10, b'\\x02')
direction, speed = i2c.read(0x10, 2)
print(direction, speed)
for register in (0, 2):
    i2c.write(0x10, bytes((register, 1 - direction, speed // 2)))
    i2c.write(0x10, bytes((register,)))
    print(list(i2c.read(0x10, 2)))`);
    expect(lines).toEqual(['0 60', '[1, 30]', '[1, 30]']);
    expect(chassis.wheelSpeedMmPerS(0)).toBeLessThan(-20);
  });

  it('takes DFRobot’s start: the reset register of the V3, then the wait for a version', () => {
    const { lines } = drive(`
i2c.write(0x10, bytes([0x49, 1]))
sleep(100)
i2c.write(0x10, bytes([0x32]))
while not i2c.read(0x10, 1)[0]:
    sleep(500)
print("ready")`);
    expect(lines).toEqual(['ready']);
  });

  it.each([
    ['a trigger of 10 µs', 'pin13.write_digital(1)\nutime.sleep_us(10)\npin13.write_digital(0)'],
    ['no pause at all', 'pin13.write_digital(1)\npin13.write_digital(0)'],
    [
      'a trial of 1 ms, then a trigger of 20 ms (DFRobot, lawther)',
      'pin13.write_digital(1)\nsleep(1)\npin13.write_digital(0)\nif pin14.read_digital() == 0:\n    pin13.write_digital(1)\n    sleep(20)\n    pin13.write_digital(0)',
    ],
  ])('measures 40 cm after %s', (_, trigger) => {
    const program = `import machine, utime\n${trigger}\nprint(round(machine.time_pulse_us(pin14, 1, 30000) / 58.2))`;
    expect(drive(program, wallAhead(40)).lines).toEqual(['40']);
  });

  it('measures 40 cm for a program that watches the echo itself with ticks_us', () => {
    const program = `
import utime
pin13.write_digital(1)
pin13.write_digital(0)
while pin14.read_digital() == 0:
    start = utime.ticks_us()
while pin14.read_digital() == 1:
    end = utime.ticks_us()
print(round((end - start) / 58.2))`;
    expect(drive(program, wallAhead(40)).lines).toEqual(['40']);
  });

  it('turns a servo by write_analog without a period: 77 of 1024 of 20 ms is 90 degrees (lawther/maqueenplus)', () => {
    expect(drive('pin1.write_analog(77)').robot.state().servos).toEqual({ P1: 90 });
  });

  it('turns a servo by pulses that the program makes with write_digital: 1 ms is about 45 degrees', () => {
    const program = `
import utime
for i in range(20):
    pin2.write_digital(1)
    utime.sleep_us(1000)
    pin2.write_digital(0)
    sleep(19)`;
    expect(Math.abs(drive(program).robot.state().servos['P2']! - 45)).toBeLessThanOrEqual(3);
  });

  it('leaves the servo on P0 alone while music plays there', () => {
    expect(drive('import music\nmusic.play(music.NYAN)').robot.state().servos).toEqual({});
  });

  it('has a receiver at P16 that hears no remote control: high', () => {
    expect(drive('print(pin16.read_digital())').lines).toEqual(['1']);
  });
});
