import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenLiteBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenLiteBuild, setup);
  const { lines, exception } = floor.run(firmware, `from microbit import *\nimport machine, utime\n${program}`, 2500);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A wall this many cm ahead of the distance sensor. */
const wallAhead = (cm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1000 + 55 + cm * 10 + 5;
    world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 });
  },
});

describe('Maqueen Lite, the ways in which drivers of strangers measure a distance', () => {
  it.each([
    ['a pause of 10 ms and a look at the echo (Prolobot)', 'sleep(10)', 'pin2.read_digital()'],
    ['15 µs', 'utime.sleep_us(15)', ''],
    ['no pause at all (oohito)', '', ''],
  ])('measures 50 cm after a trigger of %s', (_, pause, before) => {
    const program = `
pin1.write_digital(1)
${pause}
pin1.write_digital(0)
${before}
print(round(machine.time_pulse_us(pin2, 1) / 58.2))`;
    expect(drive(program, wallAhead(50)).lines).toEqual(['50']);
  });

  it('measures for loops that give up after 5 ms: 40 cm are heard, 120 cm are not (Robertson, Holm)', () => {
    const program = `
def wait(level):
    begin = utime.ticks_us()
    while pin2.read_digital() != level:
        if utime.ticks_diff(utime.ticks_us(), begin) > 5000:
            return None
    return utime.ticks_us()
pin1.write_digital(1)
utime.sleep_us(10)
pin1.write_digital(0)
rise = wait(1)
fall = wait(0)
print(None if fall is None else round(utime.ticks_diff(fall, rise) / 58))`;
    expect(drive(program, wallAhead(40)).lines).toEqual(['40']);
    expect(drive(program, wallAhead(120)).lines).toEqual(['None']);
  });

  it('hears nothing within 10.5 ms when the wall is farther than 180 cm (Sawicki)', () => {
    const program = `
pin1.write_digital(1)
utime.sleep_us(10)
pin1.write_digital(0)
print(machine.time_pulse_us(pin2, 1, 10500))`;
    expect(Number(drive(program, wallAhead(170)).lines[0])).toBeGreaterThan(9800);
    expect(drive(program, wallAhead(190)).lines).toEqual(['-1']);
  });
});

describe('Maqueen Lite, the ways in which drivers of strangers drive', () => {
  it('takes a negative number in a bytearray for the byte it becomes: −80 is 176, forward', () => {
    const { chassis } = drive('i2c.write(0x10, bytearray([0, 0, -80, 0, -80]))\nsleep(500)');
    expect(chassis.duty(0)).toBeCloseTo(176 / 255);
    expect(chassis.pose().xMm).toBeGreaterThan(1050);
  });

  it('drives by the old way of three bytes with the bus opened anew at 400 kHz and a last False', () => {
    const { chassis } = drive(`
i2c.init(freq=400000, sda=pin20, scl=pin19)
for motor in (0, 2):
    data = bytearray(3)
    data[0] = motor
    data[2] = 100
    i2c.write(0x10, data, False)
sleep(500)`);
    expect(chassis.pose().xMm).toBeGreaterThan(1050);
  });

  it('brakes by a short push the other way', () => {
    const { chassis } = drive(`
i2c.write(0x10, bytes([0, 0, 120, 0, 120]))
sleep(800)
i2c.write(0x10, bytes([0, 1, 200, 1, 200]))
sleep(18)
i2c.write(0x10, bytes([0, 0, 0, 0, 0]))
sleep(400)`);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });
});

describe('Maqueen Lite, the infrared receiver for programs that decode it themselves', () => {
  it('never goes low: a wait for a burst ends with −2, a wait for its end with −1', () => {
    const program = `
pin16.set_pull(pin16.PULL_UP)
print(pin16.read_digital(), machine.time_pulse_us(pin16, 0, 50000), machine.time_pulse_us(pin16, 1, 50000))`;
    expect(drive(program).lines).toEqual(['1 -2 -1']);
  });
});

describe('Maqueen Lite for a driver of the V5 (humpda/maqueenliteV5_micropython)', () => {
  it('starts, tells its version, reads the three sensors and sets both lights at once', () => {
    const { lines, robot } = drive(`
i2c.write(0x10, bytearray([0x46, 1]))
sleep(100)
i2c.write(0x10, bytearray([50]))
print(i2c.read(0x10, 1, repeat=False)[0] > 0)
i2c.write(0x10, bytearray([29]))
print(i2c.read(0x10, 1)[0])
i2c.write(0x10, bytearray([34]))
high, low = i2c.read(0x10, 2)
print(high << 8 | low)
i2c.write(0x10, bytearray([11, 4, 0]))`);
    expect(lines).toEqual(['True', '0', '3500']);
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
  });
});
