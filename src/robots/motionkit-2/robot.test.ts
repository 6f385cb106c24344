import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import type { World } from '#world/world';
import { nothingAround, putOnFloor, type Floor, type FloorSetup } from '../testing/floor';
import type { RobotContext, RobotOutput } from '../robot';
import { motionkit2Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const onTheFloor = (setup: FloorSetup = {}): Floor => putOnFloor(motionkit2Build, setup);

/** Runs a program that has imported everything from callimk; the robot stands at (1000, 1000) and looks along +x. */
function drive(program: string, setup: FloorSetup = {}, forMs = 2000) {
  const floor = onTheFloor(setup);
  const { lines, exception } = floor.run(firmware, `from callimk import *\n${program}`, forMs);
  expect(exception).toBeNull();
  const { xMm, yMm } = floor.chassis.pose();
  return { ...floor, lines, xMm: xMm - 1000, yMm: yMm - 1000, turned: floor.chassis.turnedRad() };
}

/** A wall across the path, this many mm ahead of the distance sensor. */
const wallAhead =
  (mm: number) =>
  (world: World): void => {
    const x = 1000 + 55 + mm + 5;
    world.addWall({ fromMm: { x, y: 400 }, toMm: { x, y: 1600 }, thicknessMm: 10 });
  };

/** A black line along the path, its middle this many mm to the left. */
const lineAt =
  (leftMm: number, widthMm: number) =>
  (world: World): void =>
    void world.addStroke({ pointsMm: [800, 1400].map((x) => ({ x, y: 1000 + leftMm })), widthMm, reflectance: 0 });

/** A robot on a floor without end, unless its surroundings say otherwise. */
function attachedWith(context: Partial<RobotContext>): Floor {
  const floor = onTheFloor();
  floor.robot.detach();
  const { clock, board, chassis } = floor;
  motionkit2Build.attach({ clock, board, chassis, ...nothingAround, ...context });
  return floor;
}

describe('MotionKit 2 on the floor, through callimk', () => {
  it('drives forward with forward() and back with backward(), on a straight line', () => {
    const ahead = drive('forward()\ndelay(1000)\nstop()');
    expect(ahead.xMm).toBeGreaterThan(100);
    expect(Math.abs(ahead.yMm)).toBeLessThan(0.5); // the left motor is set a moment before the right one
    expect(Math.abs(drive('backward()\ndelay(1000)\nstop()').xMm + ahead.xMm)).toBeLessThan(1);
  });

  it('turns left with left() and right with right(), about the middle of its axle', () => {
    const left = drive('left()\ndelay(1000)\nstop()');
    expect(left.turned).toBeGreaterThan(Math.PI / 2);
    expect(Math.abs(left.xMm) + Math.abs(left.yMm)).toBeLessThan(1);
    expect(drive('right()\ndelay(1000)\nstop()').turned).toBeCloseTo(-left.turned, 2);
  });

  it.each([
    [15, 7],
    [30, 16],
    [60, 24],
    [100, 29],
    [255, 36],
  ])('drives with setSpeed(%i) at %i cm/s: estimated, the Maqueen Lite’s', (speed, cmPerS) => {
    const { chassis } = drive(`setSpeed(${speed})\nbackward()`, {}, 1500);
    expect(Math.round(-chassis.wheelSpeedMmPerS(0) / 10)).toBe(cmPerS);
  });

  it('stands at byte 7 and moves at byte 8', () => {
    const way = (byte: number): number => {
      const { send, passMs, chassis } = onTheFloor();
      send(0x10, 0, 0, byte, 0, byte);
      passMs(2000);
      return chassis.pathMm();
    };
    expect(way(7)).toBe(0);
    expect(way(8)).toBeGreaterThan(5);
  });

  it.each([
    ['leftArc', 30, 13],
    ['leftArc', 50, 24],
    ['leftArc', 100, 58],
    ['rightArc', 50, -24],
  ])(
    'drives %s(0.3) at speed %i on a circle of %i cm: estimated, as nobody has measured it',
    (arc, speed, radiusCm) => {
      const { chassis, passMs } = drive(`setSpeed(${speed})\n${arc}(0.3)`);
      const [path, turned] = [chassis.pathMm(), chassis.turnedRad()];
      passMs(1500);
      const radiusMm = (chassis.pathMm() - path) / (chassis.turnedRad() - turned);
      expect(Math.round(radiusMm / 10)).toBe(radiusCm);
    },
  );

  it.each([
    ['motorL(0, 60)', 0, 1],
    ['motorL(1, 60)', 0, -1],
    ['motorR(0, 60)', 1, 1],
    ['motorR(1, 60)', 1, -1],
  ] as const)('turns one wheel alone with %s', (program, wheel, direction) => {
    const { chassis } = drive(program);
    expect(chassis.wheelTurnRad(wheel) * direction).toBeGreaterThan(5);
    expect(Math.abs(chassis.wheelTurnRad(wheel === 0 ? 1 : 0))).toBeLessThan(0.5);
  });

  it.each([
    ['setLED(1)', {}, 1, 1],
    ['setLED(1); setLED(0)', {}, 0, 0],
    ['setLEDLeft(1)', {}, 0, 1], // 0x0C: the maker’s right
    ['setLEDRight(1)', {}, 1, 0],
    ['setLEDLeft(1)', { sides: 'lights-swapped' }, 1, 0],
    ['setLEDRight(1)', { sides: 'lights-swapped' }, 0, 1],
  ])('shows %s with the options %j as left %i, right %i', (program, options, left, right) => {
    expect(drive(program, { options }, 100).robot.state().leds).toEqual({ left, right });
  });

  it('colours all lights below alike with rgbLED()', () => {
    const color: Rgb = [200, 100, 50];
    expect(drive('rgbLED(200, 100, 50)', {}, 100).robot.state().rgb).toEqual([color, color, color, color]);
  });

  it.each(['S1', 'S2'])('moves the claw at %s with setServo(), and not at once', (port) => {
    const program = `setServo("${port}", 30)\ndelay(500)\nsetServo("${port}", 90)`;
    const { robot, passMs } = drive(program, { options: { [port]: 'claw' } }, 540);
    const angle = () => robot.state().attachments[0]?.angleDeg ?? NaN;
    expect(angle()).toBeGreaterThan(30);
    expect(angle()).toBeLessThan(60);
    passMs(500);
    expect(angle()).toBe(90);
    expect(robot.state().servos).toEqual({ [port]: 90 });
  });

  it('stops before a wall that it measures, led by getDistance()', () => {
    const program = 'forward()\nwhile getDistance() > 10:\n    delay(10)\nstop()';
    const { xMm, chassis } = drive(program, { prepare: wallAhead(400) }, 5000);
    expect(400 - xMm).toBeGreaterThan(80);
    expect(400 - xMm).toBeLessThan(110);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });
});

describe('MotionKit 2, ultrasonic', () => {
  it.each([
    [3, '3'],
    [42, '42'],
    [150, '150'],
  ])('gives %i cm to a wall as %s', (cm, printed) => {
    expect(drive('print(getDistance())', { prepare: wallAhead(cm * 10) }, 100).lines).toEqual([printed]);
  });

  it('rounds to whole centimetres and gives 2 for what is nearer', () => {
    const measured = (mm: number) => onTheFloor({ prepare: wallAhead(mm) }).readFrom(0x10, 0x28, 2);
    expect([measured(304), measured(306), measured(5)]).toEqual([[0, 30], [0, 31], [0, 2]]); // prettier-ignore
  });

  it.each([
    ['minus-one', [255, 255]],
    ['zero', [0, 0]],
  ])('gives with nothing in range by the option echo = %s the bytes %j', (echo, bytes) => {
    expect(attachedWith({ options: { echo } }).readFrom(0x10, 0x28, 2)).toEqual(bytes);
  });

  it('takes both bytes of a read from one measurement, the next read from the next', () => {
    let isNear = false;
    const distance = () => ({ distanceMm: (isNear = !isNear) ? 2560 : 2550, hitMm: null });
    const { readFrom, passMs } = attachedWith({ distance });
    expect(readFrom(0x10, 0x28, 2)).toEqual([1, 0]);
    passMs(1);
    expect(readFrom(0x10, 0x28, 2)).toEqual([0, 255]);
  });
});

describe('MotionKit 2, line sensors over a black line', () => {
  it.each([
    ['bare floor', () => undefined, '1 1', 0, [230, 230]],
    ['a line below the left one', lineAt(7, 9), '0 1', 1, [100, 230]],
    ['a line below the right one', lineAt(-7, 9), '1 0', 2, [230, 100]],
    ['a line below both', lineAt(0, 24), '0 0', 3, [100, 100]],
  ] as const)('sees %s', (_, prepare, printed, bits, [left, right]) => {
    expect(drive('print(irLeftValue(), irRightValue())', { prepare }, 100).lines).toEqual([printed]);
    const { readFrom, robot } = onTheFloor({ prepare });
    expect([readFrom(0x10, 0x1d, 1), readFrom(0x10, 0x1e, 1), readFrom(0x10, 0x20, 1)]).toEqual([[bits], [left], [right]]); // prettier-ignore
    expect(robot.state().lineSensors.map(({ name, bright }) => [name, bright])).toEqual([
      ['left', (bits & 1) === 0],
      ['right', (bits & 2) === 0],
    ]);
  });
});

describe('MotionKit 2, the rest of the wire', () => {
  it('answers at 0x10 alone, and hears no remote control', () => {
    const { board, readFrom } = onTheFloor();
    expect([...Array(128).keys()].filter((address) => board.i2c.answers(address))).toEqual([0x10]);
    expect(readFrom(0x10, 0x2b, 4)).toEqual([0, 0, 0, 0]);
  });

  it('tells each output that a program sets: the wheels, the lights, the colours one by one, the servo', () => {
    const set: [RobotOutput, string | number][] = [];
    const { board } = attachedWith({ onSet: (output, value) => void set.push([output, value]) });
    const send = (...bytes: number[]) => board.i2c.write(0x10, Uint8Array.from(bytes));
    send(0x02, 1, 51);
    send(0x0c, 1);
    send(0x18, 1, 2, 3);
    send(0x14, 200);
    expect(set).toEqual([
      ['wheel-right', -0.2],
      ['light-right', 1],
      ...[0, 1, 2, 3].map((light) => [`color-${light}`, '1,2,3']),
      ['servo-S1', 200],
    ]);
  });

  it('stands still and is silent once detached', () => {
    const { robot, send, chassis, passMs } = onTheFloor();
    send(0x10, 0, 0, 90, 0, 90);
    robot.detach();
    expect(send(0x10, 0, 0, 90, 0, 90)).toBe(false);
    passMs(1000);
    expect(chassis.pathMm()).toBe(0);
  });
});
