/**
 * Finds the traits with which the simulated robot drives as the measured one did. What was not measured, or cannot be
 * measured with a ruler, stays near the usual value: each trait has an expected spread that weighs against the errors
 * of a ruler.
 */
import type { RobotType } from '#robots/robot';
import { traitLimits, type MotorTraits, type Traits } from '#robots/traits';
import { leastSquares } from './least-squares';
import { DRIVES, ECHOES_MM, type Measured } from './my-robot';
import { predictMotion, type Motion } from './predict';

/** Expected errors of a measurement with ruler and protractor. Chosen: ± 5 mm, of which most are smaller. */
const RULER_MM = 3;
const TURN_DEG = 4;
/** Error of the ultrasonic sensor's reading, which most libraries round to a cm. */
const ECHO_MM = 4;

/** Usual traits of a robot's motors and their spread between robots. Chosen, as in `#simulation/reality`. */
const MOTORS = ['difference', 'charge', 'sag', 'friction'] as const;
const USUAL: MotorTraits = { difference: 0, charge: 1, sag: 0.04, friction: 0 };
const SPREAD: MotorTraits = { difference: 0.05, charge: 0.1, sag: 0.04, friction: 0.004 };
/** A change of each that moves the robot by some mm. */
const SMALL: MotorTraits = { difference: 0.01, charge: 0.02, sag: 0.02, friction: 0.002 };
const USUAL_ECHO = { offsetSpreadMm: 10, scaleSpread: 0.02 };

/** The traits of a robot of this type, fitted to what was measured of it. */
export async function fitTraits(measured: Measured, type: RobotType, firmware: WebAssembly.Module): Promise<Traits> {
  return {
    motors: await fitMotors(measured, type, firmware),
    ultrasonic: fitUltrasonic(measured),
    line: measured.line,
  };
}

async function fitMotors(measured: Measured, type: RobotType, firmware: WebAssembly.Module): Promise<MotorTraits> {
  const isMeasured = measured.turnDeg !== null || DRIVES.some((name) => measured.drives[name] !== null);
  if (!isMeasured) return { difference: 0, charge: 1, sag: 0, friction: 0 };
  const found = await leastSquares({
    start: MOTORS.map((key) => USUAL[key]),
    small: MOTORS.map((key) => SMALL[key]),
    residuals: async (numbers) => {
      const motors = motorsOf(numbers);
      const motion = await predictMotion({
        type,
        firmware,
        traits: { motors, ultrasonic: { offsetMm: 0, scale: 1 }, line: {} },
      });
      const unusual = MOTORS.map((key, index) => ((numbers[index] ?? 0) - USUAL[key]) / SPREAD[key]);
      return [...misses(measured, motion), ...unusual];
    },
  });
  return motorsOf(found);
}

/** The numbers as traits, within their limits and short enough for a link. */
function motorsOf(numbers: readonly number[]): MotorTraits {
  const [difference, charge, sag, friction] = MOTORS.map((key, index) => {
    const { min, max } = traitLimits[key];
    return Math.round(Math.min(Math.max(numbers[index] ?? 0, min), max) * 1e6) / 1e6;
  });
  return { difference: difference ?? 0, charge: charge ?? 1, sag: sag ?? 0, friction: friction ?? 0 };
}

/** The differences between a robot and the measurements, in units of the expected errors. */
function misses(measured: Measured, motion: Motion): readonly number[] {
  const drives = DRIVES.flatMap((name) => {
    const real = measured.drives[name];
    if (real === null) return [];
    const { aheadMm, leftMm } = motion.drives[name];
    return [(aheadMm - real.aheadMm) / RULER_MM, (leftMm - real.leftMm) / RULER_MM];
  });
  return measured.turnDeg === null ? drives : [...drives, (motion.turnDeg - measured.turnDeg) / TURN_DEG];
}

/** Offset and scale for which both readings, and what is usual, are missed least: a straight line. */
function fitUltrasonic({ echoesMm }: Measured): Traits['ultrasonic'] {
  const weight = 1 / (ECHO_MM * ECHO_MM);
  const { offsetSpreadMm, scaleSpread } = USUAL_ECHO;
  // Normal equations of the two numbers offset and scale − 1.
  let [oo, os, ss, o, s] = [1 / (offsetSpreadMm * offsetSpreadMm), 0, 1 / (scaleSpread * scaleSpread), 0, 0];
  for (const [index, trueMm] of ECHOES_MM.entries()) {
    const shownMm = echoesMm[index];
    if (shownMm === null || shownMm === undefined) continue;
    const off = shownMm - trueMm;
    oo += weight;
    os += weight * trueMm;
    ss += weight * trueMm * trueMm;
    o += weight * off;
    s += weight * off * trueMm;
  }
  const determinant = oo * ss - os * os;
  const { offsetMm, scale } = traitLimits;
  const bounded = (value: number, { min, max }: { readonly min: number; readonly max: number }): number =>
    Math.round(Math.min(Math.max(value, min), max) * 1e4) / 1e4;
  return {
    offsetMm: bounded((o * ss - s * os) / determinant, offsetMm),
    scale: bounded(1 + (s * oo - o * os) / determinant, scale),
  };
}
