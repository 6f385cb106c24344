import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { Clock } from '#core/clock';
import { completeOptions, type OptionValues } from '#core/option';
import type { StrokeShape, WallShape } from '#world/shapes';
import { createWorld, type World } from '#world/world';
import { nothingAround, putOnFloor, type Floor } from '../testing/floor';
import { callibotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const onTheFloor = (prepare?: (world: World) => void, options: OptionValues = {}): Floor =>
  putOnFloor(callibotBuild, prepare ? { prepare, options } : { options });

/** Runs a program that has imported everything from callibot and returns the final state of the robot. */
function drive(program: string, floor: Floor = onTheFloor(), forMs = 3000) {
  const { lines, exception } = floor.run(firmware, `from callibot import *\n${program}`, forMs);
  expect(exception).toBeNull();
  const { xMm, yMm } = floor.chassis.pose();
  return { ...floor, lines, xMm: xMm - 1000, yMm: yMm - 1000, turned: floor.chassis.turnedRad() };
}

const line = (yMm: number, widthMm = 30): StrokeShape => ({
  pointsMm: [
    { x: 900, y: yMm },
    { x: 2900, y: yMm },
  ],
  widthMm,
  reflectance: 0,
});

/** Across the robot's path, its near face `distanceMm` ahead of the axle. */
const wallAhead = (distanceMm: number): WallShape => ({
  fromMm: { x: 1005 + distanceMm, y: 400 },
  toMm: { x: 1005 + distanceMm, y: 1600 },
  thicknessMm: 10,
});

/** The addresses that a program's `i2c.scan()` finds on a Calli:bot 2 or 2E. */
const ALL_ADDRESSES = '[32, 33, 34, 35, 36, 37, 38, 39]';

const int32 = (bytes: readonly number[]): number => new DataView(Uint8Array.from(bytes).buffer).getInt32(0, true);

function encoders({ readFrom }: Floor): readonly [number, number] {
  const answer = readFrom(0x22, 0x91, 9);
  return [int32(answer.slice(1, 5)), int32(answer.slice(5))];
}

describe('Calli:bot on the floor, through callibot', () => {
  it('drives forward with forward() and back with backward(), on a straight line', () => {
    const ahead = drive('forward()\ndelay(1000)\nstop()');
    expect(ahead.xMm).toBeGreaterThan(150);
    expect(Math.abs(ahead.yMm)).toBeLessThan(0.3); // the left motor is set 0.4 ms before the right one
    expect(drive('backward()\ndelay(1000)\nstop()').xMm).toBeCloseTo(-ahead.xMm, 0);
  });

  it('turns left with left() and right with right(), about the middle of its axle', () => {
    const left = drive('left()\ndelay(1000)\nstop()');
    expect(left.turned).toBeGreaterThan(Math.PI / 2);
    expect(Math.abs(left.xMm)).toBeLessThan(1);
    expect(drive('right()\ndelay(1000)\nstop()').turned).toBeCloseTo(-left.turned, 3);
  });

  it('stops within 2 cm with stop()', () => {
    const { chassis, xMm } = drive('forward()\ndelay(1500)\nstop()', undefined, 1500);
    expect(chassis.wheelSpeedMmPerS(0)).toBeGreaterThan(150);
    expect(drive('forward()\ndelay(1500)\nstop()').xMm - xMm).toBeLessThan(20);
  });

  it('drives faster with setSpeed(100) than with 50, and with 50 than with 20', () => {
    const ways = [20, 50, 100].map((speed) => drive(`setSpeed(${speed})\nforward()`, undefined, 1500).xMm);
    expect(ways[1]! / ways[0]!).toBeGreaterThan(1.2);
    expect(ways[2]! / ways[1]!).toBeGreaterThan(1.2);
  });

  it.each([
    ['leftArc', 1],
    ['rightArc', -1],
  ])('drives a circle to its side with %s(0.2)', (arc, side) => {
    expect(drive(`${arc}(0.2)`, undefined, 2000).turned * side).toBeGreaterThan(1);
  });

  it.each([
    [0.15, 50],
    [0.3, 50],
    [0.5, 50],
    [0.2, 30],
    [0.2, 100],
  ])('drives leftArc(%f) at speed %i within 25 percent of that radius', (radius, speed) => {
    const { chassis, passMs } = drive(`setSpeed(${speed})\nleftArc(${radius})`, undefined, 2000);
    const path = chassis.pathMm();
    const turned = chassis.turnedRad();
    passMs(1500);
    const drivenMm = (chassis.pathMm() - path) / (chassis.turnedRad() - turned);
    expect(Math.abs(drivenMm / (radius * 1000) - 1)).toBeLessThan(0.25);
  });

  it('turns one wheel alone with motL.rotate and motR.rotate of callibotmot', () => {
    const left = drive('from callibotmot import *\nmotL.rotate(40)', undefined, 1000);
    expect([left.chassis.wheelTurnRad(0) > 5, Math.abs(left.chassis.wheelTurnRad(1)) < 1]).toEqual([true, true]);
    const right = drive('from callibotmot import *\nmotR.rotate(-40)', undefined, 1000);
    expect([right.chassis.wheelTurnRad(1) < -5, Math.abs(right.chassis.wheelTurnRad(0)) < 1]).toEqual([true, true]);
  });

  it.each([
    ['setLED(1)', 1, 1],
    ['setLEDLeft(1)', 1, 0],
    ['setLEDRight(1)', 0, 1],
    ['setLEDLeft(1); setLEDRight(1)', 0, 1], // the second turns the first one off
    ['setLED(1); setLED(0)', 0, 0],
    ['from callibotmot import *; setLED(1)', 1, 1],
  ])('shows %s as left %i, right %i', (program, left, right) => {
    expect(drive(program).robot.state().leds).toEqual({ left, right });
  });
});

describe('Calli:bot, motors at the wire', () => {
  it.each([
    ['0x20', [0x20, 0, 0, 90, 0, 90]],
    ['0x22', [0x22, 2, 3, 0, 90, 0, 90]],
  ])('drives with both motors in one write to %s', (_, [address = 0, ...bytes]) => {
    const { send, passMs, chassis, robot } = onTheFloor();
    send(address, ...bytes);
    passMs(1000);
    expect(chassis.pose().xMm - 1000).toBeGreaterThan(150);
    expect(robot.state().duty.left).toBeCloseTo(90 / 255, 6);
  });

  it('rolls on for more than twice the way with power 1 (coasting) than with power 0 (brake), then stands', () => {
    const way = (power: number): number => {
      const { send, passMs, chassis } = onTheFloor();
      send(0x20, 0, 0, 200, 0, 200);
      passMs(1500);
      const path = chassis.pathMm();
      send(0x20, 0, 0, power, 0, power);
      passMs(3000);
      expect(Math.abs(chassis.wheelSpeedMmPerS(0))).toBeLessThan(1);
      return chassis.pathMm() - path;
    };
    expect(way(1) / way(0)).toBeGreaterThan(2);
  });

  it('stops for the reset [0x01] at 0x22, its lights go out', () => {
    const { send, passMs, chassis, robot } = onTheFloor();
    send(0x20, 0, 0, 90, 0, 90);
    send(0x21, 0, 3, 0xf7);
    passMs(500);
    send(0x22, 1);
    passMs(500);
    const { leds, rgb } = robot.state();
    expect([leds, rgb[0], chassis.wheelSpeedMmPerS(0)]).toEqual([{ left: 0, right: 0 }, [0, 0, 0], 0]);
  });
});

describe('Calli:bot, lights at the wire', () => {
  it('shows front left, rear left, rear right, front right, by the old byte and by 0x22', () => {
    const { send, robot } = onTheFloor();
    send(0x21, 1, 0xf1, 0xf2);
    send(0x22, 3, 3, 0, 0, 16);
    send(0x22, 3, 4, 16, 8, 0);
    expect(robot.state().rgb).toEqual([
      [0, 255, 0],
      [255, 0, 0],
      [0, 0, 255],
      [255, 128, 0],
    ]);
  });

  it('shows the red lights by the mask at 0x21 and by number at 0x22', () => {
    const { send, robot } = onTheFloor();
    send(0x21, 0, 2);
    expect(robot.state().leds).toEqual({ left: 0, right: 1 });
    send(0x22, 3, 5, 8);
    expect(robot.state().leds).toEqual({ left: 1, right: 1 });
  });
});

describe('Calli:bot, line sensors over a black line', () => {
  it.each([
    ['bare floor', [], 3, '1 1', 2800, 2800],
    ['a line below the left one', [line(1018)], 1, '0 1', 300, 2800],
    ['a line below the right one', [line(982)], 2, '1 0', 2800, 300],
    ['a line of 18 mm below both', [line(1000, 18)], 0, '0 0', 300, 300],
  ] as const)('sees %s as bits %#, mV and irLeftValue() irRightValue()', (_, strokes, bits, printed, mvL, mvR) => {
    const prepare = (world: World): void => strokes.forEach((stroke) => world.addStroke(stroke));
    const floor = onTheFloor(prepare);
    expect(floor.board.i2c.read(0x21, 1).bytes[0]).toBe(0x80 | bits);
    expect(floor.readFrom(0x22, 0x80, 1)).toEqual([bits]);
    expect(floor.readFrom(0x22, 0x84, 5)).toEqual([0x84, mvR & 255, mvR >> 8, mvL & 255, mvL >> 8]);
    const seen = floor.robot.state().lineSensors.map(({ name, bright, reading }) => [name, bright, reading]);
    expect(seen).toEqual([
      ['left', (bits & 2) !== 0, mvL],
      ['right', (bits & 1) !== 0, mvR],
    ]);
    expect(drive('print(irLeftValue(), irRightValue())', onTheFloor(prepare)).lines).toEqual([printed]);
  });

  it('notices a line while driving across it, 46 mm ahead of the axle', () => {
    const across: StrokeShape = { ...line(0), pointsMm: [{ x: 1200, y: 800 }, { x: 1200, y: 1200 }] }; // prettier-ignore
    const program = 'setSpeed(20)\nforward()\nwhile irLeftValue() and irRightValue():\n    pass\nstop()';
    const { xMm } = drive(
      program,
      onTheFloor((world) => world.addStroke(across)),
    );
    expect(xMm + 46).toBeGreaterThan(184);
    expect(xMm + 46).toBeLessThan(204);
  });
});

describe('Calli:bot, ultrasonic', () => {
  it('measures 435 mm to a wall 500 mm ahead of the axle: both byte orders, and 43.5 cm through getDistance()', () => {
    const floor = onTheFloor((world) => world.addWall(wallAhead(500)));
    expect([...floor.board.i2c.read(0x21, 3).bytes].slice(1)).toEqual([1, 179]);
    expect(floor.readFrom(0x22, 0x81, 3)).toEqual([0x81, 179, 1]);
    expect(floor.robot.state().ultrasonic?.distanceMm).toBeCloseTo(435, 6);
    expect(
      drive(
        'print(getDistance())',
        onTheFloor((world) => world.addWall(wallAhead(500))),
      ).lines,
    ).toEqual(['43.5']);
  });

  it.each([
    ['far', 4500],
    ['zero', 0],
  ])('gives with the option echo = %s %i mm when nothing is in range', (echo, mm) => {
    const board = new Board(calliopeMini3, new Clock());
    const world = createWorld({ widthMm: 12_000, heightMm: 4000 });
    const chassis = world.addChassis(callibotBuild.type.body, { xMm: 1000, yMm: 2000, headingRad: 0 });
    callibotBuild.attach({
      ...{ ...nothingAround, clock: board.clock, board, chassis },
      options: completeOptions(callibotBuild.type.options, { echo }),
    });
    expect([...board.i2c.read(0x21, 3).bytes].slice(1)).toEqual([mm >> 8, mm & 255]);
  });

  it('gives 20 mm for what is nearer', () => {
    const { readFrom } = onTheFloor((world) => world.addWall(wallAhead(70)));
    expect(readFrom(0x22, 0x81, 3)).toEqual([0x81, 20, 0]);
  });
});

describe('Calli:bot 2E, encoders', () => {
  it('count 3148 pulses to the metre on both wheels (calliope-net/callibot2), less on the way back', () => {
    const floor = onTheFloor();
    floor.send(0x20, 0, 0, 120, 0, 120);
    while (floor.chassis.pathMm() < 1000) floor.passMs(4);
    const mm = floor.chassis.pathMm();
    const [left, right] = encoders(floor);
    expect(Math.abs(left / mm - 3.148)).toBeLessThan(0.02);
    expect(right).toBe(left);
    floor.send(0x20, 0, 1, 120, 1, 120);
    floor.passMs(1500);
    expect(encoders(floor)[0]).toBeLessThan(left - 500);
  });

  it('count down from 0 on a wheel that turns back: left −, right + for a turn to the left', () => {
    const floor = onTheFloor();
    floor.send(0x20, 0, 1, 90, 0, 90);
    floor.passMs(1000);
    const [left, right] = encoders(floor);
    expect([left < -300, right > 300, Math.abs(left + right) < 3]).toEqual([true, true, true]);
  });

  it('count 791 pulses for a full turn on the spot', () => {
    const floor = onTheFloor();
    floor.send(0x20, 0, 1, 80, 0, 80);
    while (floor.chassis.turnedRad() < 2 * Math.PI) floor.passMs(4);
    expect(Math.abs((encoders(floor)[1] * 2 * Math.PI) / floor.chassis.turnedRad() - 791)).toBeLessThan(8);
  });

  it('start anew for [5, 1] on the left alone, for [5, 3] on both', () => {
    const floor = onTheFloor();
    floor.send(0x20, 0, 0, 90, 0, 90);
    floor.passMs(500);
    floor.send(0x20, 0, 0, 0, 0, 0);
    floor.passMs(500);
    floor.send(0x22, 5, 1);
    expect(encoders(floor)[0]).toBe(0);
    expect(encoders(floor)[1]).toBeGreaterThan(100);
    floor.send(0x22, 5, 3);
    expect(encoders(floor)).toEqual([0, 0]);
  });
});

describe('Calli:bot, the rest of the wire', () => {
  it('keeps the angles of its servos, at most 180°', () => {
    const { send, robot } = onTheFloor();
    expect(robot.state().servos).toEqual({});
    send(0x20, 0x14, 30, 200);
    expect(robot.state().servos).toEqual({ S1: 30, S2: 180 });
  });

  it('gives the supply voltage in mV', () => {
    const { readFrom } = putOnFloor(callibotBuild, { supplyMv: 4321 });
    expect(readFrom(0x22, 0x83, 3)).toEqual([0x83, 0xe1, 0x10]);
  });

  it.each([
    ['2E', [0x20, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26, 0x27]],
    ['2', [0x20, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26, 0x27]],
    ['1', [0x20, 0x21]],
  ])('answers as a %s at the addresses %j', (model, addresses) => {
    const { board } = onTheFloor(undefined, { model });
    expect([...Array(128).keys()].filter((address) => board.i2c.answers(address))).toEqual(addresses);
  });

  it('takes what is written to the addresses 0x23 … 0x27, does nothing with it and gives 0', () => {
    const { robot, send, readFrom } = onTheFloor();
    for (const address of [0x23, 0x24, 0x25, 0x26, 0x27]) {
      expect(send(address, 0, 0, 90, 0, 90)).toBe(true);
      expect(readFrom(address, 0, 2)).toEqual([0, 0]);
    }
    expect(robot.state()).toMatchObject({ duty: { left: 0, right: 0 }, leds: { left: 0, right: 0 } });
  });

  it.each([
    ['', ALL_ADDRESSES],
    ['i2c.init()', ALL_ADDRESSES],
    ['i2c.init(freq=400000, scl=pin_A0_SCL, sda=pin_A0_SDA)', ALL_ADDRESSES],
    ['i2c.init(freq=100000, sda=pin_A0_SDA, scl=pin_A0_SCL)', ALL_ADDRESSES],
    ['i2c.init(scl=pin0, sda=pin1)', '[]'], // its cable is in the other socket
  ])('answers to a bus that a program opens with “%s”: %s', (init, found) => {
    for (const module of ['calliopemini', 'calliope_mini', 'microbit']) {
      const { lines } = onTheFloor().run(firmware, `from ${module} import *\n${init}\nprint(i2c.scan())`);
      expect(lines).toEqual([found]);
    }
  });

  it('stands still and is silent once detached', () => {
    const { robot, send, chassis, passMs, board } = onTheFloor(undefined, { bumper: 'always' });
    send(0x20, 0, 0, 90, 0, 90);
    robot.detach();
    expect(send(0x20, 0, 0, 90, 0, 90)).toBe(false);
    passMs(1000);
    expect([chassis.pathMm(), board.i2c.answers(0x22), robot.state().bumper]).toEqual([0, false, null]);
  });
});
