import { STEP_S } from '../step';
import { Power } from './power';

/** The motors of a robot behind their gears, in the solver's units; see `DriveLaw`. */
export interface MotorLaw {
  /** Inertia of motor and gear, as a mass at the rim. */
  readonly rimMass: number;
  /** Loss of pull at full duty, per unit of speed. */
  readonly slope: number;
  readonly viscous: number;
  readonly dryForce: number;
  readonly breakawayForce: number;
  readonly breakawaySpeed: number;
}

/** A motor at one duty during a part of a step, and its tyre after it. */
class Stretch {
  // Numbers with a point from the start: the engines of JavaScript would translate all of this once more when the first
  // one comes.
  /** Impulse of the motor and inertia of the rim, as far as known before the step is solved. */
  push = NaN;
  /** Resistance to a change of the rim's speed: its inertia and the motor's braking. */
  stiffness = NaN;
  /** Maximum impulse of the dry friction in this step. */
  dry = NaN;
  /** Impulse on the floor in this step, if this duty held through all of it. */
  impulse = NaN;

  /** @param share of the step, 1 for all of it */
  constructor(readonly share: number) {}

  prepare(motor: MotorLaw, rim: number, stallForce: number, duty: number, dt: number): void {
    // A shorted motor (duty 0) brakes as strongly as one at full duty resists its own speed.
    const resisting = duty === 0 ? 1 : Math.abs(duty);
    this.push = motor.rimMass * rim + stallForce * duty * dt;
    this.stiffness = motor.rimMass + motor.slope * (resisting + motor.viscous) * dt;
    const sticking = Math.max(0, 1 - Math.abs(rim) / motor.breakawaySpeed);
    this.dry = (motor.dryForce + motor.breakawayForce * sticking) * dt;
  }

  /**
   * Finds the tyre's impulse. A sliding tyre rubs against the direction in which it slides: what it needs lengthwise is
   * missing sideways.
   *
   * @returns the share of the wanted impulse that the grip lets through
   */
  solve(response: number, withoutTyre: number, side: number, grip: number): number {
    const along = this.wanted(response, withoutTyre);
    const needed = Math.sqrt(along * along + side * side);
    const given = needed > grip ? grip / needed : 1;
    this.impulse = along * given;
    return given;
  }

  /**
   * Impulse that a tyre needs to make rim and floor equally fast. The motor's pull falls linearly with the unknown speed,
   * and its dry friction opposes it; hence the soft threshold.
   */
  private wanted(response: number, withoutTyre: number): number {
    const common = soften(this.push + withoutTyre / response, this.dry) / (this.stiffness + 1 / response);
    return (common - withoutTyre) / response;
  }

  /** Speed of the rim at the end of the step. */
  rimAfter(): number {
    return soften(this.push - this.impulse, this.dry) / this.stiffness;
  }
}

/**
 * One driven wheel inside the solver; lengths in units, masses in g. It has its own speed. The floor holds rim and body
 * together up to the tyre's grip; beyond it the wheel slips.
 */
export class DrivenWheel {
  readonly power = new Power();
  /** Speed of the rim. */
  rim = 0;
  /** Impulse on the floor in this step, lengthwise and sideways. */
  impulse = 0;
  side = 0;
  // What a round of the solver begins with. Fields, because each argument with a point becomes an object of its own.
  /** Speed of the body at the wheel, lengthwise. */
  speed = NaN;
  /** Half of the impulse that would stop the body sideways. */
  halfSide = NaN;
  /** Length of the step in s. */
  private dt = NaN;
  /** For a step through which its duty stays the same. */
  private readonly whole = new Stretch(1);
  /** One for each of its duties in this step, where it has several. */
  private stretches: readonly Stretch[] | null = null;

  /**
   * @param y distance from the middle of the axle along the robot's y
   * @param response change of the wheel's speed over ground per unit of its impulse
   * @param grip maximum impulse per second that the tyre can transmit
   * @param stallForce pull of its motor when blocked, at full duty
   */
  constructor(
    private readonly motor: MotorLaw,
    readonly y: number,
    private readonly response: number,
    private readonly grip: number,
    private readonly stallForce: number,
  ) {
    this.prepare(STEP_S);
    this.whole.impulse = 0;
  }

  /** Whether its motor drives or it still turns. */
  get isMoving(): boolean {
    return this.power.isOn || this.rim !== 0;
  }

  /** Stops it and forgets the impulses of the last step. */
  forget(): void {
    this.rim = 0;
    this.impulse = 0;
    this.side = 0;
  }

  /**
   * Call it before a step is solved. Within a step in which its duty changes, a wheel comes out at the mean of what each
   * duty alone would give, weighted by time. So a change that comes a little later moves the robot a little farther,
   * evenly, and it does not matter where in a step a program begins.
   */
  prepare(dt: number): void {
    this.dt = dt;
    const { power, motor, rim, stallForce } = this;
    if (power.isSteady) {
      this.whole.prepare(motor, rim, stallForce, power.duty, dt);
      if (power.duty * rim < 0) this.prepareReversal(dt);
      this.stretches = null;
      return;
    }
    this.stretches = power.pieces().map(({ share, duty }) => {
      const stretch = new Stretch(share);
      stretch.prepare(motor, rim, stallForce, duty, dt);
      stretch.impulse = this.impulse;
      return stretch;
    });
  }

  /**
   * A wheel that changes its direction within the step: up to then friction slows it down as the motor does, afterwards
   * it acts against the motor. Otherwise the moment of the change, within the step, would make a difference.
   */
  private prepareReversal(dt: number): void {
    const { rim, response, whole } = this;
    const pull = Math.abs(this.stallForce * this.power.duty) * dt;
    const before = (Math.abs(rim) * (this.motor.rimMass + 1 / response)) / (pull + whole.dry);
    if (pull <= whole.dry || before >= 1) return;
    whole.push += Math.sign(rim) * whole.dry * (1 - 2 * before);
    whole.dry = 0;
  }

  /** Finds the impulse of the tyre on the body, the mean over the stretches of the step, from `speed` and `halfSide`. */
  solve(): void {
    const { response, stretches } = this;
    const withoutTyre = this.speed - response * this.impulse;
    const side = this.side - this.halfSide;
    const grip = this.grip * this.dt;
    if (stretches === null) {
      const given = this.whole.solve(response, withoutTyre, side, grip);
      this.impulse = this.whole.impulse;
      this.side = side * given;
      return;
    }
    this.impulse = 0;
    this.side = 0;
    for (const stretch of stretches) {
      const given = stretch.solve(response, withoutTyre, side, grip);
      this.impulse += stretch.share * stretch.impulse;
      this.side += stretch.share * side * given;
    }
  }

  /** Call it after a step: the rim takes the speed that motor and tyre gave it. */
  settle(): void {
    if (this.stretches === null) {
      this.rim = this.whole.rimAfter();
      return;
    }
    this.rim = 0;
    for (const stretch of this.stretches) this.rim += stretch.share * stretch.rimAfter();
  }
}

/** Reduces the size of a value by `amount`, down to 0: the part of a push that dry friction leaves. */
const soften = (value: number, amount: number): number =>
  value > amount ? value - amount : value < -amount ? value + amount : 0;
