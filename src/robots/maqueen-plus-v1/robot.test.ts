import { describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import type { World } from '#world/world';
import { putOnFloor } from '../testing/floor';
import { CONTROLLER_ADDRESS, LINE_NAMES, VERSION_TEXT } from './controller';
import { maqueenPlusV1Build } from './robot';

const OFF: Rgb = [0, 0, 0];
const RED: Rgb = [255, 0, 0];

/** A robot at (1000, 1000) heading along +x; bytes go to its controller. */
function onTheFloor(prepare: (world: World) => void = () => undefined, options = {}) {
  const floor = putOnFloor(maqueenPlusV1Build, { prepare, options });
  return {
    ...floor,
    send: (...bytes: readonly number[]): boolean => floor.send(CONTROLLER_ADDRESS, ...bytes),
    read: (register: number, count: number) => floor.readFrom(CONTROLLER_ADDRESS, register, count),
  };
}

/** A black line along y through a place of the robot's frame. */
const lineAcross = (x: number, fromY = -200, toY = 200) => ({
  pointsMm: [
    { x: 1000 + x, y: 1000 + fromY },
    { x: 1000 + x, y: 1000 + toY },
  ],
  widthMm: 16,
  reflectance: 0,
});

describe('Maqueen Plus V1: motors (DFRobot pxt-DFRobot-Maqueenplus, mototRun)', () => {
  it('drives forward for [0x00, 1, 50, 1, 50]: direction 1', () => {
    const { send, chassis, robot, passMs } = onTheFloor();
    send(0x00, 1, 50, 1, 50);
    expect(robot.state().duty).toEqual({ left: 50 / 255, right: 50 / 255 });
    passMs(1000);
    expect(chassis.pose().xMm).toBeGreaterThan(1100);
  });

  it('drives backward for [0x00, 2, 50, 2, 50]: direction 2', () => {
    const { send, chassis, passMs } = onTheFloor();
    send(0x00, 2, 50, 2, 50);
    passMs(1000);
    expect(chassis.pose().xMm).toBeLessThan(900);
  });

  it.each([0, 3, 255])('stands for direction %i, whatever the speed', (direction) => {
    const { send, chassis, passMs } = onTheFloor();
    send(0x00, direction, 200, direction, 200);
    passMs(500);
    expect(chassis.pathMm()).toBe(0);
  });

  it('turns to the right for [0x00, 1, 60] alone: only the left motor', () => {
    const { send, chassis, passMs } = onTheFloor();
    send(0x00, 1, 60);
    passMs(500);
    expect(chassis.turnedRad()).toBeLessThan(-0.3);
  });

  it('gives directions and speeds back: [1, 70, 2, 30]', () => {
    const { send, read } = onTheFloor();
    send(0x00, 1, 70);
    send(0x02, 2, 30);
    expect(read(0x00, 4)).toEqual([1, 70, 2, 30]);
  });
});

describe('Maqueen Plus V1: pulses of the wheels', () => {
  it('counts 80 pulses per turn of a wheel, high byte first', () => {
    const { send, read, chassis, passMs } = onTheFloor();
    send(0x00, 1, 100, 1, 60);
    passMs(4000);
    const [leftHigh = 0, leftLow = 0, rightHigh = 0, rightLow = 0] = read(0x04, 4);
    expect(leftHigh).toBeGreaterThan(0);
    expect(256 * leftHigh + leftLow).toBe(Math.floor((chassis.wheelTurnRad(0) / (2 * Math.PI)) * 80 + 1e-9));
    expect(256 * rightHigh + rightLow).toBe(Math.floor((chassis.wheelTurnRad(1) / (2 * Math.PI)) * 80 + 1e-9));
  });

  it('counts backward turns too', () => {
    const { send, read, passMs } = onTheFloor();
    send(0x00, 2, 100, 2, 100);
    passMs(500);
    expect(read(0x05, 1)[0]).toBeGreaterThan(20);
  });

  it('sets one wheel back with [0x06, 0] and both with [0x04, 0, 0, 0] (DFRobot, clearDistance)', () => {
    const { send, read, passMs } = onTheFloor();
    const driveABit = (): void => {
      send(0x00, 1, 100, 1, 100);
      passMs(500);
      send(0x00, 0, 0, 0, 0);
      passMs(500);
    };
    driveABit();
    const [, left] = read(0x04, 4);
    send(0x06, 0);
    expect(read(0x04, 4)).toEqual([0, left, 0, 0]);
    driveABit();
    send(0x04, 0, 0, 0);
    expect(read(0x04, 4)).toEqual([0, 0, 0, 0]);
  });
});

describe('Maqueen Plus V1: speed control', () => {
  const speedAfter = (ms: number, control: number, byte: number): number => {
    const { send, chassis, passMs } = onTheFloor();
    send(0x0a, control);
    send(0x00, 1, byte, 1, byte);
    passMs(ms);
    return chassis.wheelSpeedMmPerS(0);
  };

  it('keeps 2.6 mm/s per byte: 80 mm/s at 31, 153 mm/s at 59, where the motor alone would be faster', () => {
    expect(speedAfter(1000, 1, 31)).toBeCloseTo(80.6, 0);
    expect(speedAfter(1000, 1, 59)).toBeCloseTo(153.4, 0);
    expect(speedAfter(1000, 0, 59)).toBeGreaterThan(200);
  });

  it('stops at once with direction 0, and lets go when it is switched off', () => {
    const { send, read, robot, passMs } = onTheFloor();
    send(0x0a, 1);
    expect(read(0x0a, 1)).toEqual([1]);
    send(0x00, 1, 40, 1, 40);
    passMs(1000);
    send(0x0a, 0);
    expect(robot.state().duty).toEqual({ left: 40 / 255, right: 40 / 255 });
    send(0x0a, 1);
    send(0x00, 0, 0, 0, 0);
    passMs(8);
    expect(robot.state().duty).toEqual({ left: 0, right: 0 });
  });

  it('acts from the moment of its writes: wherever they fall, a turn comes out the same to 0.1°', () => {
    const turns = [0, 700, 1500, 2600, 3700].map((us) => {
      const { send, chassis, passMs } = onTheFloor();
      send(0x0a, 1);
      passMs(4 + us / 1000);
      send(0x00, 1, 40);
      send(0x02, 2, 40);
      passMs(800);
      send(0x00, 0, 0);
      send(0x02, 0, 0);
      passMs(400);
      return (chassis.turnedRad() * 180) / Math.PI;
    });
    expect(Math.abs(turns[0] ?? 0)).toBeGreaterThan(90);
    expect(Math.max(...turns) - Math.min(...turns)).toBeLessThan(0.1);
  });
});

describe('Maqueen Plus V1: lights and servos', () => {
  it.each<[number, Rgb]>([
    [0, OFF],
    [1, RED],
    [2, [0, 255, 0]],
    [3, [255, 255, 0]],
    [4, [0, 0, 255]],
    [5, [255, 0, 255]],
    [6, [0, 255, 255]],
    [7, [255, 255, 255]],
    [8, OFF],
  ])('shows colour %i on both lights as %j for [0x0B, n, n] (DFRobot, Color)', (number, color) => {
    const { send, robot } = onTheFloor();
    send(0x0b, 1, 1);
    send(0x0b, number, number);
    expect(robot.state().rgb).toEqual([color, color]);
  });

  it('lights the right one alone for [0x0C, 1]', () => {
    const { send, robot } = onTheFloor();
    send(0x0c, 1);
    expect(robot.state().rgb).toEqual([OFF, RED]);
  });

  it('turns servos S1, S2 and S3 by 0x14, 0x15, 0x16', () => {
    const { send, read, robot } = onTheFloor();
    expect(robot.state().servos).toEqual({});
    send(0x15, 100);
    expect(robot.state().servos).toEqual({ S2: 100 });
    send(0x14, 10, 20, 30);
    expect(robot.state().servos).toEqual({ S1: 10, S2: 20, S3: 30 });
    expect(read(0x14, 3)).toEqual([10, 20, 30]);
  });

  it('moves the claw at port S3: it is open at 30° and closed at 90° after a second', () => {
    const { send, robot, passMs } = onTheFloor(undefined, { S3: 'claw' });
    const claw = () => robot.state().attachments.find(({ port }) => port === 'S3');
    send(0x16, 30);
    passMs(1000);
    const open = claw()?.turnRad;
    send(0x16, 90);
    passMs(1000);
    expect(claw()?.angleDeg).toBe(90);
    expect(claw()?.turnRad).not.toEqual(open);
  });
});

describe('Maqueen Plus V1: line sensors', () => {
  it('gives 0 for all on the bare floor, 3500 each, high byte first', () => {
    const { read } = onTheFloor();
    expect(read(0x1d, 1)).toEqual([0]);
    expect(read(0x1e, 12)).toEqual(Array(6).fill([0x0d, 0xac]).flat());
  });

  it('has the four front sensors on a line across, 58 mm ahead: bits 1 to 4, values 1000', () => {
    const { read } = onTheFloor((world) => world.addStroke(lineAcross(58)));
    expect(read(0x1d, 1)).toEqual([0b011110]);
    expect(read(0x20, 2)).toEqual([0x03, 0xe8]);
  });

  it.each([
    ['L3', 38, 45, 0b000001],
    ['L2', 58, 15, 0b000010],
    ['R3', 38, -45, 0b100000],
  ])('has %s alone on a spot at (%i, %i)', (_name, x, y, bits) => {
    const { read } = onTheFloor((world) => world.addStroke({ ...lineAcross(x, y - 0.5, y + 0.5), widthMm: 8 }));
    expect(read(0x1d, 1)).toEqual([bits]);
  });

  it('names them in its state from left to right', () => {
    expect(
      onTheFloor()
        .robot.state()
        .lineSensors.map(({ name }) => name),
    ).toEqual([...LINE_NAMES]);
  });
});

describe('Maqueen Plus V1: the rest', () => {
  it('tells the version 1.4 that lawther/maqueenplus asks for', () => {
    const { read } = onTheFloor();
    expect(read(0x32, 1)).toEqual([VERSION_TEXT.length]);
    expect(String.fromCharCode(...read(0x33, VERSION_TEXT.length))).toBe('MBT0021-EN-1.4');
  });

  it('measures 30 cm to a wall: trigger at P1, echo of 1746 µs at P2', () => {
    const wall = { fromMm: { x: 1379, y: 800 }, toMm: { x: 1379, y: 1200 }, thicknessMm: 10 };
    const { board, clock } = onTheFloor((world) => world.addWall(wall));
    const trigger = board.wire('P1').connect('test');
    const edges: number[] = [];
    board.wire('P2').onLevel(() => edges.push(clock.nowUs));
    trigger.drive(1);
    trigger.drive(0);
    clock.advanceTo(30_000);
    expect(edges.map((us) => us - (edges[0] ?? 0))).toEqual([0, 1746]);
  });

  it('stops when it is taken off the board, and nobody answers any more', () => {
    const { send, chassis, robot, passMs } = onTheFloor();
    send(0x0a, 1);
    send(0x00, 1, 100, 1, 100);
    passMs(500);
    robot.detach();
    expect(send(0x00, 1, 100, 1, 100)).toBe(false);
    passMs(1000);
    expect(chassis.wheelSpeedMmPerS(0)).toBeCloseTo(0, 6);
  });
});

describe('Maqueen Plus V1: infrared receiver', () => {
  it('holds P16 high, as no remote control is heard, also against the pull-down of read_digital()', () => {
    const { board } = onTheFloor();
    board.wire('P16').connect('test').pull('down');
    expect(board.wire('P16').level).toBe(1);
  });
});
