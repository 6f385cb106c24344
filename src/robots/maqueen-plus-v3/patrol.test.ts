import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { putOnFloor } from '../testing/floor';
import { maqueenPlusV3Build } from './robot';

type Line = readonly (readonly [x: number, y: number])[];

const vec = ([x, y]: readonly [number, number]): Vec => ({ x, y });

/** A Maqueen Plus V3 at (1000, 1000) heading along +x, on black lines of 20 mm. */
function onLines(...lines: readonly Line[]) {
  const floor = putOnFloor(maqueenPlusV3Build, {
    prepare: (world) =>
      lines.forEach((points) => world.addStroke({ pointsMm: points.map(vec), widthMm: 20, reflectance: 0 })),
  });
  const { chassis, passMs } = floor;
  const set = (register: number, ...values: number[]): boolean => floor.send(0x10, register, ...values);
  const junction = (): number => floor.readFrom(0x10, 61, 1)[0]!;
  /** Follows the line for 12 s at most, or until the axle is 300 mm from the junction; gives the junctions told. */
  const drive = (forMs = 12_000): number[] => {
    const told: number[] = [];
    for (let ms = 0; ms < forMs; ms += 4) {
      passMs(4);
      const now = junction();
      if (now !== (told.at(-1) ?? 0)) told.push(now);
      const { xMm, yMm } = chassis.pose();
      if (xMm > 1700 || Math.abs(yMm - 1000) > 300) break;
    }
    return told;
  };
  const place = (): string => {
    const { xMm, yMm } = chassis.pose();
    if (xMm > 1650) return 'straight';
    if (yMm > 1250) return 'left';
    return yMm < 750 ? 'right' : 'here';
  };
  return { ...floor, set, junction, drive, place };
}

const AHEAD: Line = [[900, 1000], [1400, 1000]]; // prettier-ignore
const ON: Line = [[1400, 1000], [2000, 1000]]; // prettier-ignore
const TO_LEFT: Line = [[1400, 1000], [1400, 1600]]; // prettier-ignore
const TO_RIGHT: Line = [[1400, 1000], [1400, 400]]; // prettier-ignore

const JUNCTIONS = {
  crossing: [AHEAD, ON, TO_LEFT, TO_RIGHT],
  tee: [AHEAD, TO_LEFT, TO_RIGHT],
  'branch to the left': [AHEAD, ON, TO_LEFT],
  'branch to the right': [AHEAD, ON, TO_RIGHT],
} as const;

describe('Maqueen Plus V3, its patrol at junctions (registers 61, 69 to 72)', () => {
  it.each([
    ['crossing', 69, 1, 1, 'left'],
    ['crossing', 69, 2, 1, 'right'],
    ['crossing', 69, 3, 1, 'straight'],
    ['crossing', 69, 4, 1, 'here'],
    ['tee', 70, 1, 2, 'left'],
    ['tee', 70, 2, 2, 'right'],
    ['tee', 70, 4, 2, 'here'],
    ['branch to the left', 71, 1, 3, 'left'],
    ['branch to the left', 71, 3, 3, 'straight'],
    ['branch to the left', 71, 4, 3, 'here'],
    ['branch to the right', 72, 2, 4, 'right'],
    ['branch to the right', 72, 3, 4, 'straight'],
    ['branch to the right', 72, 4, 4, 'here'],
  ] as const)('%s, %i ← %i: tells %i and goes %s, at every speed', (name, register, way, told, end) => {
    for (const grade of [1, 2, 5]) {
      const { set, drive, place } = onLines(...JUNCTIONS[name]);
      set(register, way);
      set(63, grade);
      set(60, 5);
      expect(drive()).toEqual(end === 'here' ? [told] : [told, 0]);
      expect(place()).toBe(end);
    }
  });

  it.each([
    ['crossing', 'straight'],
    ['tee', 'left'],
    ['branch to the left', 'straight'],
    ['branch to the right', 'straight'],
  ] as const)('%s: goes %s before a program has chosen, and for a way that there is not', (name, end) => {
    for (const ways of [[], [9, 3, 2, 1]]) {
      const { set, drive, place } = onLines(...JUNCTIONS[name]);
      if (ways.length > 0) set(69, ...ways);
      set(60, 5);
      drive();
      expect(place()).toBe(end);
    }
  });

  it('takes a corner as a part of the line: no junction', () => {
    for (const [side, place] of [
      [TO_LEFT, 'left'],
      [TO_RIGHT, 'right'],
    ] as const) {
      // prettier-ignore
      const patrol = onLines(AHEAD, side);
      patrol.set(60, 5);
      expect(patrol.drive()).toEqual([]);
      expect(patrol.place()).toBe(place);
    }
  });

  it('goes straight on from a junction at which it stands when it is started once more', () => {
    const { set, drive, place } = onLines(...JUNCTIONS.crossing);
    set(69, 4);
    set(60, 5);
    drive(6000);
    expect(place()).toBe('here');
    set(60, 5);
    expect(drive()).toEqual([1, 0]);
    expect(place()).toBe('straight');
  });

  it('lets a program ask and act by itself: at 1 it ends the patrol, turns by 90° and goes on', () => {
    const { set, junction, passMs, drive, place } = onLines(...JUNCTIONS.crossing);
    set(60, 5);
    while (junction() !== 1) passMs(10);
    set(60, 8);
    set(64, 1, 0, 3);
    set(60, 6);
    passMs(1500);
    set(67, 2, 90);
    set(60, 6);
    passMs(3000);
    set(60, 5);
    drive();
    expect(place()).toBe('left');
  });
});

describe('Maqueen Plus V3, its patrol along a line (registers 60 and 63)', () => {
  /** A closed line, a circle with this radius that begins under the robot. */
  const circle = (radius: number): Line =>
    Array.from({ length: 73 }, (_, at) => {
      const turn = (at * Math.PI) / 36;
      return [1000 + radius * Math.sin(turn), 1000 + radius - radius * Math.cos(turn)];
    });

  it.each([80, 200, 400])('stays on a circle of %i mm at each of its speeds, and sees no junction there', (radius) => {
    for (const grade of [1, 2, 3, 4, 5]) {
      const { set, passMs, chassis, junction } = onLines(circle(radius));
      set(63, grade);
      set(60, 5);
      for (let s = 0; s < 20; s++) {
        passMs(1000);
        expect(junction()).toBe(0);
      }
      const { xMm, yMm } = chassis.pose();
      const off = Math.sqrt((xMm - 1000) ** 2 + (yMm - 1000 - radius) ** 2) - radius;
      expect(Math.abs(off)).toBeLessThan(40);
      expect(chassis.turnedRad()).toBeGreaterThan(3.4);
    }
  });

  it.each([
    [1, 80],
    [2, 120],
    [3, 160],
    [4, 200],
    [5, 250],
    [0, 80],
    [9, 250],
  ])('drives at speed %i with %i mm/s, within 2 %', (grade, mmPerS) => {
    const { set, passMs, chassis } = onLines(AHEAD, ON);
    set(63, grade);
    set(60, 5);
    passMs(1000);
    expect(Math.abs(chassis.wheelSpeedMmPerS(0) / mmPerS - 1)).toBeLessThan(0.02);
  });

  it('ends with 60 ← 8 and with a motor write', () => {
    for (const bytes of [
      [60, 8],
      [0, 0, 0, 0, 0],
    ] as const) {
      // prettier-ignore
      const { set, passMs, chassis } = onLines(AHEAD, ON);
      set(60, 5);
      passMs(1000);
      set(...(bytes as readonly [number, ...number[]]));
      passMs(500);
      const path = chassis.pathMm();
      passMs(1000);
      expect(chassis.pathMm()).toBe(path);
    }
  });

  it('stops a second after the line has ended', () => {
    const { set, passMs, chassis } = onLines(AHEAD);
    set(60, 5);
    passMs(8000);
    const path = chassis.pathMm();
    passMs(1000);
    expect(chassis.pathMm()).toBe(path);
    expect(chassis.pose().xMm).toBeLessThan(1450);
  });
});
