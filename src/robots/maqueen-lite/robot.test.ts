import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import { createRng } from '#core/rng';
import { createWorld, STEP_US, type World } from '#world/world';
import { maqueenLite } from './robot';

/** A Maqueen Lite at (1000, 1000) heading along +x in an arena of 3 m × 3 m, its board driven by the test. */
function onTheFloor(prepare: (world: World) => void = () => undefined) {
  const clock = new Clock();
  const world = createWorld({ widthMm: 3000, heightMm: 3000 });
  prepare(world);
  clock.every(STEP_US, () => world.step());
  const board = new Board(microbitV2, clock);
  const chassis = world.addChassis(maqueenLite.body, { xMm: 1000, yMm: 1000, headingRad: 0 });
  const robot = maqueenLite.attach({
    clock,
    board,
    chassis,
    ground: (spot, radiusMm) => world.reflectanceAt(chassis.toWorld(spot), radiusMm),
    distance: (from, headingRad, cone) =>
      world.distanceCone(chassis.toWorld(from), chassis.pose().headingRad + headingRad, cone, chassis),
    rng: createRng(1),
    reality: 0,
    scale: 1,
  });
  const send = (...bytes: number[]): boolean => board.i2c.write(0x10, Uint8Array.from(bytes)).acknowledged;
  const passMs = (ms: number): void => clock.advanceTo(clock.nowUs + ms * 1000);
  return { clock, world, board, chassis, robot, send, passMs };
}

/** Power bytes [inner, outer] for a circle, in the words of Tiger-Jython mbrobot.py, arc scaling 0. */
function arcBytes(radiusM: number, percent: number): readonly [number, number] {
  const cm = Math.trunc(radiusM * 100);
  const outer = percent <= Math.max(cm + 20, 40) ? Math.min(Math.max(cm + 40, 40), 100) : percent;
  const inner = cm < 4 ? 0 : ((10 * cm - 35) / (cm * 10.6 + 90 + Math.floor((100 - outer) / 2))) * outer;
  return [powerByte(Math.trunc(inner)), powerByte(outer)];
}

function powerByte(percent: number): number {
  if (percent <= 0) return 0;
  if (percent <= 33) return Math.trunc(0.4 * percent + 11);
  if (percent <= 63) return Math.trunc(0.89 * percent - 5);
  return percent < 100 ? Math.trunc(1.0561 ** percent + 20) : 255;
}

/** Radius in m of the circle the robot drives once its speed is steady. */
function drivenRadiusM(radiusM: number, percent: number): number {
  const { chassis, send, passMs } = onTheFloor();
  const [inner, outer] = arcBytes(radiusM, percent);
  send(0, 0, inner, 0, outer);
  passMs(2000);
  const path = chassis.pathMm();
  const turned = chassis.turnedRad();
  passMs(2000);
  return (chassis.pathMm() - path) / (chassis.turnedRad() - turned) / 1000;
}

describe('Maqueen Lite on the floor', () => {
  it('uses the constants of the fitted motor law', () => {
    const page = readFileSync('docs/hardware/maqueen-lite-motor-law.md', 'utf8');
    const { v0MmPerS, coulomb, viscous, yawResistance } = maqueenLite.body.drive;
    for (const row of [
      `v0 | ${v0MmPerS} mm/s`,
      `coulomb | ${coulomb}`,
      `viscous | ${viscous}`,
      `yawResistance | ${yawResistance}`,
    ]) {
      expect(page).toContain(`| ${row} |`);
    }
  });

  it.each([0.15, 0.2, 0.25, 0.3, 0.35, 0.4])(
    'drives leftArc(%f) at speed 50 within 15 percent of that radius',
    (radiusM) => {
      expect(Math.abs(drivenRadiusM(radiusM, 50) / radiusM - 1)).toBeLessThan(0.15);
    },
  );

  it.each([30, 70, 100])('drives leftArc(0.2) at speed %i within 25 percent of 20 cm', (percent) => {
    expect(Math.abs(drivenRadiusM(0.2, percent) / 0.2 - 1)).toBeLessThan(0.25);
  });

  it.each([
    [20, 109],
    [50, 222],
    [255, 352],
  ])('drives straight at power byte %i with %i mm/s, as the fit says', (byte, speedMmPerS) => {
    const { chassis, send, passMs } = onTheFloor();
    send(0, 0, byte, 0, byte);
    passMs(2500);
    expect(Math.abs(chassis.wheelSpeedMmPerS(0) - speedMmPerS)).toBeLessThan(2);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(0.01);
  });

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
    const over = onTheFloor((world) => world.addStroke(line));
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
    const { board, chassis, clock, send } = onTheFloor((world) => world.addStroke(across));
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
    const { board, clock, robot } = onTheFloor((world) => world.addWall(wall));
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

  it('keeps the angles of servos S1 and S2, at most 180°', () => {
    const { robot, send } = onTheFloor();
    expect(robot.state().servos).toEqual({});
    send(0x14, 90);
    send(0x15, 200);
    expect(robot.state().servos).toEqual({ S1: 90, S2: 180 });
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
