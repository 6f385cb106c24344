import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { cutebotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}, forMs = 1500) {
  const floor = putOnFloor(cutebotBuild, setup);
  const { lines, exception } = floor.run(firmware, program, forMs);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A wall this many cm ahead of the distance sensor. */
const wallAhead = (cm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1000 + 57 + cm * 10 + 5;
    world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 });
  },
});

/** A driver in the style of Elecfreaks': a class, private pins, lists of four numbers, a rounded distance. */
const BY_CLASS = `
from microbit import *
from time import sleep_us
from machine import time_pulse_us

class Car(object):
    def __init__(self):
        i2c.init()
        self.__lines = (pin13, pin14)
        for pin in self.__lines:
            pin.set_pull(pin.PULL_UP)

    def wheels(self, *speeds: int):
        for wheel, speed in enumerate(speeds):
            way = 0x02 if speed > 0 else 0x01
            i2c.write(0x10, bytearray([wheel + 1, way, speed if speed > 0 else speed * -1, 0]))

    def lamp(self, which: int, R: int, G: int, B: int):
        i2c.write(0x10, bytearray([which, R, G, B]))

    def servo(self, number, angle):
        i2c.write(0x10, bytearray([number + 4, angle, 0, 0]))

    def far(self):
        pin12.read_digital()
        pin8.write_digital(1)
        sleep_us(10)
        pin8.write_digital(0)
        return round(time_pulse_us(pin12, 1, 25000) * 34 / 2 / 1000)

    def track(self):
        return "".join("01"[pin.read_digital() == 0] for pin in self.__lines)

car = Car()
`;

/** A driver in the style of Krakenus' and Vittascience's: functions, constants, one buffer filled byte by byte. */
const BY_FUNCTIONS = `
from machine import time_pulse_us
from utime import sleep_us
from micropython import const
from microbit import i2c, pin8, pin12, pin13, pin14, sleep

ADDRESS = const(16)
FRAME = bytearray(4)

def say(part: int, a: int, b: int = 0, c: int = 0) -> None:
    FRAME[0] = part
    FRAME[1] = a
    FRAME[2] = b
    FRAME[3] = c
    i2c.write(ADDRESS, FRAME)

def wheel(which: int, speed: int) -> None:
    say(which, 2 if speed >= 0 else 1, abs(speed))

def sonar(timeout_us: int = 30000) -> float:
    pin8.write_digital(0)
    sleep_us(5)
    pin8.write_digital(1)
    sleep_us(10)
    pin8.write_digital(0)
    echo = time_pulse_us(pin12, 1, timeout_us)
    return echo if echo < 0 else echo / 2 / 29.1
`;

describe('Cutebot, driven by a stranger’s class', () => {
  it('drives forward, turns and stops as it is told', () => {
    const { chassis } = drive(
      `${BY_CLASS}car.wheels(50, 50)\nsleep(600)\ncar.wheels(-40, 40)\nsleep(300)\ncar.wheels(0, 0)`,
    );
    expect(chassis.pose().xMm).toBeGreaterThan(1120);
    expect(chassis.turnedRad()).toBeGreaterThan(1);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });

  it('lights its headlamps in two colours and turns a servo', () => {
    const { robot } = drive(`${BY_CLASS}car.lamp(0x04, 90, 0, 0)\ncar.lamp(0x08, 0, 90, 255)\ncar.servo(2, 45)`);
    expect(robot.state().rgb.slice(0, 2)).toEqual([[90, 0, 0], [0, 90, 255]]); // prettier-ignore
    expect(robot.state().servos).toEqual({ S2: 45 });
  });

  it('measures 40 cm', () => {
    expect(drive(`${BY_CLASS}print(car.far())`, wallAhead(40)).lines).toEqual(['40']);
  });

  it('sees a line of 20 mm with both sensors', () => {
    const prepare: FloorSetup['prepare'] = (world) => {
      const pointsMm = [900, 1200].map((x) => ({ x, y: 1000 }));
      world.addStroke({ pointsMm, widthMm: 20, reflectance: 0 });
    };
    expect(drive(`${BY_CLASS}print(car.track())`).lines).toEqual(['00']);
    expect(drive(`${BY_CLASS}print(car.track())`, { prepare }).lines).toEqual(['11']);
  });
});

describe('Cutebot, driven by a stranger’s functions', () => {
  it('drives backward in a curve by one buffer that is used again and again', () => {
    const { chassis } = drive(`${BY_FUNCTIONS}wheel(1, -60)\nwheel(2, -30)\nsleep(700)\nwheel(1, 0)\nwheel(2, 0)`);
    expect(chassis.pose().xMm).toBeLessThan(950);
    expect(chassis.turnedRad()).toBeGreaterThan(0.5);
    expect(chassis.duty(0)).toBe(0);
  });

  it('keeps a distance of 20 cm: it comes nearer from 60 cm and stays within 4.5 cm', () => {
    const program = `${BY_FUNCTIONS}
while True:
    speed = max(-60, min(60, int(4 * (sonar() - 20))))
    if abs(speed) < 16:
        speed = 0
    wheel(1, speed)
    wheel(2, speed)
    sleep(20)`;
    const { chassis } = drive(program, wallAhead(60), 4000);
    const distanceCm = (1000 + 57 + 600 - (chassis.pose().xMm + 57)) / 10;
    expect(Math.abs(distanceCm - 20)).toBeLessThan(4.5);
    expect(chassis.duty(0)).toBe(0);
  });

  it('gets −1 from an echo that is longer than its patience', () => {
    expect(drive(`${BY_FUNCTIONS}print(sonar(5000))`, wallAhead(120)).lines).toEqual(['-1']);
  });
});

describe('Cutebot, other ways of strangers', () => {
  it('is found by a scan of the bus, at 0x10 alone', () => {
    const { lines } = drive('from microbit import i2c\nprint(i2c.scan())');
    expect(lines).toEqual(['[16]']);
  });

  it('listens at 400 kHz and to a last False', () => {
    const { robot } = drive(
      'from microbit import *\ni2c.init(freq=400000, sda=pin20, scl=pin19)\ni2c.write(0x10, b"\\x01\\x02\\x1e\\x00", False)',
    );
    expect(robot.state().duty).toEqual({ left: 0.3, right: 0 });
  });

  it('lights the two NeoPixels at pin 15, also for a program that has 24 there (pxt-cutebot README)', () => {
    const { robot } = drive(`
from microbit import pin15
from neopixel import NeoPixel
np = NeoPixel(pin15, 24)
for place in range(24):
    np[place] = (place, 20, 30)
np.show()`);
    expect(robot.state().rgb.slice(2)).toEqual([[0, 20, 30], [1, 20, 30]]); // prettier-ignore
  });

  it('measures for a loop that polls the echo itself', () => {
    const program = `
from microbit import *
import utime
pin8.write_digital(1)
utime.sleep_us(10)
pin8.write_digital(0)
while pin12.read_digital() == 0:
    pass
rise = utime.ticks_us()
while pin12.read_digital() == 1:
    pass
print(round(utime.ticks_diff(utime.ticks_us(), rise) / 58))`;
    expect(Math.abs(Number(drive(program, wallAhead(50)).lines[0]) - 50)).toBeLessThanOrEqual(1);
  });

  it('refuses half a speed in a bytearray as MicroPython does: 100 / 2 is 50.0 (vittascience go_forward)', () => {
    const { run } = putOnFloor(cutebotBuild);
    const program = 'frame = bytearray(4)\nframe[2] = 100 / 2';
    expect(run(firmware, program, 100).exception).toBe("TypeError: can't convert float to int");
  });
});
