import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV1Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV1Build, setup);
  const { lines, exception } = floor.run(firmware, `from microbit import *\nimport struct\n${program}`, 3000);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A wall this many cm ahead of the distance sensor. */
const wallAhead = (cm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1000 + 74 + cm * 10 + 5;
    world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 });
  },
});

describe('Maqueen Plus V1, the ways in which drivers of strangers talk to it', () => {
  it('lets eight bytes be read where four are meant: both motors, then the pulses (jsuijs, Koraze)', () => {
    const { lines } = drive(`
i2c.write(0x10, bytearray([0, 1, 100, 2, 90]))
i2c.write(0x10, bytearray([0]))
print(struct.unpack('>BBBB', i2c.read(0x10, 8)))`);
    expect(lines).toEqual(['(1, 100, 2, 90)']);
  });

  it('sets all pulses back by three zeros, and one wheel’s by one', () => {
    const { lines } = drive(`
def pulses():
    i2c.write(0x10, bytes([4]))
    return struct.unpack('>HH', i2c.read(0x10, 4))
i2c.write(0x10, bytes([0, 1, 120, 1, 120]))
sleep(500)
i2c.write(0x10, bytes([0, 0, 0, 0, 0]))
sleep(300)
left, right = pulses()
print(left > 20, right > 20)
i2c.write(0x10, bytes([6, 0]))
print(pulses() == (left, 0))
i2c.write(0x10, bytes([4, 0, 0, 0]))
print(pulses())`);
    expect(lines).toEqual(['True True', 'True', '(0, 0)']);
  });

  it('drives 30 cm by its pulses, within 3 cm', () => {
    const { chassis } = drive(`
i2c.write(0x10, bytes([0, 1, 60, 1, 60]))
while True:
    i2c.write(0x10, bytes([4]))
    left, right = struct.unpack('>HH', i2c.read(0x10, 4))
    if left + right >= 2 * 80 * 300 / 135:
        break
i2c.write(0x10, bytes([0, 0, 0, 0, 0]))
sleep(300)`);
    expect(Math.abs(chassis.pose().xMm - 1300)).toBeLessThan(30);
  });

  it('turns three servos by one write (Koraze), and none moves for a motor’s compensation', () => {
    const { robot } = drive('i2c.write(0x10, bytes([0x14, 10, 20, 30]))\ni2c.write(0x10, bytes([0x08, 50]))');
    expect(robot.state().servos).toEqual({ S1: 10, S2: 20, S3: 30 });
  });

  it('measures 40 cm for a driver that lets the trigger high between two measurements (informatiquecsud urm10.py)', () => {
    const { lines } = drive(
      `
import machine
for i in range(3):
    pin1.write_digital(0)
    pin2.read_digital()
    pin1.write_digital(1)
    print(round(machine.time_pulse_us(pin2, 1, 29000) / 58.2))
    sleep(100)`,
      wallAhead(40),
    );
    expect(lines.slice(1)).toEqual(['40', '40']);
  });

  it('stops by directions alone: two bytes for each motor (Gueneau)', () => {
    const { chassis } = drive(`
i2c.write(0x10, bytes([0, 1, 100, 1, 100]))
sleep(500)
i2c.write(0x10, bytes([0, 0]))
i2c.write(0x10, bytes([2, 0]))
sleep(400)`);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
    expect(chassis.pose().xMm).toBeGreaterThan(1050);
  });
});
