import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Chassis } from '#world/chassis';
import { STEP_US } from '#world/step';
import { createWorld } from '#world/world';
import { robotTypes } from './index';
import type { RobotType } from './robot';

/** The exports of a robot's motor-law.mjs; scripts/fit-motor-law.mjs reads the same. */
interface FitData {
  readonly motorLaw: {
    readonly trackMm: number;
    /** Largest allowed error of the worst circle of the grid below; more than 0.25 needs a reason in its notes. */
    readonly circlesWithin: number;
    readonly notes: readonly string[];
    readonly straight: { readonly rows: readonly (readonly [byte: number, mmPerS: number])[] };
    readonly standsAt: number;
  };
  readonly arcBytes: (radiusM: number, percent: number) => readonly [inner: number, outer: number];
}

const SPEEDS = [30, 50, 70, 100];
const RADII = [0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5];
const CELLS = SPEEDS.flatMap((percent) => RADII.map((radiusM) => ({ percent, radiusM })));

/** A robot in an empty arena of 4 m × 4 m with its motors at two power bytes. */
function driving(type: RobotType, leftByte: number, rightByte: number) {
  const world = createWorld({ widthMm: 4000, heightMm: 4000 });
  const chassis = world.addChassis(type.body, { xMm: 2000, yMm: 1000, headingRad: 0 });
  chassis.setDuty(0, leftByte / 255);
  chassis.setDuty(1, rightByte / 255);
  const pass = (seconds: number): void => {
    for (let us = 0; us < seconds * 1e6; us += STEP_US) world.step();
  };
  return { chassis, world, pass };
}

/** Path per turn in m, once it no longer changes by more than 0.1 % in 0.4 s. */
function steadyRadiusM(type: RobotType, leftByte: number, rightByte: number): number {
  const { chassis, pass } = driving(type, leftByte, rightByte);
  let last = 0;
  for (;;) {
    const [path, turned] = [chassis.pathMm(), chassis.turnedRad()];
    pass(0.4);
    const radius = (chassis.pathMm() - path) / Math.abs(chassis.turnedRad() - turned) / 1000;
    if (Math.abs(radius / last - 1) < 0.001) return radius;
    last = radius;
  }
}

/** Half the width and half the height, in m, of the robot's path from standstill until it has turned 380°. */
function halfExtentsM(type: RobotType, leftByte: number, rightByte: number): readonly [number, number] {
  const { chassis, world } = driving(type, leftByte, rightByte);
  const x = [Infinity, -Infinity];
  const y = [Infinity, -Infinity];
  while (Math.abs(chassis.turnedRad()) < (380 / 180) * Math.PI) {
    world.step();
    widen(x, chassis.pose().xMm);
    widen(y, chassis.pose().yMm);
  }
  return [(x[1]! - x[0]!) / 2000, (y[1]! - y[0]!) / 2000];
}

function widen(extent: number[], value: number): void {
  extent[0] = Math.min(extent[0]!, value);
  extent[1] = Math.max(extent[1]!, value);
}

const straightSpeed = (chassis: Chassis): number => (chassis.wheelSpeedMmPerS(0) + chassis.wheelSpeedMmPerS(1)) / 2;

/** Cells of a row of the page's tables that begins with this number. */
function pageRow(page: string, heading: string, first: number): readonly string[] {
  const part = page.slice(page.indexOf(heading));
  const row = part.split('\n').find((line) => line.startsWith(`| ${first} |`));
  if (!row) throw new Error(`The page has no row ${first} under "${heading}".`);
  return row.split('|').map((cell) => cell.trim());
}

const fits = import.meta.glob<FitData>('./*/motor-law.mjs', { eager: true });

describe.each(robotTypes.filter(({ id }) => fits[`./${id}/motor-law.mjs`]))('the drive of the $name', (type) => {
  const { motorLaw, arcBytes } = fits[`./${type.id}/motor-law.mjs`]!;
  const pagePath = `docs/hardware/${type.id}-motor-law.md`;
  const page = existsSync(pagePath) ? readFileSync(pagePath, 'utf8') : '';

  it(`has the constants of ${pagePath}`, () => {
    const { v0MmPerS, coulomb, breakaway, viscous, yawResistance } = type.body.drive;
    const [left, right] = type.body.wheels;
    for (const row of [
      `v0 | ${v0MmPerS} mm/s`,
      `coulomb | ${coulomb}`,
      `viscous | ${viscous}`,
      `breakaway share | ${breakaway?.share}`,
      `breakaway until | ${breakaway?.until}`,
      `yawResistance | ${yawResistance}`,
      `track | ${left.atMm.y - right.atMm.y} mm (given, not fitted)`,
    ]) {
      expect(page).toContain(`| ${row} |`);
    }
    expect(motorLaw.trackMm).toBe(left.atMm.y - right.atMm.y);
  });

  it('drives straight as fast at each power byte as its page says, to 1 mm/s', () => {
    for (const [byte] of motorLaw.straight.rows) {
      const { chassis, pass } = driving(type, byte, byte);
      pass(2.5);
      const told = Number(pageRow(page, '## Straight ahead', byte)[3]);
      expect(Math.abs(straightSpeed(chassis) - told), `byte ${byte}`).toBeLessThan(1);
      expect(chassis.turnedRad()).toBe(0);
    }
  });

  it(`stands still at power byte ${motorLaw.standsAt} and moves at its slowest published one`, () => {
    const still = driving(type, motorLaw.standsAt, motorLaw.standsAt);
    still.pass(1);
    expect(still.chassis.pathMm()).toBe(0);
    const [byte] = motorLaw.straight.rows[0]!;
    const moving = driving(type, byte, byte);
    moving.pass(1);
    expect(moving.chassis.pathMm()).toBeGreaterThan(10);
  });

  const limit = motorLaw.circlesWithin;
  it.each(CELLS)(
    `drives leftArc($radiusM) at speed $percent within ${Math.round(limit * 100)} % of that radius and as its page says`,
    ({ percent, radiusM }) => {
      const driven = steadyRadiusM(type, ...arcBytes(radiusM, percent));
      expect(Math.abs(driven / radiusM - 1)).toBeLessThan(limit);
      const told = parseFloat(pageRow(page, '## Circles', radiusM)[2 + SPEEDS.indexOf(percent)]!) / 100;
      expect(Math.abs(driven / told - 1)).toBeLessThan(0.01);
    },
  );

  it('explains on its page why a circle is more than 25 % off', () => {
    expect(limit).toBeLessThanOrEqual(0.35);
    if (limit > 0.25) expect(motorLaw.notes.some((note) => note.includes('more than 25 % off'))).toBe(true);
    for (const note of motorLaw.notes) expect(page).toContain(note);
  });

  it.each([0.15, 0.3, 0.5])(
    'leaves a round circle of leftArc(%f) at speed 50 on the floor from standstill',
    (radiusM) => {
      const [inner, outer] = arcBytes(radiusM, 50);
      const steady = steadyRadiusM(type, inner, outer);
      const [halfWidth, halfHeight] = halfExtentsM(type, inner, outer);
      expect(Math.abs(halfHeight / steady - 1)).toBeLessThan(0.03);
      expect(Math.abs(halfWidth / steady - 1)).toBeLessThan(0.03);
    },
  );

  it('drives rightArc as leftArc, mirrored', () => {
    const [inner, outer] = arcBytes(0.2, 50);
    expect(steadyRadiusM(type, outer, inner)).toBeCloseTo(steadyRadiusM(type, inner, outer), 9);
  });

  it('turns on the spot as fast as its wheels run straight, about the middle of its axle', () => {
    const spinning = driving(type, -60, 60);
    const straight = driving(type, 60, 60);
    for (const { pass } of [spinning, straight]) pass(2);
    expect(spinning.chassis.wheelSpeedMmPerS(1)).toBeCloseTo(straight.chassis.wheelSpeedMmPerS(1), 3);
    expect(Math.abs(spinning.chassis.pose().xMm - 2000)).toBeLessThan(0.01);
    expect(Math.abs(spinning.chassis.pose().yMm - 1000)).toBeLessThan(0.01);
  });

  it('stalls against a wall: at low power its wheels stand, at full power they turn or slip, and it backs off again', () => {
    const { chassis, world, pass } = driving(type, 40, 40);
    world.addWall({ fromMm: { x: 2200, y: 500 }, toMm: { x: 2200, y: 1500 }, thicknessMm: 10 });
    pass(3);
    const stalled = chassis.pose();
    expect(stalled.xMm).toBeLessThan(2195);
    expect(Math.abs(straightSpeed(chassis))).toBeLessThan(1);
    for (const side of [0, 1] as const) chassis.setDuty(side, 1);
    pass(1);
    expect(Math.abs(chassis.pose().xMm - stalled.xMm)).toBeLessThan(1);
    for (const side of [0, 1] as const) chassis.setDuty(side, -40 / 255);
    pass(1);
    expect(chassis.pose().xMm).toBeLessThan(stalled.xMm - 50);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(1);
  });
});
