import { describe, expect, it } from 'vitest';
import type { WheelSide } from './chassis';
import { STEP_US } from './step';
import { testChassis } from './testing/rig';
import { createWorld } from './world';

/** A motor's duty, set at a time in µs. */
type Setting = readonly [atUs: number, wheel: WheelSide, duty: number];

const sticky = testChassis({ coulomb: 0.01, breakaway: { share: 0.05, until: 0.2 } });
const slippery = {
  ...sticky,
  wheels: [
    { ...sticky.wheels[0], gripMu: 0.3 },
    { ...sticky.wheels[1], gripMu: 0.3 },
  ] as const,
};
const BODIES = { plain: testChassis(), sticky, slippery };
/** How far apart its turns may come out, in degrees: a tyre that begins or ends to slip within a step does so a little off. */
const APART = [
  ['plain', 0.05],
  ['sticky', 0.05],
  ['slippery', 0.15],
] as const;

/** Drives a robot by the clock of a program that sets its motors in the midst of steps. */
function drive(settings: readonly Setting[], type = BODIES.plain) {
  let nowUs = 0;
  const world = createWorld({ widthMm: 4000, heightMm: 4000 });
  const robot = world.addChassis(type, { xMm: 2000, yMm: 2000, headingRad: 0 }, () => nowUs);
  const ahead = [...settings];
  for (let stepUs = STEP_US; stepUs <= 4_000_000; stepUs += STEP_US) {
    for (let next = ahead[0]; next !== undefined && next[0] < stepUs; next = ahead[0]) {
      nowUs = next[0];
      robot.setDuty(next[1], next[2]);
      ahead.shift();
    }
    nowUs = stepUs;
    world.step();
  }
  return { turnedDeg: (robot.turnedRad() * 180) / Math.PI, pathMm: robot.pathMm() };
}

/** Both motors, the right one `gapUs` later. */
const both = (atUs: number, left: number, right: number, gapUs = 434): readonly Setting[] => [
  [atUs, 0, left],
  [atUs + gapUs, 1, right],
];

const spread = (numbers: readonly number[]): number => Math.max(...numbers) - Math.min(...numbers);
const BEGINNINGS = Array.from({ length: 20 }, (_, i) => 200 * i);

describe('a duty that is set in the midst of a step', () => {
  it('acts from then on: a turn that lasts 1 ms longer goes on as far as the robot turns in 1 ms', () => {
    const turn = (ms: number): number => drive([...both(0, -0.2, 0.2), ...both(ms * 1000, 0, 0)]).turnedDeg;
    const perMs = (turn(440) - turn(400)) / 40;
    for (let ms = 400; ms < 412; ms++) expect((turn(ms + 1) - turn(ms)) / perMs).toBeCloseTo(1, 1);
  });

  it.each(APART)(
    'turns a %s robot as far wherever in a step it is begun, to %s°: rest, drive, turn, drive back, rest',
    (body, apart) => {
      const turns = BEGINNINGS.map(
        (us) =>
          drive(
            [
              ...both(us, 0.4, 0.4),
              ...both(us + 1_000_000, -0.4, 0.4),
              ...both(us + 1_430_000, -0.4, -0.4),
              ...both(us + 2_430_000, 0, 0),
            ],
            BODIES[body],
          ).turnedDeg,
      );
      expect(Math.abs(turns[0]!)).toBeGreaterThan(100);
      expect(spread(turns)).toBeLessThan(apart);
    },
  );

  it('does not kink a straight way when the motors are set one after the other, to 0.05°', () => {
    for (const us of BEGINNINGS)
      expect(Math.abs(drive([...both(us, 0.3, 0.3), ...both(us + 2_000_000, 0, 0)]).turnedDeg)).toBeLessThan(0.05);
  });

  it('counts with its time where several follow each other within a step: 1 + 1 ms as 2 ms', () => {
    const pulses = (...edges: readonly number[]): number => {
      const settings = edges.flatMap((us, i) =>
        both(200_000 + us, i % 2 === 0 ? 0.8 : 0.3, i % 2 === 0 ? 0.8 : 0.3, 0),
      );
      return drive([...both(0, 0.3, 0.3, 0), ...settings, ...both(2_000_000, 0, 0, 0)]).pathMm;
    };
    const none = drive([...both(0, 0.3, 0.3, 0), ...both(2_000_000, 0, 0, 0)]).pathMm;
    const once = pulses(500, 2500) - none;
    expect(once).toBeGreaterThan(0.05);
    expect((pulses(500, 1500, 2000, 3000) - none) / once).toBeCloseTo(1, 2);
    expect((pulses(1000, 2000) - none) / once).toBeCloseTo(0.5, 2);
  });

  it('moves a robot at rest also when it is over before the step ends', () => {
    const pulse = drive([...both(1000, 1, 1, 0), ...both(3500, 0, 0, 0)]).pathMm;
    expect(pulse).toBeGreaterThan(0.05);
    expect(drive([...both(5000, 1, 1, 0), ...both(7500, 0, 0, 0)]).pathMm).toBe(pulse);
  });

  it('waits for its step when it is set for one that has not begun', () => {
    const world = createWorld({ widthMm: 4000, heightMm: 4000 });
    let nowUs = 2 * STEP_US + 1000;
    const robot = world.addChassis(BODIES.plain, { xMm: 2000, yMm: 2000, headingRad: 0 }, () => nowUs);
    for (const side of [0, 1] as const) robot.setDuty(side, 1);
    expect(robot.duty(0)).toBe(1);
    world.step();
    world.step();
    expect(robot.pathMm()).toBe(0);
    nowUs = 3 * STEP_US;
    world.step();
    expect(robot.pathMm()).toBeGreaterThan(0.05);
  });

  it('is weakened by a battery at once', () => {
    const [full, weak] = [1, 0.5].map((supply) => {
      const world = createWorld({ widthMm: 4000, heightMm: 4000 });
      const robot = world.addChassis(BODIES.plain, { xMm: 2000, yMm: 2000, headingRad: 0 });
      robot.setBattery((left, right) => (left === 0 && right === 0 ? 1 : supply));
      for (const side of [0, 1] as const) robot.setDuty(side, 0.8);
      world.step();
      return robot.pathMm();
    });
    expect(weak! / full!).toBeCloseTo((0.4 - 0.0296) / (0.8 - 0.0296), 1);
  });
});
