/**
 * How the two wheels of a robot pull: a geared DC motor each, and the scrub of tyres and castor in curves.
 *
 * With duty D (0 … 1), speed v of the rim and F0 the pull of a blocked motor at full duty, a motor pulls with
 *
 *     F = F0 · ( D − (D + viscous) · v / v0 − coulomb · sign v )
 *
 * and the floor resists turning with a torque F0 · m · track, m = yawResistance · (V / v0)², V the mean speed of the wheels.
 * That torque acts like friction: it can cancel the difference of the wheels, never reverse it, and there is none in a
 * turn on the spot (V = 0). In a steady curve the wheels therefore run at v0 · (D − coulomb ∓ m) / (D + viscous), outer
 * wheel minus, inner plus. Duty 0 shorts the motor: it brakes like a motor at full duty whose supply is 0.
 */
export interface DriveLaw {
  /** Rim speed in mm/s that duty 1 would reach without any loss. */
  readonly v0MmPerS: number;
  /** Dry friction of motor and gear as a share of the stall force; below this duty a wheel stays still. */
  readonly coulomb: number;
  /** Friction that grows with speed, as a share of the stall force at v0. */
  readonly viscous: number;
  /** Strength of the scrub in curves; no unit. */
  readonly yawResistance: number;
  /** Pull of one blocked motor at full duty, at the rim of its wheel, in newton. Decides what the robot can push. */
  readonly stallForceN: number;
  /** Time constant of the whole robot's speed at full duty, in seconds. The turning motors' own inertia follows from it. */
  readonly lagS: number;
}
