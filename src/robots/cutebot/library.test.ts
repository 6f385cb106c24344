import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { CONTROLLER_ADDRESS } from './controller';
import { cutebotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program with another chip on the bus that only records what it receives. */
function framesOf(program: string): { readonly frames: number[][]; readonly exception: string | null } {
  const { board, robot, run } = putOnFloor(cutebotBuild);
  robot.detach();
  const frames: number[][] = [];
  board.i2c.attach(CONTROLLER_ADDRESS, {
    write: (bytes) => void frames.push([...bytes]),
    read: (count) => new Uint8Array(count),
  });
  return { frames, exception: run(firmware, program, 500).exception };
}

/** Runs a program on the robot. */
function onRobot(program: string, setup: FloorSetup = {}, forMs = 500) {
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

const lineAt = (leftMm: number, widthMm: number): FloorSetup => ({
  prepare: (world) => {
    const pointsMm = [900, 2000].map((x) => ({ x, y: 1000 + leftMm }));
    world.addStroke({ pointsMm, widthMm, reflectance: 0 });
  },
});

/** The ground in four cases: by the sensors that are on black. */
const GROUND = {
  none: {},
  left: lineAt(8, 10),
  right: lineAt(-8, 10),
  both: lineAt(0, 20),
} as const;

describe('cutebot: the functions, byte by byte (vittascience/microbit-libraries cutebot.py)', () => {
  it.each([
    ['set_motors_speed(30, -100)', [[1, 2, 30, 0], [2, 1, 100, 0]]],
    ['set_motors_speed(120, -120)', [[1, 2, 100, 0], [2, 1, 100, 0]]],
    ['set_motors_speed(33.7, 0)', [[1, 2, 33, 0], [2, 2, 0, 0]]],
    ['go_forward()', [[1, 2, 50, 0], [2, 2, 50, 0]]],
    ['go_backward()', [[1, 1, 50, 0], [2, 1, 50, 0]]],
    ['turn_left()', [[1, 1, 50, 0], [2, 2, 50, 0]]],
    ['turn_right()', [[1, 2, 50, 0], [2, 1, 50, 0]]],
    ['stop()', [[1, 2, 0, 0], [2, 2, 0, 0]]],
    ['set_left_rgb_led(255, 10, 0)', [[4, 255, 10, 0]]],
    ['set_right_rgb_led(1, 2, 3)', [[8, 1, 2, 3]]],
    ['set_left_rgb_led()', [[4, 0, 0, 0]]],
    ['set_right_rgb_led(b=9)', [[8, 0, 0, 9]]],
    ['set_left_rgb_led(256, -1, 7)', [[4, 0, 0, 7]]],
    ['set_servo_1_angle(30)', [[5, 30, 0, 0]]],
    ['set_servo_2_angle(200)', [[6, 180, 0, 0]]],
    ['set_servo_1_angle(-5)', [[5, 0, 0, 0]]],
  ])('%s sends %j', (program, frames) => {
    expect(framesOf(`import cutebot\ncutebot.${program}`)).toEqual({ frames, exception: null });
  }); // prettier-ignore
});

describe('CUTEBOT: Elecfreaks’ class, byte by byte (elecfreaks/EF_Produce_MicroPython Cutebot.py)', () => {
  it.each([
    ['set_motors_speed(30, -100)', [[1, 2, 30, 0], [2, 1, 100, 0]]],
    ['set_motors_speed(0, 1)', [[1, 1, 0, 0], [2, 2, 1, 0]]],
    ['set_car_light(left, 255, 10, 0)', [[4, 255, 10, 0]]],
    ['set_car_light(right, 1, 2, 3)', [[8, 1, 2, 3]]],
    ['set_car_light(0x08, 1, 2, 3)', [[8, 1, 2, 3]]],
    ['set_servo(1, 30)', [[5, 30, 0, 0]]],
    ['set_servo(2, 180)', [[6, 180, 0, 0]]],
  ])('%s sends %j', (program, frames) => {
    expect(framesOf(`from cutebot import *\nct = CUTEBOT()\nct.${program}`)).toEqual({ frames, exception: null });
  }); // prettier-ignore

  it.each([
    ['set_motors_speed(101, 0)', "A wheel's speed is 101: it must be from -100 to 100."],
    ['set_motors_speed(0, -150)', "A wheel's speed is -150: it must be from -100 to 100."],
    ['set_car_light(left, 256, 0, 0)', 'A part of the colour is 256: it must be from 0 to 255.'],
    ['set_car_light(1, 2, 50, 0)', 'light is 1: it must be left (4) or right (8).'],
    ['set_servo(3, 90)', 'servo is 3: it must be from 1 to 2.'],
    ['set_servo(1, 181)', 'angle is 181: it must be from 0 to 180.'],
  ])('%s sends nothing and raises a ValueError', (program, message) => {
    const { frames, exception } = framesOf(`from cutebot import *\nCUTEBOT().${program}`);
    expect([frames, exception]).toEqual([[], `ValueError: ${message}`]);
  });

  it('is there under the name of Elecfreaks’ file, Cutebot.py, too', () => {
    const { frames } = framesOf('from Cutebot import *\nct = CUTEBOT()\nct.set_motors_speed(5, 6)');
    expect(frames).toEqual([[1, 2, 5, 0], [2, 2, 6, 0]]); // prettier-ignore
  });
});

describe('cutebot in the world', () => {
  it.each([3, 10, 42, 100])('measures a wall %i cm ahead: in cm, in inches, in feet', (cm) => {
    const program = `
from cutebot import *
print(round(get_sonar_distance()))
print(round(get_sonar_distance(SONAR_IN) * 2.543))
print(CUTEBOT().get_distance())
print(round(CUTEBOT().get_distance(1) * 30.48))`;
    const told = onRobot(program, wallAhead(cm)).lines.map(Number);
    expect(told).toHaveLength(4);
    for (const value of told) expect(Math.abs(value - cm)).toBeLessThanOrEqual(cm === 100 ? 1 : 0.5);
  });

  it('gives a negative number by the function, 0 by the class, when no echo comes', () => {
    const { robot, run } = putOnFloor(cutebotBuild);
    robot.detach();
    const program = `
from cutebot import *
print(get_sonar_distance() < 0, CUTEBOT().get_distance(), CUTEBOT().get_distance(1))`;
    expect(run(firmware, program, 500).lines).toEqual(['True 0 0.0']);
  });

  it('gives -1.0 for a unit that the function does not know', () => {
    expect(onRobot('import cutebot\nprint(cutebot.get_sonar_distance(7))').lines).toEqual(['-1.0']);
  });

  it.each([
    ['none', 'False False', '0'],
    ['left', 'True False', '10'],
    ['right', 'False True', '1'],
    ['both', 'True True', '11'],
  ] as const)('sees black with these sensors: %s', (on, tracks, code) => {
    const program =
      'from cutebot import *\nprint(has_left_track(), has_right_track())\nprint(CUTEBOT().get_tracking())';
    expect(onRobot(program, GROUND[on]).lines).toEqual([tracks, code]);
  });

  it('follows a line with the class: 1 m along a straight one, though it begins 5 mm beside it', () => {
    const program = `
from microbit import sleep
from cutebot import CUTEBOT
ct = CUTEBOT()
while True:
    state = ct.get_tracking()
    if state == 10:
        ct.set_motors_speed(18, 30)
    elif state == 1:
        ct.set_motors_speed(30, 18)
    else:
        ct.set_motors_speed(30, 30)
    sleep(5)`;
    const { chassis } = onRobot(program, lineAt(5, 20), 4800);
    expect(chassis.pose().xMm).toBeGreaterThan(1900);
    expect(Math.abs(chassis.pose().yMm - 1005)).toBeLessThan(10);
  });

  it('raises OSError 19 when the robot is off', () => {
    const { robot, run } = putOnFloor(cutebotBuild);
    robot.detach();
    expect(run(firmware, 'import cutebot\ncutebot.go_forward()', 200).exception).toMatch(/^OSError: .*19/);
  });
});
