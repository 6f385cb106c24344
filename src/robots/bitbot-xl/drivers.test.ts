/** Drivers in the styles of strangers, written anew: they reach the robot by its wires alone. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { attachHcSr04 } from '#devices/hc-sr04';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { runOnWires } from '../testing/wires';
import { bitbotXlBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}, forMs = 1500) {
  const floor = putOnFloor(bitbotXlBuild, setup);
  const { lines, exception } = floor.run(firmware, `from microbit import *\nimport utime, machine\n${program}`, forMs);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

const wallAhead = (cm: number): FloorSetup => {
  const x = 1000 + 70 + cm * 10 + 5;
  return { prepare: (world) => world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 }) };
};

/** Classes as in gmc-code/PC-Microbit-Extension: digital writes on one pin of a motor, PWM on the other. */
const CLASSES = `
class Wheel:
    def __init__(self, ahead, back):
        self.ahead, self.back = ahead, back
    def turn(self, speed):
        power = 0 if speed == 0 else abs(speed) * 100 + 23
        used, idle = (self.ahead, self.back) if speed > 0 else (self.back, self.ahead)
        idle.write_digital(0)
        used.write_analog(power)
    def halt(self):
        self.ahead.write_digital(0)
        self.back.write_digital(0)
class Motors:
    def __init__(self):
        self.wheels = Wheel(pin16, pin8), Wheel(pin14, pin12)
    def run(self, left, right, duration=None):
        for wheel, speed in zip(self.wheels, (left, right)):
            wheel.turn(speed)
        if duration is not None:
            utime.sleep_ms(duration)
            self.stop()
    def stop(self):
        for wheel in self.wheels:
            wheel.halt()
class Ranger:
    def distance(self):
        pin15.write_digital(1)
        utime.sleep_us(10)
        pin15.write_digital(0)
        while pin15.read_digital() == 0:
            start = utime.ticks_us()
        while pin15.read_digital() == 1:
            end = utime.ticks_us()
        return int(0.01715 * (end - start))
class Line:
    def read(self, side):
        bit = 0 if side == 'LEFT' else 1
        return 1 if i2c.read(0x1c, 1)[0] & (1 << bit) else 0
`;

describe('bit:bot XL with a driver of classes (in the style of gmc-code/PC-Microbit-Extension)', () => {
  it.each([
    ['run(2, 2)', 1, 0],
    ['run(-2, -2)', -1, 0],
    ['run(-2, 2)', 0, 1],
    ['run(2, -2)', 0, -1],
  ])('%s: forward %i, to the left %i', (call, ahead, turn) => {
    const { chassis } = drive(`${CLASSES}\nMotors().${call}`);
    const moved = chassis.pose().xMm - 1000;
    if (ahead === 0) expect(chassis.turnedRad() * turn).toBeGreaterThan(1);
    else expect(moved * ahead).toBeGreaterThan(150);
  });

  it('even moves at its slowest, 123 of 1023, and goes 1 second at its fastest', () => {
    expect(drive(`${CLASSES}\nMotors().run(1, 1)`).chassis.pathMm()).toBeGreaterThan(10);
    const { chassis } = drive(`${CLASSES}\nMotors().run(10, 10, 1000)`);
    expect(chassis.pathMm()).toBeGreaterThan(250);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });

  it('measures 40 cm and reads both line sensors', () => {
    const program = `${CLASSES}\nprint(Ranger().distance(), Line().read('LEFT'), Line().read('RIGHT'))`;
    expect(drive(program, wallAhead(40)).lines[0]).toMatch(/^(39|40) 0 0$/);
  });

  it('reads the right sensor from a second byte of the same read, too', () => {
    const pointsMm = [800, 1200].map((x) => ({ x, y: 992 }));
    const prepare: FloorSetup['prepare'] = (world) => world.addStroke({ pointsMm, widthMm: 10, reflectance: 0 });
    expect(drive('print(i2c.read(0x1c, 2)[1] & 2)', { prepare }).lines).toEqual(['2']);
  });
});

describe('bit:bot XL with the ways of the maker’s blocks (4tronix/BitBot), in Python', () => {
  it('measures with ten tries, dividing by 59, and gives 0 when no try is answered', () => {
    const program = `
def sonar():
    for attempt in range(10):
        pin15.write_digital(0)
        utime.sleep_us(2)
        pin15.write_digital(1)
        utime.sleep_us(10)
        pin15.write_digital(0)
        pin15.set_pull(pin15.NO_PULL)
        echo = machine.time_pulse_us(pin15, 1, 20000)
        if echo > 0:
            return round(echo / 59)
    return 0
print(sonar())`;
    expect(drive(program, wallAhead(60)).lines).toEqual(['59']);
    expect(drive(program, wallAhead(150)).lines).toEqual(['148']);
    const alone = runOnWires(`from microbit import *\nimport utime, machine\n${program}`, {
      build: bitbotXlBuild,
      firmware,
      chips: {},
      connect: (board, clock) => {
        const wire = board.wire('P15');
        attachHcSr04(clock, { trigger: wire, echo: wire }, () => Infinity);
      },
    });
    expect(alone.lines).toEqual(['0']);
  });

  it('finds version 5, reads the three bias values and drives with a longer PWM period', () => {
    const { lines, chassis } = drive(`
print(i2c.read(0x1c, 1)[0] >> 4)
bias = []
for address in range(3):
    i2c.write(0x50, bytes([0, address]))
    bias.append(i2c.read(0x50, 1)[0])
print(bias)
for pin in (pin16, pin14):
    pin.set_analog_period(60)
    pin.write_analog(200)`);
    expect(lines).toEqual(['5', '[0, 0, 0]']);
    expect(chassis.pathMm()).toBeGreaterThan(150);
  });

  it('brakes by four high pins, and reads both light sensors alike', () => {
    const { lines, chassis } = drive(`
for pin in (pin16, pin14):
    pin.write_digital(1)
sleep(300)
for pin in (pin16, pin8, pin14, pin12):
    pin.write_digital(1)
sleep(500)
print(pin1.read_analog(), pin2.read_analog())`);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
    expect(lines).toEqual(['509 509']); // 127 of 255
  });
});
