import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import type { LineName } from '../maqueen-plus-frame';
import { maqueenPlusV3Build } from './robot';

/** A Maqueen Plus V3 at (1000, 1000) heading along +x, its board driven by the test. */
function onTheFloor(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV3Build, setup);
  const send = (...bytes: number[]): boolean => floor.send(0x10, ...bytes);
  const readFrom = (register: number, count: number) => floor.readFrom(0x10, register, count);
  return { ...floor, send, readFrom };
}

/** A wall across the way, its front this many mm ahead of the axle. */
const wallAt = (mm: number): FloorSetup => ({
  prepare: (world) =>
    world.addWall({
      fromMm: { x: 1005 + mm, y: 500 },
      toMm: { x: 1005 + mm, y: 1500 },
      thicknessMm: 10,
      heightMm: 250,
    }),
});

const SIDE_MM: Readonly<Record<LineName, number>> = { L2: 36, L1: 12, M: 0, R1: -12, R2: -36 };
const BIT: Readonly<Record<LineName, number>> = { R2: 1, R1: 2, M: 4, L1: 8, L2: 16 };
const PLACE: Readonly<Record<LineName, number>> = { R2: 1, R1: 3, M: 5, L1: 7, L2: 9 };
const NAMES = ['L2', 'L1', 'M', 'R1', 'R2'] as const;

/** Speed of the left wheel in mm/s once it no longer changes. */
function speedAt(byte: number, options = {}): number {
  const { chassis, send, passMs } = onTheFloor({ options });
  send(0, 0, byte, 0, byte);
  passMs(1500);
  return chassis.wheelSpeedMmPerS(0);
}

describe('Maqueen Plus V3, its motors', () => {
  it.each([
    [27, 0],
    [35, 28.5], // sjh5637/myMaqueenPlusV3_extension
    [100, 130], // jhautbois/maqueen-plus-v3-micropython
    [255, 290], // 133 turns a minute of a wheel of 43 mm
  ])('drive at %i of 255 with %f mm/s, within 2 %', (byte, mmPerS) => {
    expect(Math.abs(speedAt(byte) - mmPerS)).toBeLessThanOrEqual(0.02 * mmPerS);
  });

  it('drive twice as fast with the option of 266 turns a minute', () => {
    expect(speedAt(100, { motors: '266' }) / speedAt(100)).toBeCloseTo(2, 2);
  });

  it('take 650 ms for a quarter turn at byte 100, within 20 ms (franc0r/francor-maqueen-plus-microbit)', () => {
    const { chassis, clock, send, passMs } = onTheFloor();
    send(0, 0, 100, 1, 100);
    while (chassis.turnedRad() > -Math.PI / 2) passMs(4);
    expect(Math.abs(clock.nowUs / 1000 - 650)).toBeLessThanOrEqual(20);
  });

  it('turn to the left on the spot with the left motor backward, are read back, and stop when taken off', () => {
    const { chassis, robot, readFrom, send, passMs } = onTheFloor();
    send(0, 1, 100, 0, 100);
    passMs(1000);
    expect(chassis.turnedRad()).toBeGreaterThan(1);
    expect(Math.abs(chassis.pose().xMm - 1000)).toBeLessThan(0.1);
    expect(readFrom(0, 4)).toEqual([1, 100, 0, 100]);
    robot.detach();
    passMs(1000);
    expect([send(0, 0, 50), chassis.wheelSpeedMmPerS(0)]).toEqual([false, 0]);
  });
});

describe('Maqueen Plus V3, its lamps and lights', () => {
  it('has lamps in seven colours in 11 and 12, set one by one or both at once; 8 is off as well', () => {
    const { robot, send } = onTheFloor();
    const lamps = (...bytes: number[]): string[] => {
      send(...bytes);
      return robot.state().lamps.map(String);
    };
    expect([1, 2, 3, 4, 5, 6, 7, 8].map((color) => lamps(11, color)[0])).toEqual(
      ['255,0,0', '0,255,0', '255,255,0', '0,0,255', '255,0,255', '0,255,255', '255,255,255', '0,0,0'], // prettier-ignore
    );
    expect(lamps(12, 1)).toEqual(['0,0,0', '255,0,0']);
    expect(lamps(11, 2, 4)).toEqual(['0,255,0', '0,0,255']);
  });

  it('has four colour lights at P1, beside a servo: neither hears the other', () => {
    const { board, robot } = onTheFloor();
    board.wire('P1').stream(Uint8Array.of(2, 1, 3, 5, 4, 6, 8, 7, 9, 11, 10, 12));
    expect(robot.state().servos).toEqual({});
    board
      .wire('P1')
      .connect('test')
      .drivePwm({ periodUs: 20_000, dutyFraction: 1500 / 20_000 });
    const { rgb, servos } = robot.state();
    expect(rgb.map(String)).toEqual(['1,2,3', '4,5,6', '7,8,9', '10,11,12']);
    expect(servos).toEqual({ P1: 90 });
  });
});

describe('Maqueen Plus V3, its line sensors', () => {
  it('read 3800 on the bare floor, low byte first, bits 0', () => {
    const { readFrom } = onTheFloor();
    const bright = [3800 & 255, 3800 >> 8];
    expect(readFrom(29, 11)).toEqual([0, ...bright, ...bright, ...bright, ...bright, ...bright]);
  });

  it.each(NAMES)('a line of 18 mm under %s darkens that one alone: its bit, and 2700 as its value', (name) => {
    const points = [800, 2000].map((x) => ({ x, y: 1000 + SIDE_MM[name] }));
    const line = { pointsMm: points, widthMm: 18, reflectance: 0 };
    const { readFrom } = onTheFloor({ prepare: (world) => world.addStroke(line) });
    const bytes = readFrom(29, 11);
    expect(bytes[0]).toBe(BIT[name]);
    const values = Object.fromEntries(NAMES.map((one) => [one, bytes[PLACE[one]]! + 256 * bytes[PLACE[one] + 1]!]));
    expect(values).toEqual({ L2: 3800, L1: 3800, M: 3800, R1: 3800, R2: 3800, [name]: 2700 });
  });
});

describe('Maqueen Plus V3, its lidar', () => {
  /** Asks for one cell. */
  function cell(floor: ReturnType<typeof onTheFloor>, x: number, y: number, address = 0x33): number {
    floor.board.i2c.write(address, Uint8Array.of(0x55, 0, 3, 3, x, y));
    floor.passMs(9);
    const bytes = floor.board.i2c.read(address, 6).bytes;
    return bytes[4]! + 256 * bytes[5]!;
  }

  it('measures from its lens at the front edge, 77 mm ahead of the axle', () => {
    const floor = onTheFloor(wallAt(377));
    floor.passMs(3000);
    expect(cell(floor, 3, 3)).toBe(300);
    expect(cell(floor, 7, 7)).toBe(211); // the floor
  });

  it('shows its picture at all times, and which cells the program has read', () => {
    const floor = onTheFloor(wallAt(377));
    const { lidar } = floor.robot.state();
    expect(lidar).toMatchObject({ size: 8, headingRad: 0, fromMm: { x: 1077, y: 1000 } });
    expect([lidar?.depthMm[3 * 8], lidar?.depthMm[7 * 8], lidar?.openingRad]).toEqual([300, 211, Math.PI / 3]);
    expect([lidar?.floor[3 * 8], lidar?.floor[7 * 8], lidar?.asked.includes(true)]).toEqual([false, true, false]);
    floor.passMs(3000);
    cell(floor, 3, 4);
    expect(floor.robot.state().lidar?.asked.indexOf(true)).toBe(4 * 8 + 3);
  });

  it('looks from twice as far ahead, but not higher, on a robot of twice the size', () => {
    const { lidar } = onTheFloor({ ...wallAt(454), scale: 2 }).robot.state();
    expect([lidar?.depthMm[3 * 8], lidar?.depthMm[7 * 8]]).toEqual([300, 211]);
  });

  it('is where the options say: 4 × 4, at another address, transposed, 0 for nothing, or nowhere', () => {
    const options = { lidar: '4x4', lidarAddress: '0x31', lidarOrder: 'transposed', lidarEmpty: '0' };
    const floor = onTheFloor({ options });
    floor.passMs(3000);
    expect([0x30, 0x31, 0x32, 0x33].filter((address) => floor.board.i2c.answers(address))).toEqual([0x31]);
    expect(floor.robot.state().lidar?.size).toBe(4);
    expect(cell(floor, 3, 0, 0x31)).toBe(251); // row 3, which looks at the floor
    expect(cell(floor, 0, 3, 0x31)).toBe(0);
    const without = onTheFloor({ options: { lidar: 'none' } });
    without.passMs(3000);
    expect([without.robot.state().lidar, without.board.i2c.answers(0x33)]).toEqual([null, false]);
  });
});

describe('Maqueen Plus V3, its ultrasonic sensor', () => {
  /** Times in µs at which the echo changes after a trigger. */
  function edges(setup: FloorSetup) {
    const { board, clock, robot } = onTheFloor(setup);
    const trigger = board.wire('P13').connect('test');
    const seen: number[] = [];
    board.wire('P14').onLevel(() => seen.push(clock.nowUs));
    trigger.drive(1);
    trigger.drive(0);
    clock.advanceTo(60_000);
    return { seen, sonar: robot.state().ultrasonic };
  }

  it('is not in the box: P14 stays still', () => {
    expect(edges(wallAt(376))).toEqual({ seen: [], sonar: null });
  });

  it('measures 30 cm to a wall 376 mm ahead of the axle once it is plugged in', () => {
    const { seen, sonar } = edges({ ...wallAt(376), options: { ultrasonic: 'yes' } });
    expect(seen).toEqual([450, 450 + 1746]);
    expect(sonar?.distanceMm).toBeCloseTo(300, 6);
  });
});
