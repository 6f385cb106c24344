import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import type { LineName } from '../maqueen-plus-frame';
import { maqueenPlusV2Build } from './robot';

/** A Maqueen Plus V2 at (1000, 1000) heading along +x, its board driven by the test. */
function onTheFloor(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV2Build, setup);
  const send = (...bytes: number[]): boolean => floor.send(0x10, ...bytes);
  const readFrom = (register: number, count: number) => floor.readFrom(0x10, register, count);
  return { ...floor, send, readFrom };
}

/** A black line along the robot's path, this many mm to its left. */
const lineAlong = (leftMm: number, widthMm = 20): FloorSetup => ({
  prepare: (world) =>
    world.addStroke({
      pointsMm: [
        { x: 800, y: 1000 + leftMm },
        { x: 2000, y: 1000 + leftMm },
      ],
      widthMm,
      reflectance: 0,
    }),
});

const SIDE_MM: Readonly<Record<LineName, number>> = { L2: 36, L1: 12, M: 0, R1: -12, R2: -36 };
const BIT: Readonly<Record<LineName, number>> = { R2: 1, R1: 2, M: 4, L1: 8, L2: 16 };
const NAMES = ['L2', 'L1', 'M', 'R1', 'R2'] as const;

describe('Maqueen Plus V2 on the floor', () => {
  it('drives straight for [0x00, 0, 50, 0, 50] and reads its motors back', () => {
    const { chassis, robot, send, passMs, readFrom } = onTheFloor();
    send(0, 0, 50, 0, 50);
    passMs(2000);
    expect(chassis.pose().xMm).toBeGreaterThan(1150);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(0.1);
    expect(robot.state().duty).toEqual({ left: 50 / 255, right: 50 / 255 });
    expect(readFrom(0, 4)).toEqual([0, 50, 0, 50]);
  });

  it('turns to the left on the spot with the left motor backward', () => {
    const { chassis, send, passMs } = onTheFloor();
    send(0, 1, 50, 0, 50);
    passMs(1000);
    expect(chassis.turnedRad()).toBeGreaterThan(1);
    expect(Math.abs(chassis.pose().xMm - 1000)).toBeLessThan(0.1);
  });

  it('drives back with direction 1 and stands with 2, as owners saw it with the driver of a Plus V1', () => {
    const { chassis, send, passMs } = onTheFloor();
    send(0, 2, 60, 2, 60);
    passMs(1000);
    expect(chassis.pathMm()).toBe(0);
    send(0, 1, 60, 1, 60);
    passMs(1000);
    expect(chassis.pose().xMm).toBeLessThan(950);
  });

  it('answers at 0x10 alone, and no more once detached; its motors stop then', () => {
    const { board, chassis, robot, send, passMs } = onTheFloor();
    expect([...Array(128).keys()].filter((address) => board.i2c.answers(address))).toEqual([0x10]);
    send(0, 0, 50, 0, 50);
    robot.detach();
    expect(send(0, 0, 50, 0, 50)).toBe(false);
    passMs(1000);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });

  it('tells the version that was chosen, 2.1 by itself', () => {
    const text = (setup: FloorSetup) => String.fromCharCode(...onTheFloor(setup).readFrom(0x33, 14));
    expect(text({})).toBe('MBT0021-EN-2.1');
    expect(text({ options: { version: '2.0' } })).toBe('MBT0021-EN-2.0');
  });

  it('has its red lights in 0x0B and 0x0C', () => {
    const { robot, send } = onTheFloor();
    send(0x0b, 1, 0);
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
    send(0x0c, 1);
    expect(robot.state().leds).toEqual({ left: 1, right: 1 });
  });

  it('has four colour lights at P15 that take green, red, blue', () => {
    const { board, robot } = onTheFloor();
    board.wire('P15').stream(Uint8Array.of(2, 1, 3, 5, 4, 6, 8, 7, 9, 11, 10, 12));
    expect(robot.state().rgb.map(String)).toEqual(['1,2,3', '4,5,6', '7,8,9', '10,11,12']);
  });
});

describe('Maqueen Plus V2, its line sensors', () => {
  it('see light ground everywhere on the bare floor: bits 0, values 230', () => {
    const { readFrom, robot } = onTheFloor();
    expect(readFrom(0x1d, 11)).toEqual([0, 230, 0, 230, 0, 230, 0, 230, 0, 230, 0]);
    expect(robot.state().lineSensors.map(({ name, bright }) => [name, bright])).toEqual(
      NAMES.map((name) => [name, true]),
    );
  });

  it.each(NAMES)('a line of 20 mm under %s darkens that one alone: its bit, and 100 as its value', (name) => {
    const { readFrom, robot } = onTheFloor(lineAlong(SIDE_MM[name]));
    expect(readFrom(0x1d, 1)).toEqual([BIT[name]]);
    const states = robot.state().lineSensors;
    expect(states.filter(({ bright }) => !bright).map((sensor) => sensor.name)).toEqual([name]);
    expect(states.find((sensor) => sensor.name === name)?.reading).toBe(100);
  });

  it('measure in between where a sensor is half over the edge of a line', () => {
    const { readFrom } = onTheFloor(lineAlong(20, 40)); // its edge runs through the middle sensor
    const [value = 0] = readFrom(0x22, 1);
    expect(Math.abs(value - 165)).toBeLessThanOrEqual(2);
  });

  it('see a line across the way first in the front row, then 10 mm later at the sides', () => {
    const across = { pointsMm: [1100, 900].map((y) => ({ x: 1150, y })), widthMm: 20, reflectance: 0 };
    const { chassis, passMs, readFrom, send } = onTheFloor({ prepare: (world) => world.addStroke(across) });
    send(0, 0, 50, 0, 50);
    const seenAt = new Map<number, number>();
    for (let ms = 0; ms < 2000; ms += 4) {
      passMs(4);
      const [bits = 0] = readFrom(0x1d, 1);
      for (const bit of Object.values(BIT)) if (bits & bit && !seenAt.has(bit)) seenAt.set(bit, chassis.pose().xMm);
    }
    for (const name of ['L1', 'M', 'R1'] as const)
      expect(Math.abs(seenAt.get(BIT[name])! + 56 - 1140)).toBeLessThan(1.5);
    for (const name of ['L2', 'R2'] as const) expect(Math.abs(seenAt.get(BIT[name])! + 46 - 1140)).toBeLessThan(1.5);
  });

  it('report low values on light ground with the option light-low: 70, on black 240', () => {
    const { readFrom } = onTheFloor({ ...lineAlong(0, 16), options: { analogPolarity: 'light-low' } });
    expect(readFrom(0x1d, 11)).toEqual([4, 70, 0, 70, 0, 240, 0, 70, 0, 70, 0]);
  });

  it('sit twice as far apart on a robot of twice the size', () => {
    const { readFrom } = onTheFloor({ ...lineAlong(24, 40), scale: 2 });
    expect(readFrom(0x1d, 1)).toEqual([BIT.L1]);
  });

  it('report the values from left to right with the option L2-first', () => {
    const { readFrom } = onTheFloor({ ...lineAlong(36), options: { analogOrder: 'L2-first' } });
    expect(readFrom(0x1d, 11)).toEqual([16, 100, 0, 230, 0, 230, 0, 230, 0, 230, 0]);
  });
});

describe('Maqueen Plus V2, its ultrasonic sensor', () => {
  /** Times in µs at which the echo changes after a trigger. */
  function edges(setup: FloorSetup): { readonly edges: number[]; readonly distanceMm: number | null | undefined } {
    const { board, clock, robot } = onTheFloor(setup);
    const trigger = board.wire('P13').connect('test');
    const seen: number[] = [];
    board.wire('P14').onLevel(() => seen.push(clock.nowUs));
    trigger.drive(1);
    trigger.drive(0);
    clock.advanceTo(60_000);
    return { edges: seen, distanceMm: robot.state().ultrasonic?.distanceMm };
  }
  const wallAt = (x: number): FloorSetup => ({
    prepare: (world) => world.addWall({ fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 }),
  });

  it('measures 30 cm to a wall 376 mm ahead of the axle: trigger at P13, echo of 1746 µs at P14', () => {
    const { edges: seen, distanceMm } = edges(wallAt(1381));
    expect(seen).toEqual([450, 450 + 1746]);
    expect(distanceMm).toBeCloseTo(300, 6);
  });
});

describe('Maqueen Plus V2, its servos', () => {
  it.each(['P0', 'P1', 'P2'])('%s follows pulses of 0.5, 1.5 and 2.5 ms every 20 ms: 0, 90 and 180 degrees', (port) => {
    const { board, robot } = onTheFloor();
    const pin = board.wire(port).connect('test');
    const angles = [500, 1500, 2500].map((pulseUs) => {
      pin.drivePwm({ periodUs: 20_000, dutyFraction: pulseUs / 20_000 });
      return robot.state().servos[port];
    });
    expect(angles).toEqual([0, 90, 180]);
  });

  it('leaves the servo on P0 alone while the buzzer plays: 131 Hz to 880 Hz', () => {
    const { board, robot } = onTheFloor();
    const pin = board.wire('P0').connect('test');
    for (const pitch of [131, 262, 440, 880]) pin.drivePwm({ periodUs: 1_000_000 / pitch, dutyFraction: 0.5 });
    expect(robot.state().servos).toEqual({});
  });

  it('does not listen to the servo registers of the V1', () => {
    const { robot, send } = onTheFloor();
    send(0x14, 90, 90, 90);
    expect(robot.state().servos).toEqual({});
  });
});
