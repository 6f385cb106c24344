import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenLiteBuild } from './robot';

/** A robot to which a test talks as programs for the Maqueen V5 do. */
function v5(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenLiteBuild, setup);
  const send = (...bytes: number[]): boolean => floor.send(0x10, ...bytes);
  const word = (register: number): number => {
    const [high = 0, low = 0] = floor.readFrom(0x10, register, 2);
    return high * 256 + low;
  };
  return { ...floor, send, word, lineBits: () => floor.readFrom(0x10, 0x1d, 1)[0] };
}

/** A black stripe along the robot's path, from this many mm on its left to this many, right negative. */
const stripe = (fromMm: number, toMm: number): FloorSetup => ({
  prepare: (world) => {
    const y = 1000 + (fromMm + toMm) / 2;
    world.addStroke({
      pointsMm: [
        { x: 500, y },
        { x: 2900, y },
      ],
      widthMm: toMm - fromMm,
      reflectance: 0,
    });
  },
});

describe('Maqueen Lite for a program of the V5: line sensors by I2C', () => {
  it('says 1 on black: bit 2 left, bit 1 middle, bit 0 right (DFRobot pxt-maqueen, Maqueen_V5.readPatrol)', () => {
    expect(v5().lineBits()).toBe(0b000);
    expect(v5(stripe(-100, 100)).lineBits()).toBe(0b111);
    expect(v5(stripe(3, 60)).lineBits()).toBe(0b100);
    expect(v5(stripe(-3, 3)).lineBits()).toBe(0b010);
    expect(v5(stripe(-60, -3)).lineBits()).toBe(0b001);
  });

  it('gives the brightness of left, middle and right from 0x20, high byte first (readPatrolData)', () => {
    const { word } = v5(stripe(3, 60));
    expect([word(0x20), word(0x22), word(0x24)]).toEqual([1000, 3500, 3500]);
  });

  it('has two ADC channels more, with nothing on them', () => {
    const { word } = v5();
    expect([word(0x1e), word(0x26)]).toEqual([0, 0]);
  });

  it('looks again after the robot has moved', () => {
    const floor = v5({
      prepare: (world) =>
        world.addStroke({
          pointsMm: [
            { x: 1100, y: 500 },
            { x: 1100, y: 1500 },
          ],
          widthMm: 40,
          reflectance: 0,
        }),
    });
    expect(floor.lineBits()).toBe(0);
    floor.send(0x00, 0, 60, 0, 60);
    const seen = new Set<number | undefined>();
    for (let i = 0; i < 40; i++) {
      floor.passMs(20);
      seen.add(floor.lineBits());
    }
    expect([...seen]).toContain(0b111);
    expect(floor.lineBits()).toBe(0);
  });
});

describe('Maqueen Lite for a program of the V5: car lights', () => {
  it('lights the left one by [0x0B, colour] and the right one by [0x0C, colour]; 8 and 0 are off', () => {
    const { send, robot } = v5();
    send(0x0b, 1);
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
    send(0x0c, 7);
    send(0x0b, 8);
    expect(robot.state().leds).toEqual({ left: 0, right: 1 });
    send(0x0b, 0, 0);
    expect(robot.state().leds).toEqual({ left: 0, right: 0 });
  });

  it('leaves the lights at P8 and P12 to the pins', () => {
    const { send, robot, board } = v5();
    board.wire('P8').connect('test').drive(1);
    send(0x0b, 8);
    expect(robot.state().leds).toEqual({ left: 1, right: 0 });
  });

  it('flashes three times and is off then (setRgbBlink: colour, grade, number)', () => {
    const { send, robot, passMs } = v5();
    send(0x0b, 1);
    send(0x0e, 5);
    send(0x0d, 3);
    let flashes = 0;
    let before: 0 | 1 = 0;
    for (let i = 0; i < 300; i++) {
      const now = robot.state().leds.left;
      if (now > before) flashes += 1;
      before = now;
      passMs(10);
    }
    expect([flashes, before]).toEqual([3, 0]);
  });
});

describe('Maqueen Lite for a program of the V5: the rest', () => {
  it('tells the light on its left and right from 0x29, as the board feels it', () => {
    const { word, board } = v5();
    board.sensors.set('lightLevel', 200);
    expect([word(0x29), word(0x2b)]).toEqual([1600, 1600]);
  });

  it('tells how full the battery is in percent, for both kinds of cells', () => {
    const percent = (supplyMv: number, kind: number) => {
      const floor = v5({ supplyMv });
      floor.send(0x2d, kind);
      return floor.readFrom(0x10, 0x2e, 1)[0];
    };
    expect([percent(4800, 0), percent(4800, 1), percent(3300, 1)]).toEqual([100, 100, 0]);
    expect(percent(3750, 1)).toBeGreaterThan(20);
    expect(percent(3750, 1)).toBeLessThan(60);
  });

  it('follows a line by itself after [0x47, 1] and stops after [0x47, 0] (patrolling)', () => {
    const { send, chassis, passMs } = v5(stripe(-10, 10));
    send(0x48, 2);
    send(0x47, 1);
    passMs(4000);
    expect(chassis.pose().xMm).toBeGreaterThan(1250);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(12);
    send(0x47, 0);
    passMs(600);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });

  it('comes back to a line beside it', () => {
    const { send, chassis, passMs } = v5(stripe(2, 22));
    send(0x47, 1);
    passMs(4000);
    expect(chassis.pose().yMm).toBeGreaterThan(1003);
    expect(chassis.pose().xMm).toBeGreaterThan(1200);
  });

  it('finds a line again that turns off to the right at a right angle', () => {
    const { send, chassis, passMs } = v5({
      prepare: (world) => {
        const corner = { x: 1300, y: 1000 };
        for (const end of [
          { x: 700, y: 1000 },
          { x: 1300, y: 200 },
        ])
          world.addStroke({ pointsMm: [end, corner], widthMm: 20, reflectance: 0 });
      },
    });
    send(0x47, 1);
    passMs(6000);
    expect(chassis.pose().yMm).toBeLessThan(800);
    expect(Math.abs(chassis.pose().xMm - 1300)).toBeLessThan(40);
  });

  it('starts anew after [0x46, 1]: lights off, line following off (I2CInit)', () => {
    const { send, robot, passMs, chassis } = v5(stripe(-10, 10));
    send(0x0b, 1, 1);
    send(0x47, 1);
    passMs(500);
    send(0x46, 1);
    passMs(600);
    expect(robot.state().leds).toEqual({ left: 0, right: 0 });
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });
});
