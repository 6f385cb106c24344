/**
 * How the two wheels of a robot pull: a geared DC motor each, dry friction that is greatest at rest, and the scrub of
 * tyres and castor in curves.
 *
 * With duty D (0 … 1), speed v of the rim and F0 the pull of a blocked motor at full duty, a motor pulls with
 *
 *     F = F0 · ( D − (D + viscous) · v / v0 − dry(v) · sign v )
 *     dry(v) = coulomb + breakaway.share · (1 − |v| / (breakaway.until · v0)), the second term never below 0
 *
 * and the floor resists turning with a torque F0 · m · track, V being the mean speed of the wheels and Δ their
 * difference,
 *
 *     m = yawResistance · (V / v0)³ · Δ / √(Δ² + (0.1 · V)²)
 *
 * That torque acts like friction: it can cancel the difference of the wheels, never reverse it, and there is none in a
 * turn on the spot (V = 0). The last factor says that tyres give way a little before they scrub in full. In a steady
 * curve the wheels therefore run at v0 · (D − dry ∓ m) / (D + viscous), outer wheel minus, inner plus. Duty 0 shorts
 * the motor: it brakes like a motor at full duty whose supply is 0.
 *
 * Where the terms come from: docs/decisions/0013-a-motor-law-for-all-robots.md.
 */
export interface DriveLaw {
  /** Rim speed in mm/s that duty 1 would reach without any loss. */
  readonly v0MmPerS: number;
  /** Dry friction of motor and gear as a share of the stall force: the part that remains once the wheel turns fast. */
  readonly coulomb: number;
  /** Extra friction at the start: below the duty coulomb + share, a wheel stays still. Left out: none. */
  readonly breakaway?: Breakaway;
  /** Friction that grows with speed, as a share of the stall force at v0. */
  readonly viscous: number;
  /** Strength of the scrub in curves; no unit. */
  readonly yawResistance: number;
  /** Pull of one blocked motor at full duty, at the rim of its wheel, in newton. Decides what the robot can push. */
  readonly stallForceN: number;
  /** Time constant of the whole robot's speed at full duty, in seconds. The turning motors' own inertia follows from it. */
  readonly lagS: number;
}

/** Dry friction that a wheel loses as it speeds up: gears and brushes stick. */
export interface Breakaway {
  /** At rest, as a share of the stall force. */
  readonly share: number;
  /** Rim speed at which it has vanished, as a share of v0. */
  readonly until: number;
}

/**
 * Difference of the wheels, as a share of their mean speed, beyond which tyres and castor scrub nearly in full: circles of
 * ten tracks and less. Fitted: 0.1 serves all robots of docs/hardware; with less, circles of 1 m come out up to twice as wide.
 */
export const SCRUB_FULL_BEYOND = 0.1;
