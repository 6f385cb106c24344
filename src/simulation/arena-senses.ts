import { degOf, radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { GRAVITY_MG, type Sensors } from '#board/sensors/sensors';
import type { Chassis } from '#world/chassis';
import { STEP_US } from '#world/step';

/** The arena's data about the board's place. */
export interface Surroundings {
  readonly chassis: Pick<Chassis, 'pose' | 'turnedRad' | 'collisions'>;
  /** Reflectance under a round spot given in the robot frame, 0 black … 1 bare floor. */
  readonly ground: (spot: Vec, radiusMm: number) => number;
  /** The light level of the board in an arena with lamps; `null`: there are none, and the floor's brightness stands in. */
  readonly light?: () => number | null;
}

/**
 * Lets the board on the robot measure the arena: compass, accelerometer and light. While it is off, they stay as set by
 * hand; only the compass turns with the robot, because a program that turns by it would otherwise never end.
 */
export interface ArenaSenses {
  readonly isOn: boolean;
  /** Switches it on, for all sensors, or off: that restores the earlier values of those that were measured. */
  switch(on: boolean): void;
  /** Call it when a sensor is set by hand: it is not measured until this is switched on again. */
  setByHand(id: string): void;
  /** Call it after each step of the world. */
  step(): void;
}

const FIELD_HORIZONTAL_NT = 21_500; // chosen: the earth's magnetic field in Zürich, rounded
const FIELD_DOWN_NT = 43_000; // chosen: its part that points into the ground
const MM_PER_S2_PER_MG = 9.806_65; // a thousandth of standard gravity
const MOST_MG = 2000; // the range of the sensor at its start
const SPOT_MM = 20; // chosen: the board looks at about its own width of floor

/**
 * A bump makes the chassis rattle: the deceleration returns with changing sign and dies away. Chosen so that driving
 * into a wall at full speed is a `shake` for the device, and touching one slowly is not.
 */
const RATTLE = { halfPeriodUs: 40_000, damping: 0.75, halfPeriods: 8 } as const;

/** The axes that are set at each step; all others are measured when they are asked for. */
const FELT = ['accelerometerX', 'accelerometerY', 'accelerometerZ'];

/**
 * Chosen: the board lies flat on the robot, its logo forwards, its display up; the upper edge of the arena is north. x
 * points to the robot's right, y backwards (towards the board's edge connector), z up.
 */
export function createArenaSenses(sensors: Sensors, around: Surroundings): ArenaSenses {
  const { chassis } = around;
  let before: ReadonlyMap<string, number> | null = null;
  const byHand = new Set<string>();
  let motion = createMotion(chassis);
  let turnedDeg = turnOf(chassis);
  const measures = measuresOf(around);
  const set = (id: string, value: number): void => {
    if (!byHand.has(id) && sensors.get(id) !== whole(value)) sensors.set(id, whole(value));
  };
  /** Gestures follow from each change. */
  const feel = (): void => {
    const { forwardMg, leftMg } = motion();
    set('accelerometerX', clamped(-leftMg));
    set('accelerometerY', clamped(forwardMg));
    set('accelerometerZ', -GRAVITY_MG);
  };
  /** Turns the compass with the robot, in whole degrees. */
  const turnAlong = (): void => {
    const now = turnOf(chassis);
    if (now === turnedDeg) return;
    set('compassHeading', onCircle(sensors.get('compassHeading') - (now - turnedDeg)));
    turnedDeg = now;
  };
  return {
    get isOn() {
      return before !== null;
    },
    switch(on) {
      if (on) {
        byHand.clear();
        const isNew = before === null;
        before ??= new Map([...FELT, ...Object.keys(measures)].map((id) => [id, sensors.get(id)]));
        for (const [id, measure] of Object.entries(measures)) sensors.measure(id, measure);
        if (!isNew) return;
        motion = createMotion(chassis);
        feel();
      } else if (before !== null) {
        for (const [id, value] of before) {
          // In an arena with lamps the board sees them, whether it feels the rest of the arena or not.
          const isLamps = id === 'lightLevel' && (around.light?.() ?? null) !== null;
          if (!byHand.has(id) && !isLamps) sensors.set(id, value);
        }
        byHand.clear();
        before = null;
        turnedDeg = turnOf(chassis);
      }
    },
    setByHand(id) {
      if (before !== null) byHand.add(id);
    },
    step() {
      if (before !== null) feel();
      else turnAlong();
    },
  };
}

/** Compass and light, by sensor id. Programs ask for them now and then, the world goes on 250 times a second. */
function measuresOf({ chassis, ground, light }: Surroundings): Readonly<Record<string, () => number>> {
  const headingDeg = (): number => onCircle(Math.round(90 - degOf(chassis.pose().headingRad)));
  const headingRad = (): number => radOf(headingDeg());
  return {
    compassHeading: headingDeg,
    compassX: () => whole(FIELD_HORIZONTAL_NT * exactCos(headingRad())),
    compassY: () => whole(-FIELD_HORIZONTAL_NT * exactSin(headingRad())),
    compassZ: () => -FIELD_DOWN_NT,
    lightLevel: () => light?.() ?? whole(255 * ground({ x: 0, y: 0 }, SPOT_MM)),
  };
}

/** How far the robot has turned, in whole degrees, counter-clockwise. */
const turnOf = (chassis: Surroundings['chassis']): number => Math.round(degOf(chassis.turnedRad()));

/** An angle as one of 0 … 359. */
const onCircle = (degrees: number): number => ((degrees % 360) + 360) % 360;

const whole = (value: number): number => Math.round(value) + 0;

const clamped = (mg: number): number => Math.max(-MOST_MG, Math.min(MOST_MG, mg));

/** Acceleration of the chassis, robot frame, step by step: over the last five steps, and the rattle after a bump. */
function createMotion(chassis: Surroundings['chassis']): () => { forwardMg: number; leftMg: number } {
  const WINDOW = 5; // steps, together 20 ms: the period in which the device reads its accelerometer
  // The speeds of this step and of the five before it, in a ring: this is asked 250 times a second.
  const [speedsX, speedsY] = [new Float64Array(WINDOW + 1), new Float64Array(WINDOW + 1)];
  let steps = 0;
  let { xMm: lastX, yMm: lastY } = chassis.pose();
  let bumps = chassis.collisions();
  let rattle: { readonly forwardMg: number; readonly leftMg: number; ageUs: number } | null = null;
  return () => {
    const pose = chassis.pose();
    const perSecond = 1_000_000 / STEP_US;
    const place = steps % (WINDOW + 1);
    const speedX = (speedsX[place] = (pose.xMm - lastX) * perSecond);
    const speedY = (speedsY[place] = (pose.yMm - lastY) * perSecond);
    ({ xMm: lastX, yMm: lastY } = pose);
    steps++;
    const oldest = steps > WINDOW ? steps % (WINDOW + 1) : 0;
    const perG = (WINDOW * STEP_US) / 1_000_000;
    const ax = (speedX - (speedsX[oldest] ?? 0)) / perG / MM_PER_S2_PER_MG;
    const ay = (speedY - (speedsY[oldest] ?? 0)) / perG / MM_PER_S2_PER_MG;
    const [cos, sin] = [exactCos(pose.headingRad), exactSin(pose.headingRad)];
    const felt = { forwardMg: ax * cos + ay * sin, leftMg: ay * cos - ax * sin };
    if (chassis.collisions() > bumps) {
      bumps = chassis.collisions();
      rattle = { ...felt, ageUs: 0 };
    }
    if (rattle === null) return felt;
    const half = Math.floor(rattle.ageUs / RATTLE.halfPeriodUs);
    rattle.ageUs += STEP_US;
    if (half >= RATTLE.halfPeriods) rattle = null;
    if (rattle === null) return felt;
    let share = 1;
    for (let i = 0; i < half; i++) share *= -RATTLE.damping;
    return { forwardMg: rattle.forwardMg * share, leftMg: rattle.leftMg * share };
  };
}
