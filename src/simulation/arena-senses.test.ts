import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import type { Pose } from '#core/geometry';
import { createRig } from '#world/testing/rig';
import { createArenaSenses } from './arena-senses';

/** A robot with a board in an arena of 4 × 4 m with a black line along its middle. */
function robotAt(start: Pose) {
  const rig = createRig(start);
  rig.world.addStroke({
    pointsMm: [
      { x: 0, y: 2000 },
      { x: 4000, y: 2000 },
    ],
    widthMm: 200,
    reflectance: 0,
  });
  const board = new Board(microbitV2, new Clock());
  const senses = createArenaSenses(board.sensors, {
    chassis: rig.robot,
    ground: (spot, radiusMm) => rig.world.reflectanceAt(rig.robot.toWorld(spot), radiusMm),
  });
  /** Drives for this many steps of 4 ms and returns the largest and smallest measured forward acceleration. */
  const drive = (leftByte: number, rightByte: number, steps: number) => {
    const felt: number[] = [];
    for (let i = 0; i < steps; i++) {
      rig.drive(leftByte, rightByte, 0.004);
      senses.step();
      felt.push(board.sensors.get('accelerometerY'));
    }
    return felt;
  };
  return { rig, board, senses, drive };
}

const facing = (headingDeg: number) => robotAt({ xMm: 2000, yMm: 1000, headingRad: (headingDeg * Math.PI) / 180 });

describe('a board that feels the arena', () => {
  it.each([
    [90, 0],
    [0, 90],
    [-90, 180],
    [180, 270],
    [450, 0],
  ])('turned to %i° (counter-clockwise from the right) has a compass that shows %i°', (headingDeg, compassDeg) => {
    const { board, senses } = facing(headingDeg);
    senses.switch(true);
    expect(board.sensors.get('compassHeading')).toBe(compassDeg);
  });

  it('is bright on the bare floor and dark over a wide black line', () => {
    const bare = facing(0);
    bare.senses.switch(true);
    expect(bare.board.sensors.get('lightLevel')).toBe(255);
    const black = robotAt({ xMm: 2000, yMm: 2000, headingRad: 0 });
    black.senses.switch(true);
    expect(black.board.sensors.get('lightLevel')).toBe(0);
  });

  it('feels nothing but its weight at rest and at steady speed', () => {
    const { board, senses, drive } = facing(0);
    senses.switch(true);
    drive(150, 150, 250);
    expect(Math.abs(board.sensors.get('accelerometerY'))).toBeLessThan(10);
    expect(board.sensors.get('accelerometerZ')).toBe(-1024);
  });

  it('is shaken when it drives into a wall: strong pushes to and fro', () => {
    const { senses, drive } = robotAt({ xMm: 3800, yMm: 1000, headingRad: 0 });
    senses.switch(true);
    const felt = drive(255, 255, 300);
    const strong = felt.filter((mg) => Math.abs(mg) > 400).map(Math.sign);
    const turns = strong.filter((sign, i) => i > 0 && sign !== strong[i - 1]).length;
    expect(turns).toBeGreaterThanOrEqual(4);
  });

  it('is off until it is switched on, and gives back what was set by hand when it is switched off', () => {
    const { board, senses, drive } = facing(0);
    board.sensors.set('lightLevel', 7);
    drive(100, 100, 5);
    expect(board.sensors.get('lightLevel')).toBe(7);
    senses.switch(true);
    expect(board.sensors.get('lightLevel')).toBe(255);
    senses.switch(false);
    expect(board.sensors.get('lightLevel')).toBe(7);
  });

  it('keeps what the hand sets while it feels the arena, on and off, until it is switched on again', () => {
    const { board, senses, drive } = facing(0);
    const byHand = (id: 'lightLevel', value: number): void => {
      senses.setByHand(id);
      board.sensors.set(id, value);
    };
    senses.switch(true);
    byHand('lightLevel', 12);
    drive(40, -40, 200);
    expect(board.sensors.get('lightLevel')).toBe(12);
    expect(board.sensors.get('compassHeading')).toBeGreaterThan(180);
    senses.switch(false);
    expect(board.sensors.get('lightLevel')).toBe(12);
    senses.switch(true);
    byHand('lightLevel', 12);
    senses.switch(true);
    drive(0, 0, 1);
    expect(board.sensors.get('lightLevel')).toBe(255);
  });
});

describe('a board that does not feel the arena', () => {
  it('keeps what the hand has set, but its compass turns along with the robot, clockwise positive', () => {
    const { rig, board, drive } = facing(0);
    expect(board.sensors.get('compassHeading')).toBe(0);
    drive(40, -40, 200);
    const turnedDeg = (rig.robot.turnedRad() * 180) / Math.PI;
    expect(turnedDeg).toBeLessThan(-90);
    expect(board.sensors.get('compassHeading')).toBe(Math.round(-turnedDeg) % 360);
    board.sensors.set('compassHeading', 10);
    drive(-40, 40, 100);
    const backDeg = (rig.robot.turnedRad() * 180) / Math.PI - turnedDeg;
    expect(Math.abs(((10 - backDeg + 720) % 360) - board.sensors.get('compassHeading'))).toBeLessThan(2);
    expect(board.sensors.get('lightLevel')).toBe(127);
  });

  it('has its compass where the hand had it when the arena is switched off, and turns along from there', () => {
    const { board, senses, drive } = facing(0);
    senses.switch(true);
    expect(board.sensors.get('compassHeading')).toBe(90);
    drive(40, -40, 200);
    senses.switch(false);
    expect(board.sensors.get('compassHeading')).toBe(0);
    drive(0, 0, 50);
    const still = board.sensors.get('compassHeading');
    drive(0, 0, 50);
    expect(board.sensors.get('compassHeading')).toBe(still);
    drive(40, -40, 50);
    expect(board.sensors.get('compassHeading')).toBeGreaterThan(still + 10);
  });
});
