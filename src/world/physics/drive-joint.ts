import { exactCos, exactSin } from '#core/exact-math';
import type { ChassisType, Wheel, WheelSide } from '../chassis';
import { SCRUB_FULL_BEYOND } from '../drive-law';
import { Joint, Vec2 } from './planck';
import type { Body, TimeStep } from './planck';
import { Power } from './power';
import { GRAVITY, UNITS_PER_MM, UNITS_PER_NEWTON } from './scale';
import { solverBodyOf } from './solver-body';
import type { SolverBody } from './solver-body';

/** What a motor does in a step at one duty, and what its tyre then does. */
interface Stretch {
  /** Share of the step, 1 for all of it. */
  share: number;
  /** Impulse of the motor and inertia of the rim, as far as known before the step is solved. */
  push: number;
  /** Resistance to a change of the rim's speed: its inertia and the motor's braking. */
  stiffness: number;
  /** Maximum impulse of the dry friction in this step. */
  dry: number;
  /** Impulse on the floor in this step, if this duty held through all of it. */
  impulse: number;
}

/** One driven wheel inside the solver; lengths in units, masses in g. */
interface DrivenWheel {
  /** Distance from the middle of the axle along the robot's y. */
  readonly y: number;
  /** Change of the wheel's speed over ground per unit of its impulse. */
  readonly response: number;
  /** Maximum impulse per second that the tyre can transmit. */
  readonly grip: number;
  /** Pull of its motor when blocked, at full duty. */
  readonly stallForce: number;
  readonly power: Power;
  /** Speed of the rim. */
  rim: number;
  /** Impulse on the floor in this step, lengthwise and sideways. */
  impulse: number;
  side: number;
  /** For a step through which its duty stays the same. */
  readonly whole: Stretch;
  readonly alone: readonly Stretch[];
  /** One for each of its duties in this step. */
  stretches: readonly Stretch[];
}

/**
 * The drive of a robot: two motors, two tyres, and the scrub of tyres and castor (see DriveLaw), solved together with
 * the contacts of a step, so that pushing, stalling and sliding along walls follow from the same forces.
 *
 * Each wheel has its own speed and the inertia of its motor behind the gear. The floor holds rim and body together up
 * to the tyre's grip; beyond it the wheel slips. (It extends Joint because planck's solver accepts nothing else.)
 */
export class DriveJoint extends Joint {
  private readonly body: Body;
  private readonly solved: SolverBody;
  private readonly wheels: readonly [DrivenWheel, DrivenWheel];
  private readonly inverseMass: number;
  private readonly inertia: number;
  private readonly rimMass: number;
  private readonly dryForce: number;
  private readonly breakawayForce: number;
  private readonly breakawaySpeed: number;
  /** Loss of pull of a motor at full duty, per unit of speed. */
  private readonly slope: number;
  private readonly viscous: number;
  /** Torque of the scrub per cube of the mean speed. */
  private readonly scrubPerSpeed3: number;
  private scrub = 0;
  private maxScrub = 0;
  private cos = 1;
  private sin = 0;

  constructor(floor: Body, body: Body, type: ChassisType) {
    super({}, floor, body);
    const drive = type.drive;
    const [left, right] = type.wheels;
    const mass = body.getMass();
    this.body = body;
    this.solved = solverBodyOf(body);
    this.inverseMass = 1 / mass;
    this.inertia = body.getInertia();
    const v0 = drive.v0MmPerS * UNITS_PER_MM;
    const stallForce = drive.stallForceN * UNITS_PER_NEWTON;
    this.slope = stallForce / v0;
    this.viscous = drive.viscous;
    this.dryForce = stallForce * drive.coulomb;
    this.breakawayForce = stallForce * (drive.breakaway?.share ?? 0);
    this.breakawaySpeed = v0 * (drive.breakaway?.until ?? 1);
    // lag = (mass + 2 rim masses) / (2 slopes of the force), solved for the rim's mass
    this.rimMass = Math.max(this.slope * (1 + drive.viscous) * drive.lagS - mass / 2, 0);
    const track = (left.atMm.y - right.atMm.y) * UNITS_PER_MM;
    this.scrubPerSpeed3 = (stallForce * drive.yawResistance * track) / (v0 * v0 * v0);
    const castorShare = type.castorMm ? type.centreOfMassMm.x / type.castorMm.x : 0;
    const weightPerWheel = (mass * GRAVITY * (1 - castorShare)) / 2;
    // A stronger motor pulls more and turns faster by the same factor; the friction of its gear stays the same.
    const wheel = ({ atMm, gripMu }: Wheel, strength: number): DrivenWheel => {
      const y = atMm.y * UNITS_PER_MM;
      const response = this.inverseMass + (y * y) / this.inertia;
      const fixed = { y, response, grip: gripMu * weightPerWheel, stallForce: stallForce * strength };
      const whole = { share: 1, push: 0, stiffness: 0, dry: 0, impulse: 0 };
      return { ...fixed, power: new Power(), rim: 0, impulse: 0, side: 0, whole, alone: [whole], stretches: [whole] };
    };
    const [leftStrength, rightStrength] = type.strength ?? [1, 1];
    this.wheels = [wheel(left, leftStrength), wheel(right, rightStrength)];
  }

  /** Sets the duty of a motor, −1 … 1, when this share of the step (0 … 1) is over. */
  setDuty(side: WheelSide, duty: number, at: number): void {
    this.wheels[side].power.set(duty, at);
  }

  /** Speed of the rim in units/s. */
  rimSpeed(side: WheelSide): number {
    return this.wheels[side].rim;
  }

  /** Whether a motor drives or a wheel still turns. */
  isMoving(): boolean {
    const [left, right] = this.wheels;
    return left.power.isOn || right.power.isOn || left.rim !== 0 || right.rim !== 0;
  }

  /** Stops the wheels and forgets the impulses of the last step, after the body was moved by hand. */
  forget(): void {
    for (const wheel of this.wheels) {
      wheel.rim = 0;
      wheel.impulse = 0;
      wheel.side = 0;
    }
    this.scrub = 0;
  }

  override initVelocityConstraints(step: TimeStep): void {
    const [left, right] = this.wheels;
    const { w } = this.solved.c_velocity;
    // The heading in the middle of the step: curves then keep their radius to second order.
    const heading = this.solved.c_position.a + 0.5 * step.dt * w;
    this.cos = exactCos(heading);
    this.sin = exactSin(heading);
    this.prepare(left, step.dt);
    this.prepare(right, step.dt);
    this.maxScrub = this.scrubTorque(Math.abs(left.rim + right.rim) / 2, Math.abs(left.rim - right.rim)) * step.dt;
    this.push(left.impulse, right.impulse, left.side + right.side, this.scrub);
  }

  /**
   * Within a step in which its duty changes, a wheel comes out at the mean of what each duty alone would give, weighted
   * by time. So a change that comes a little later moves the robot a little farther, evenly, and it does not matter where
   * in a step a program begins.
   */
  private prepare(wheel: DrivenWheel, dt: number): void {
    if (wheel.power.isSteady) {
      const { whole } = wheel;
      this.prepareStretch(wheel, whole, wheel.power.duty, dt);
      if (wheel.power.duty * wheel.rim < 0) this.prepareReversal(wheel, dt);
      wheel.stretches = wheel.alone;
      return;
    }
    wheel.stretches = wheel.power.pieces().map(({ share, duty }) => {
      const stretch = { share, push: 0, stiffness: 0, dry: 0, impulse: wheel.impulse };
      this.prepareStretch(wheel, stretch, duty, dt);
      return stretch;
    });
  }

  private prepareStretch(wheel: DrivenWheel, stretch: Stretch, duty: number, dt: number): void {
    // A shorted motor (duty 0) brakes as strongly as one at full duty resists its own speed.
    const resisting = duty === 0 ? 1 : Math.abs(duty);
    stretch.push = this.rimMass * wheel.rim + wheel.stallForce * duty * dt;
    stretch.stiffness = this.rimMass + this.slope * (resisting + this.viscous) * dt;
    const sticking = Math.max(0, 1 - Math.abs(wheel.rim) / this.breakawaySpeed);
    stretch.dry = (this.dryForce + this.breakawayForce * sticking) * dt;
  }

  /**
   * A wheel that changes its direction within the step: up to then friction slows it down as the motor does, afterwards
   * it acts against the motor. Otherwise the moment of the change, within the step, would make a difference.
   */
  private prepareReversal({ rim, response, stallForce, power, whole }: DrivenWheel, dt: number): void {
    const pull = Math.abs(stallForce * power.duty) * dt;
    const before = (Math.abs(rim) * (this.rimMass + 1 / response)) / (pull + whole.dry);
    if (pull <= whole.dry || before >= 1) return;
    whole.push += Math.sign(rim) * whole.dry * (1 - 2 * before);
    whole.dry = 0;
  }

  /** Maximum resistance of tyres and castor to a turn at this mean speed and this difference of the wheels. */
  private scrubTorque(mean: number, difference: number): number {
    if (difference === 0) return 0;
    const full = SCRUB_FULL_BEYOND * mean;
    const builtUp = difference / Math.sqrt(difference * difference + full * full);
    return this.scrubPerSpeed3 * mean * mean * mean * builtUp;
  }

  override solveVelocityConstraints(step: TimeStep): void {
    const [left, right] = this.wheels;
    const velocity = this.solved.c_velocity;
    const twist = clamp(this.scrub - velocity.w * this.inertia, this.maxScrub) - this.scrub;
    this.scrub += twist;
    this.push(0, 0, 0, twist);

    // Both wheels, lengthwise and sideways, from the same state, so that equal duties stay equal to the last bit.
    const forward = velocity.v.x * this.cos + velocity.v.y * this.sin;
    const sideways = velocity.v.y * this.cos - velocity.v.x * this.sin;
    const halfSide = sideways / this.inverseMass / 2;
    const [leftBefore, rightBefore] = [left.impulse, right.impulse];
    const sideBefore = left.side + right.side;
    this.solveTyre(left, forward - left.y * velocity.w, halfSide, step.dt);
    this.solveTyre(right, forward - right.y * velocity.w, halfSide, step.dt);
    this.push(left.impulse - leftBefore, right.impulse - rightBefore, left.side + right.side - sideBefore, 0);
  }

  /** The impulse of a tyre on the body: the mean over the stretches of the step. */
  private solveTyre(wheel: DrivenWheel, speed: number, halfSide: number, dt: number): void {
    const withoutTyre = speed - wheel.response * wheel.impulse;
    const side = wheel.side - halfSide;
    const grip = wheel.grip * dt;
    wheel.impulse = 0;
    wheel.side = 0;
    for (const stretch of wheel.stretches) {
      const along = tyreImpulse(wheel, stretch, withoutTyre);
      // A sliding tyre rubs against the direction in which it slides: what it needs lengthwise is missing sideways.
      const needed = Math.sqrt(along * along + side * side);
      const given = needed > grip ? grip / needed : 1;
      stretch.impulse = along * given;
      wheel.impulse += stretch.share * stretch.impulse;
      wheel.side += stretch.share * side * given;
    }
  }

  private push(left: number, right: number, side: number, twist: number): void {
    const velocity = this.solved.c_velocity;
    const forward = (left + right) * this.inverseMass;
    const sideways = side * this.inverseMass;
    velocity.v.x += forward * this.cos - sideways * this.sin;
    velocity.v.y += forward * this.sin + sideways * this.cos;
    velocity.w += (twist - (left * this.wheels[0].y + right * this.wheels[1].y)) / this.inertia;
  }

  /** Call it after each step: the rims take the speed that motor and tyre gave them. */
  settle(): void {
    const isAwake = this.body.isAwake();
    if (!isAwake) this.forget();
    for (const wheel of this.wheels) {
      wheel.power.beginStep();
      if (!isAwake) continue;
      wheel.rim = 0;
      for (const stretch of wheel.stretches) wheel.rim += stretch.share * rimAfter(stretch);
    }
  }

  override solvePositionConstraints(): boolean {
    return true;
  }

  // The rest is required by planck's type; nothing here uses it.
  override getAnchorA(): Vec2 {
    return this.body.getPosition();
  }
  override getAnchorB(): Vec2 {
    return this.body.getPosition();
  }
  override getReactionForce(): Vec2 {
    return new Vec2(0, 0);
  }
  override getReactionTorque(): number {
    return 0;
  }
  override _reset(): void {
    this.forget();
  }
}

/**
 * Impulse that a tyre needs to make rim and floor equally fast. The motor's pull falls linearly with the unknown speed,
 * and its dry friction opposes it; hence the soft threshold.
 */
function tyreImpulse({ response }: DrivenWheel, { push, stiffness, dry }: Stretch, withoutTyre: number): number {
  const common = soften(push + withoutTyre / response, dry) / (stiffness + 1 / response);
  return (common - withoutTyre) / response;
}

/** Speed of the rim at the end of a step. */
const rimAfter = ({ push, impulse, dry, stiffness }: Stretch): number => soften(push - impulse, dry) / stiffness;

const clamp = (value: number, limit: number): number => (value > limit ? limit : value < -limit ? -limit : value);

/** Reduces the size of a value by `amount`, down to 0: the part of a push that dry friction leaves. */
const soften = (value: number, amount: number): number =>
  value > amount ? value - amount : value < -amount ? value + amount : 0;
