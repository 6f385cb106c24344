import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { VERSION } from './controller';
import { maqueenLiteBuild } from './robot';

/** A Maqueen Lite at (1000, 1000) heading along +x in an arena of 3 m × 3 m, its board driven by the test. */
function onTheFloor(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenLiteBuild, setup);
  const send = (...bytes: number[]): boolean => floor.send(0x10, ...bytes);
  return { ...floor, send };
}

describe('Maqueen Lite on the floor', () => {
  it('turns on the spot about the middle of its axle: less than 0.1 mm off after a full turn', () => {
    const { chassis, send, passMs } = onTheFloor();
    send(0, 1, 39, 0, 39);
    passMs(1500);
    send(0, 0, 0, 0, 0);
    passMs(500);
    expect(chassis.turnedRad()).toBeGreaterThan(2 * Math.PI);
    expect(Math.abs(chassis.pose().xMm - 1000)).toBeLessThan(0.1);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(0.1);
  });

  it('stops within 2 cm from speed 50', () => {
    const { chassis, send, passMs } = onTheFloor();
    send(0, 0, 39, 0, 39);
    passMs(2000);
    const path = chassis.pathMm();
    send(0, 0, 0, 0, 0);
    passMs(1000);
    expect(chassis.pathMm() - path).toBeLessThan(20);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });

  it('does not move for a direction without a speed', () => {
    const { chassis, send, passMs } = onTheFloor();
    send(0x00, 1);
    passMs(500);
    expect(chassis.pathMm()).toBe(0);
  });
});

describe('Maqueen Lite: what is on which pin', () => {
  it('has its red lights at P8 (left) and P12 (right)', () => {
    const { board, robot } = onTheFloor();
    board.wire('P8').connect('test').drive(1);
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
    board.wire('P12').connect('test').drive(1);
    expect(robot.state().leds).toEqual({ left: 1, right: 1 });
  });

  it('has four colour lights at P15 that take green, red, blue', () => {
    const { board, robot } = onTheFloor();
    board.wire('P15').stream(Uint8Array.of(2, 1, 3, 5, 4, 6, 8, 7, 9, 11, 10, 12));
    expect(robot.state().rgb).toEqual([
      [1, 2, 3],
      [4, 5, 6],
      [7, 8, 9],
      [10, 11, 12],
    ]);
  });

  it('reads 1 at P13 and P14 on the bare floor, 0 at P13 once its left sensor is over a black line', () => {
    const line = {
      pointsMm: [
        { x: 900, y: 1010 },
        { x: 2000, y: 1010 },
      ],
      widthMm: 14,
      reflectance: 0,
    };
    const free = onTheFloor();
    expect([free.board.wire('P13').level, free.board.wire('P14').level]).toEqual([1, 1]);
    const over = onTheFloor({ prepare: (world) => world.addStroke(line) });
    expect([over.board.wire('P13').level, over.board.wire('P14').level]).toEqual([0, 1]);
    expect(over.robot.state().lineSensors.map(({ bright }) => bright)).toEqual([false, true]);
  });

  it('notices a line while driving across it, 34 mm ahead of the axle', () => {
    const across = {
      pointsMm: [
        { x: 1200, y: 800 },
        { x: 1200, y: 1200 },
      ],
      widthMm: 20,
      reflectance: 0,
    };
    const { board, chassis, clock, send } = onTheFloor({ prepare: (world) => world.addStroke(across) });
    send(0, 0, 39, 0, 39);
    let seenAtMm = 0;
    board.wire('P13').onLevel((level) => {
      if (level === 0) seenAtMm = chassis.pose().xMm;
    });
    clock.advanceTo(3_000_000);
    expect(Math.abs(seenAtMm + 34 - 1190)).toBeLessThan(1.5);
  });

  it('measures 30 cm to a wall 355 mm ahead of the axle: trigger at P1, echo of 1746 µs at P2', () => {
    const wall = { fromMm: { x: 1360, y: 800 }, toMm: { x: 1360, y: 1200 }, thicknessMm: 10 };
    const { board, clock, robot } = onTheFloor({ prepare: (world) => world.addWall(wall) });
    const trigger = board.wire('P1').connect('test');
    const edges: number[] = [];
    board.wire('P2').onLevel(() => edges.push(clock.nowUs));
    trigger.drive(1);
    trigger.drive(0);
    clock.advanceTo(30_000);
    expect(edges).toEqual([450, 450 + 1746]);
    expect(robot.state().ultrasonic?.distanceMm).toBeCloseTo(300, 6);
  });

  it('sees the wall around the arena, 1945 mm ahead', () => {
    const { robot } = onTheFloor();
    expect(robot.state().ultrasonic?.distanceMm).toBeCloseTo(1945, 6);
  });

  it('shows 20 mm, the least that the sensor can tell, in front of a wall 5 mm ahead', () => {
    const wall = { fromMm: { x: 1065, y: 800 }, toMm: { x: 1065, y: 1200 }, thicknessMm: 10 };
    const { robot } = onTheFloor({ prepare: (world) => world.addWall(wall) });
    expect(robot.state().ultrasonic?.distanceMm).toBe(20);
  });

  it('keeps the angles of servos S1 and S2, at most 180°', () => {
    const { robot, send } = onTheFloor();
    expect(robot.state().servos).toEqual({});
    send(0x14, 90);
    send(0x15, 200);
    expect(robot.state().servos).toEqual({ S1: 90, S2: 180 });
  });

  it('lights its red lights by PWM too: write_analog(200) at P8', () => {
    const { board, robot } = onTheFloor();
    board
      .wire('P8')
      .connect('test')
      .drivePwm({ periodUs: 20_000, dutyFraction: 200 / 1024 });
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
  });

  it('tells its version: the length at 0x32, the text from 0x33', () => {
    const { readFrom } = onTheFloor();
    const [length = 0] = readFrom(0x10, 0x32, 1);
    expect(String.fromCharCode(...readFrom(0x10, 0x33, length))).toBe(VERSION);
  });

  it('hears no remote control: its receiver at P16 is high', () => {
    expect(onTheFloor().board.wire('P16').level).toBe(1);
  });

  it('drives nothing on P0, the buzzer', () => {
    const { board } = onTheFloor();
    expect(board.wire('P0').level).toBe(0);
  });

  it('answers at I2C address 0x10 alone, and no more once detached', () => {
    const { board, robot, chassis, send, passMs } = onTheFloor();
    expect([...Array(128).keys()].filter((address) => board.i2c.answers(address))).toEqual([0x10]);
    send(0, 0, 39, 0, 39);
    robot.detach();
    expect(send(0, 0, 39, 0, 39)).toBe(false);
    passMs(1000);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
    expect(board.wire('P13').level).toBe(0);
  });
});
