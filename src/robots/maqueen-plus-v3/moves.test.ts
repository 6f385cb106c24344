import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV3Build } from './robot';

/** A Maqueen Plus V3 at (1000, 1000) heading along +x that measures by itself. */
function mover(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV3Build, setup);
  const { chassis, clock, passMs } = floor;
  const set = (register: number, ...values: number[]): boolean => floor.send(0x10, register, ...values);
  const busy = (): number => floor.readFrom(0x10, 87, 1)[0]!;
  const untilDone = (): number => {
    const startUs = clock.nowUs;
    while (busy() === 1 && clock.nowUs - startUs < 60_000_000) passMs(4);
    return (clock.nowUs - startUs) / 1000;
  };
  /** As every driver does it: direction, speed, cm, go; gives the ms until it is done. */
  const distance = (direction: number, cm: number, grade = 2): number => {
    set(64, direction);
    set(85, grade);
    set(65, cm >> 8);
    set(66, cm & 255);
    set(60, 6);
    return untilDone();
  };
  const angle = (direction: number, deg: number, grade = 2): number => {
    set(67, direction);
    set(86, grade);
    set(68, deg);
    set(60, 6);
    return untilDone();
  };
  const pose = () => {
    passMs(300);
    const { xMm, yMm, headingRad } = chassis.pose();
    return { xMm, yMm, deg: (headingRad * 180) / Math.PI };
  };
  return { ...floor, set, busy, untilDone, distance, angle, pose };
}

const [FORWARD, BACKWARD] = [1, 2];
const [RIGHT, LEFT] = [1, 2];

describe('Maqueen Plus V3, its measured moves', () => {
  it.each([
    [FORWARD, 1, 10],
    [FORWARD, 50, 500],
    [BACKWARD, 100, -1000],
    [FORWARD, 255, 2550], // over both bytes: 0, 255
    [FORWARD, 0, 0],
  ])('direction %i drives %i cm: exactly, as measured within 1 cm (jhautbois)', (direction, cm, mm) => {
    const { distance, pose } = mover({ startMm: { x: direction === FORWARD ? 300 : 2500, y: 1000 } });
    distance(direction, cm);
    const { xMm, yMm, deg } = pose();
    expect(xMm - (direction === FORWARD ? 300 : 2500)).toBeCloseTo(mm, 1);
    expect([Math.round(yMm), deg]).toEqual([1000, 0]);
  });

  it('end as well with motors too weak for the last tenths of a millimetre', () => {
    for (const strength of [0.6, 0.7, 0.8, 0.9] as const) {
      const { angle, busy, pose } = mover({ strength: [strength, strength * 0.95] });
      angle(RIGHT, 20);
      expect(busy(), String(strength)).toBe(0);
      expect(Math.abs(pose().deg + 20), String(strength)).toBeLessThan(1.5);
    }
  });

  it.each([
    [RIGHT, 90, -90],
    [LEFT, 45, 45],
    [LEFT, 180, 180],
    [RIGHT, 255, -255],
  ])('direction %i turns by %i° on the spot, the whole degrees exactly', (direction, deg, turnedDeg) => {
    const { angle, pose } = mover();
    angle(direction, deg);
    expect(Math.abs(pose().deg - turnedDeg)).toBeLessThan(0.05);
    expect(Math.abs(pose().xMm - 1000)).toBeLessThan(0.1);
  });

  it('closes a square of 30 cm within a millimetre, also with unequal motors', () => {
    for (const strength of [
      [1, 1],
      [1.06, 0.94],
    ] as const) {
      // prettier-ignore
      const { distance, angle, pose } = mover({ strength });
      for (let side = 0; side < 4; side++) {
        distance(FORWARD, 30);
        angle(LEFT, 90);
      }
      const { xMm, yMm, deg } = pose();
      expect(Math.max(Math.abs(xMm - 1000), Math.abs(yMm - 1000))).toBeLessThan(1);
      expect(Math.abs(deg - 360)).toBeLessThan(0.3);
    }
  });

  it('takes under 10 s for 100 cm and under 5 s for 180° with the usual grade 2 (jhautbois), 1 takes twice as long', () => {
    const far = { startMm: { x: 2500, y: 1000 } };
    expect(mover(far).distance(BACKWARD, 100)).toBeLessThan(10_000);
    expect(mover().angle(RIGHT, 180)).toBeLessThan(5_000);
    const [slow, usual] = [1, 2].map((grade) => mover().distance(BACKWARD, 50, grade));
    expect(Math.abs(slow! / usual! - 2)).toBeLessThan(0.2);
  });

  it('reads 1 in 87 while it moves, at once after 60 ← 6, and else 0', () => {
    const { busy, set, passMs } = mover();
    expect(busy()).toBe(0);
    set(66, 10);
    expect(busy()).toBe(0);
    set(60, 6);
    expect(busy()).toBe(1);
    passMs(3000);
    expect(busy()).toBe(0);
  });

  it('starts what was written last, a distance or an angle', () => {
    const { set, untilDone, pose } = mover();
    set(66, 10);
    set(67, LEFT, 90);
    set(60, 6);
    untilDone();
    expect(pose().deg).toBeCloseTo(90, 1);
    set(64, FORWARD, 0, 10);
    set(60, 6);
    untilDone();
    expect(pose().yMm).toBeCloseTo(1100, 0);
    set(60, 6); // the same once more
    untilDone();
    expect(pose().yMm).toBeCloseTo(1200, 0);
  });

  it.each([
    ['60 ← 16', [60, 16]],
    ['a motor that is set to 0', [0, 0, 0, 0, 0]],
  ])('ends with %s', (_, bytes) => {
    const { busy, set, passMs, pose } = mover();
    set(64, BACKWARD, 0, 90);
    set(60, 6);
    passMs(1000);
    set(...(bytes as [number, ...number[]]));
    expect(busy()).toBe(0);
    passMs(1500);
    const { xMm } = pose();
    passMs(1000);
    expect([pose().xMm, xMm < 950]).toEqual([xMm, true]);
  });

  it('gives way to a patrol, and a patrol to a move', () => {
    const { busy, set, passMs, pose } = mover();
    set(64, BACKWARD, 0, 90);
    set(60, 6);
    set(60, 5);
    expect(busy()).toBe(0);
    set(66, 10);
    set(60, 6);
    passMs(3000);
    expect([busy(), Math.round(pose().xMm)]).toEqual([0, 900]);
  });

  it('goes on with the powers of a motor write that comes in between', () => {
    const { set, passMs, chassis } = mover();
    set(64, FORWARD, 0, 90);
    set(60, 6);
    passMs(1000);
    set(0, 0, 100, 0, 0);
    passMs(1500);
    expect(Math.abs(chassis.wheelSpeedMmPerS(0) - 130)).toBeLessThan(5);
    expect(chassis.wheelSpeedMmPerS(1)).toBe(0);
  });

  it('drives on for 600 m where a driver writes 60000 for 6000 and more, until it is broken off', () => {
    const { set, passMs, busy, chassis } = mover();
    set(64, BACKWARD, 0xea, 0x60);
    set(60, 6);
    passMs(5000);
    expect([busy(), Math.abs(chassis.wheelSpeedMmPerS(0) + 135) < 2]).toEqual([1, true]);
  });

  it('ends 4 mm and 2° off per standard deviation, where chance has a part', () => {
    const { distance, angle, pose } = mover({ miss: -1 });
    distance(FORWARD, 50);
    expect(pose().xMm).toBeCloseTo(1496, 0);
    angle(LEFT, 90);
    expect(pose().deg).toBeCloseTo(88, 1);
  });

  it('knows how far it has driven, in cm, forward and backward alike, until 91 is written', () => {
    const { distance, readFrom, set } = mover();
    distance(FORWARD, 30);
    distance(BACKWARD, 30);
    expect(readFrom(0x10, 90, 2)).toEqual([0, 60]);
    set(91, 0);
    expect(readFrom(0x10, 90, 2)).toEqual([0, 0]);
  });
});
