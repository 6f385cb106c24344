/**
 * A hobby servo: a geared motor that turns its arm to an angle and holds it there.
 *
 *      signal  ┌──┐                 ┌──┐
 *            ──┘  └─────────────────┘  └──   the length of the high pulse says the angle
 *              ↔ 0.5 … 2.5 ms = 0 … 180°
 *              ←──── about 20 ms ───→
 *
 * Sources: Tower Pro MG90S data sheet (the usual 9 g servo with metal gears: 0.1 s/60° at 4.8 V, period 20 ms, pulse
 * 1 … 2 ms nominal) and Tiger-Jython/Robotics-Libraries mbrobot_plusV2.py (duty 25 … 131 of 1023 at 20 ms for 0 … 180°,
 * that is 0.49 … 2.56 ms; so do the servos of the Maqueen kits).
 */
import type { Pwm, Wire } from '#board/wires/wire';
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Range of the arm. */
export const SERVO_RANGE_DEG = 180;

/**
 * How fast an arm turns, in degrees per second: 0.12 s for 60°. MG90S data sheet: 0.1 s at 4.8 V; chosen a fifth
 * slower, as the robots feed their servos from a battery of 3.7 … 4.5 V.
 */
export const SERVO_DEG_PER_S = 500;

const US_PER_S = 1_000_000;

/** The arm of one servo. */
export interface Servo {
  /** The present angle of the arm, 0 … 180. */
  readonly angleDeg: number;
  /** The angle it turns to, clamped to 0 … 180. */
  set(angleDeg: number): void;
  /** Advances by this much simulated time. */
  pass(us: number): void;
}

/** Makes a servo whose arm stands at `startDeg`, where it stays without a signal. */
export function createServo(startDeg: number): Servo {
  let target = clampAngle(startDeg);
  let angle = target;
  return {
    get angleDeg() {
      return angle;
    },
    set: (angleDeg) => {
      target = clampAngle(angleDeg);
    },
    pass: (us) => {
      const reach = (SERVO_DEG_PER_S * us) / US_PER_S;
      if (Math.abs(target - angle) <= reach) angle = target;
      else angle += target > angle ? reach : -reach;
    },
  };
}

/** Pulses of the two ends in µs. */
export interface PulseRange {
  readonly at0Us: number;
  readonly at180Us: number;
}

/** 0.5 ms = 0°, 2.5 ms = 180°: see the head of this file. */
export const USUAL_PULSES: PulseRange = { at0Us: 500, at180Us: 2500 };

/**
 * Periods that a servo follows, in µs: 33 … 400 pulses a second. Chosen: analog servos want about 50, digital ones are
 * sold for up to 333; a faster signal is a tone or the dimming of an LED and leaves the arm where it is.
 */
export const SERVO_PERIODS_US = { least: 2_500, most: 30_000 } as const;

/** Further options of a PWM servo. */
export interface PwmServoOptions {
  /** @default USUAL_PULSES */
  readonly pulses?: PulseRange;
  /**
   * With a clock the servo also follows pulses that a program makes itself, high and low by `write_digital`. One pulse
   * sets one new angle, whatever the pause before it.
   */
  readonly clock?: Clock;
}

/**
 * Reads the angle of a servo from a wire's pulses. Pulses beyond the two ends are clamped. A steady level, or PWM with
 * an unsuitable period, sets no angle: the arm stays where it is.
 *
 * @param onAngle called with 0 … 180 whenever the wire sets an angle
 * @returns lets go of the wire
 */
export function attachPwmServo(wire: Wire, onAngle: (angleDeg: number) => void, options: PwmServoOptions = {}): Stop {
  const { pulses = USUAL_PULSES, clock } = options;
  const hear = (pwm: Pwm | null): void => {
    const pulseUs = pwm === null ? null : pulseOf(pwm);
    if (pulseUs !== null) onAngle(angleOf(pulseUs, pulses));
  };
  const stops = [wire.onPwm(hear)];
  hear(wire.pwm);
  if (clock !== undefined) stops.push(onPulses(clock, wire, (pulseUs) => onAngle(angleOf(pulseUs, pulses))));
  return () => stops.forEach((stop) => stop());
}

/** Shortest and longest single pulse that counts, in µs. Chosen: outside it is a switch, not a signal for a servo. */
const SINGLE_PULSE_US = { least: 300, most: 3_000 } as const;

/**
 * Reports the length of each pulse that a program makes by hand. PWM is left out, because its mean may look like a
 * level.
 */
function onPulses(clock: Clock, wire: Wire, tell: (pulseUs: number) => void): Stop {
  let roseUs: number | null = null;
  return wire.onLevel((level) => {
    const lengthUs = roseUs === null ? 0 : clock.nowUs - roseUs;
    roseUs = level === 1 && wire.pwm === null ? clock.nowUs : null;
    if (level === 0 && lengthUs >= SINGLE_PULSE_US.least && lengthUs <= SINGLE_PULSE_US.most) tell(lengthUs);
  });
}

/** Length of the pulse in µs, or `null` if it is not a signal for a servo. */
function pulseOf({ periodUs, dutyFraction }: Pwm): number | null {
  if (!(periodUs >= SERVO_PERIODS_US.least && periodUs <= SERVO_PERIODS_US.most)) return null;
  return dutyFraction > 0 && dutyFraction < 1 ? periodUs * dutyFraction : null;
}

function angleOf(pulseUs: number, { at0Us, at180Us }: PulseRange): number {
  return clampAngle(((pulseUs - at0Us) / (at180Us - at0Us)) * SERVO_RANGE_DEG);
}

/** NaN, which no wire can carry, counts as 0. */
function clampAngle(angleDeg: number): number {
  return Math.min(Math.max(angleDeg, 0) || 0, SERVO_RANGE_DEG);
}
