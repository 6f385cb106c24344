import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type Floor, type FloorSetup } from '../testing/floor';
import { motionkit2Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Run extends Floor {
  readonly lines: readonly string[];
}

/** Runs a program that brings its own driver; the robot stands at (1000, 1000) and looks along +x. */
function run(program: string, setup: FloorSetup = {}, forMs = 2000): Run {
  const floor = putOnFloor(motionkit2Build, setup);
  const { lines, exception } = floor.run(firmware, program, forMs);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A wall this many cm ahead of the distance sensor. */
const wallAhead = (cm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1000 + 55 + cm * 10 + 5;
    world.addWall({ fromMm: { x, y: 400 }, toMm: { x, y: 1600 }, thicknessMm: 10 });
  },
});

/** A black line along the path, its middle this many mm to the left of the robot's. */
const lineAt = (leftMm: number): FloorSetup => ({
  prepare: (world) =>
    world.addStroke({ pointsMm: [800, 1400].map((x) => ({ x, y: 1000 + leftMm })), widthMm: 10, reflectance: 0 }),
});

/**
 * A driver in the way of the Calliope editor's own module: functions, a buffer for each register, 0x00 called right
 * (calliope-edu/calliope-mini-python-editor `MotionKitV2.py`).
 */
const EDITOR = `
from calliopemini import *
i2c.init()

def put(register, *values):
    buffer = bytearray(1 + len(values))
    buffer[0] = register
    for at in range(len(values)):
        buffer[at + 1] = values[at]
    i2c.write(0x10, buffer)

def take(register, count, pause=0):
    i2c.write(0x10, bytearray([register]))
    sleep(pause)
    return i2c.read(0x10, count)

def motorR(dir, speed):
    put(0x00, dir, speed)

def motorL(dir, speed):
    put(0x02, dir, speed)

def led(right_left, on_off):
    put(0x0C if right_left else 0x0B, on_off)

def rgbLed(red, green, blue):
    put(0x18, red)
    put(0x19, green)
    put(0x1A, blue)

def servoS1(angle):
    put(0x14, angle)

def servoS2(angle):
    put(0x15, angle)

def read_lineFollowR():
    return 0 if take(0x1D, 1)[0] & 0x01 else 1

def read_lineFollowL():
    return 0 if take(0x1D, 1)[0] & 0x02 else 1

def read_ultrasonic():
    high, low = take(0x28, 2, 20)
    return (high << 8) | low

def read_infared():
    a, b, c, d = take(0x2B, 4)
    return (d | (c << 8) | (b << 16) | (a << 24)) % 1000
`;

describe('MotionKit 2, a module in the way of the Calliope editor’s', () => {
  const editor = (program: string, setup?: FloorSetup) => run(`${EDITOR}\n${program}`, setup);

  it('drives straight on, and back', () => {
    expect(editor('motorR(0, 60)\nmotorL(0, 60)').chassis.pose().xMm).toBeGreaterThan(1200);
    expect(editor('motorR(1, 60)\nmotorL(1, 60)').chassis.pose().xMm).toBeLessThan(800);
  });

  it('turns to the other side than its names say, as the maker’s left is its right; with the option “all swapped” to the same', () => {
    const turned = (setup?: FloorSetup) => editor('motorR(0, 60)', setup).chassis.turnedRad();
    expect(turned()).toBeLessThan(-1); // the left wheel turns
    expect(turned({ options: { sides: 'all-swapped' } })).toBeGreaterThan(1);
  });

  it('lights the lamp that it calls right, on the left by the maker, on the right with the option', () => {
    const leds = (sides: string) => editor('led(0, 1)', { options: { sides } }).robot.state().leds;
    expect(leds('maker')).toEqual({ left: 1, right: 0 });
    expect(leds('all-swapped')).toEqual({ left: 0, right: 1 });
  });

  it('colours all lights alike and moves both servos', () => {
    const { rgb, servos } = editor('rgbLed(10, 20, 30)\nservoS1(45)\nservoS2(135)').robot.state();
    expect(rgb.map(String)).toEqual(Array(4).fill('10,20,30'));
    expect(servos).toEqual({ S1: 45, S2: 135 });
  });

  it('sees a line below the left sensor: as right by the maker, as left with the option', () => {
    const program = 'print(read_lineFollowL(), read_lineFollowR())';
    expect(editor(program, lineAt(7)).lines).toEqual(['1 0']);
    expect(editor(program, { ...lineAt(7), options: { sides: 'all-swapped' } }).lines).toEqual(['0 1']);
  });

  it('measures 40 cm, and hears no remote control', () => {
    expect(editor('print(read_ultrasonic(), read_infared())', wallAhead(40)).lines).toEqual(['40 0']);
  });
});

/**
 * A class in the way of the maker's own MicroPython module of 2021, for the older MotionKit 2 with its parts on pins: motors
 * and servos by I2C as today, the rest at P1, P2, P8, P12 … P15 (tinysuperlab/MotionKitV2MicroPython `motionkit.py`).
 */
const MAKER = `
from calliopemini import *
import neopixel
import utime

class Kit:
    def __init__(self):
        i2c.init()
        self.lights = neopixel.NeoPixel(pin15, 4)
        pin1.write_digital(0)

    def motor_left(self, speed=0, direction=0):
        i2c.write(0x10, bytearray((0x00, direction, speed)))

    def motor_right(self, speed=0, direction=0):
        i2c.write(0x10, bytearray((0x02, direction, speed)))

    def servo_one(self, angle=0):
        i2c.write(0x10, bytearray((0x14, angle)))

    def led_left(self, value):
        pin8.write_digital(value)

    def rgb_front_left(self, red, green, blue):
        self.lights[0] = (red, green, blue)
        self.lights.show()

    def line_left(self):
        return 1 if pin13.read_digital() else 0

    def ultrasound_measure(self):
        pin1.write_digital(1)
        utime.sleep_us(10)
        pin1.write_digital(0)
        start = utime.ticks_us()
        while not pin2.read_digital():
            if utime.ticks_diff(utime.ticks_us(), start) > 5000:
                return -1
        return 0

kit = Kit()
`;

describe('MotionKit 2, a class in the way of the maker’s', () => {
  it('drives, turns on the spot and stops with the defaults of its methods', () => {
    const program = 'kit.motor_left(30)\nkit.motor_right(30, 1)\nsleep(1000)\nkit.motor_left()\nkit.motor_right()';
    const { chassis } = run(`${MAKER}\n${program}`);
    expect(chassis.turnedRad()).toBeLessThan(-2);
    expect([chassis.wheelSpeedMmPerS(0), chassis.wheelSpeedMmPerS(1)]).toEqual([0, 0]);
  });

  it('moves its servo', () => {
    expect(run(`${MAKER}\nkit.servo_one(60)`).robot.state().servos).toEqual({ S1: 60 });
  });

  it('finds nothing on the pins, where only the older robot has its parts: no light, no line, distance −1', () => {
    const program = 'kit.led_left(1)\nkit.rgb_front_left(9, 9, 9)\nprint(kit.line_left(), kit.ultrasound_measure())';
    const { robot, lines } = run(`${MAKER}\n${program}`, wallAhead(20));
    expect(lines).toEqual(['0 -1']);
    expect(robot.state()).toMatchObject({ leds: { left: 0, right: 0 }, rgb: Array(4).fill([0, 0, 0]) });
  });
});

describe('MotionKit 2, what else strangers do', () => {
  it('is found at 0x10 alone and tells its version in one read of 21 bytes, on a board called microbit (chbijou/mpyCalliope)', () => {
    const program = `from microbit import *
i2c.init()
print(i2c.scan())
i2c.write(0x10, bytearray([0x32]))
answer = i2c.read(0x10, 21)
print(answer[1:answer[0] + 1])`;
    expect(run(program).lines).toEqual(['[16]', "b'MotionKit2-V1.0'"]);
  });

  it('takes both motors in one write and negative powers that wrap', () => {
    const { robot } = run('from calliope_mini import *\ni2c.write(0x10, bytearray([0, 1, -90, 0, 90]))');
    expect(robot.state().duty).toEqual({ left: -166 / 255, right: 90 / 255 });
  });

  it('follows a line by the byte of 0x1D: 3 straight on, 1 to the left, 2 to the right (chbijou/mpyCalliope mklib)', () => {
    const program = `from microbit import *
def motors(left, right):
    i2c.write(0x10, bytes((0, 0, left)))
    i2c.write(0x10, bytes((2, 0, right)))
while True:
    i2c.write(0x10, b"\\x1d")
    seen = i2c.read(0x10, 1)[0]
    if seen == 3:
        motors(30, 30)
    elif seen == 1:
        motors(0, 30)
    elif seen == 2:
        motors(30, 0)`;
    const curve = Array.from({ length: 60 }, (_, i) => ({ x: 900 + i * 20, y: 1000 + (i * i) / 8 }));
    const { chassis, robot } = run(
      program,
      { prepare: (world) => world.addStroke({ pointsMm: curve, widthMm: 20, reflectance: 0 }) },
      7000,
    );
    const { xMm, yMm } = chassis.pose();
    expect(xMm).toBeGreaterThan(1500);
    expect(Math.abs(yMm - (1000 + ((xMm - 900) / 20) ** 2 / 8))).toBeLessThan(25);
    expect(robot.state().lineSensors.some(({ bright }) => !bright)).toBe(true);
  });

  it('measures byte by byte, the low one first (tinysuperlab/MotionKitV2 ultrasonic)', () => {
    const program = `from calliopemini import *
def take(register):
    i2c.write(0x10, bytes([register]))
    return i2c.read(0x10, 1)[0]
print(take(0x29), take(0x28))`;
    expect(run(program, wallAhead(150)).lines).toEqual(['150 0']);
  });

  it('raises the device’s error for a Calli:bot, which is not there: ENODEV', () => {
    const program = `from calliope_mini import *
try:
    i2c.write(0x20, bytes(5))
except OSError as error:
    print(error)`;
    expect(run(program).lines).toEqual(['[Errno 19] ENODEV']);
  });
});
