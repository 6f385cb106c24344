import { exactCos, exactSin } from '#core/exact-math';
import type { ChassisType, Wheel, WheelSide } from '../chassis';
import { SCRUB_FULL_BEYOND } from '../drive-law';
import { Joint, Vec2 } from './planck';
import type { Body, TimeStep } from './planck';
import { DrivenWheel, type MotorLaw } from './driven-wheel';
import { GRAVITY, UNITS_PER_MM, UNITS_PER_NEWTON } from './scale';
import { solverBodyOf } from './solver-body';
import type { SolverBody } from './solver-body';

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
    const slope = stallForce / v0;
    const motor: MotorLaw = {
      // lag = (mass + 2 rim masses) / (2 slopes of the force), solved for the rim's mass
      rimMass: Math.max(slope * (1 + drive.viscous) * drive.lagS - mass / 2, 0),
      slope,
      viscous: drive.viscous,
      dryForce: stallForce * drive.coulomb,
      breakawayForce: stallForce * (drive.breakaway?.share ?? 0),
      breakawaySpeed: v0 * (drive.breakaway?.until ?? 1),
    };
    const track = (left.atMm.y - right.atMm.y) * UNITS_PER_MM;
    this.scrubPerSpeed3 = (stallForce * drive.yawResistance * track) / (v0 * v0 * v0);
    const castorShare = type.castorMm ? type.centreOfMassMm.x / type.castorMm.x : 0;
    const weightPerWheel = (mass * GRAVITY * (1 - castorShare)) / 2;
    // A stronger motor pulls more and turns faster by the same factor; the friction of its gear stays the same.
    const wheel = ({ atMm, gripMu }: Wheel, strength: number): DrivenWheel => {
      const y = atMm.y * UNITS_PER_MM;
      const response = this.inverseMass + (y * y) / this.inertia;
      return new DrivenWheel(motor, y, response, gripMu * weightPerWheel, stallForce * strength);
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
    return left.isMoving || right.isMoving;
  }

  /** Stops the wheels and forgets the impulses of the last step, after the body was moved by hand. */
  forget(): void {
    for (const wheel of this.wheels) wheel.forget();
    this.scrub = 0;
  }

  override initVelocityConstraints(step: TimeStep): void {
    const [left, right] = this.wheels;
    const { w } = this.solved.c_velocity;
    // The heading in the middle of the step: curves then keep their radius to second order.
    const heading = this.solved.c_position.a + 0.5 * step.dt * w;
    this.cos = exactCos(heading);
    this.sin = exactSin(heading);
    left.prepare(step.dt);
    right.prepare(step.dt);
    this.maxScrub = this.scrubTorque(Math.abs(left.rim + right.rim) / 2, Math.abs(left.rim - right.rim)) * step.dt;
    this.push(left.impulse, right.impulse, left.side + right.side, this.scrub);
  }

  /** Maximum resistance of tyres and castor to a turn at this mean speed and this difference of the wheels. */
  private scrubTorque(mean: number, difference: number): number {
    if (difference === 0) return 0;
    const full = SCRUB_FULL_BEYOND * mean;
    const builtUp = difference / Math.sqrt(difference * difference + full * full);
    return this.scrubPerSpeed3 * mean * mean * mean * builtUp;
  }

  override solveVelocityConstraints(): void {
    const [left, right] = this.wheels;
    const velocity = this.solved.c_velocity;
    const twist = clamp(this.scrub - velocity.w * this.inertia, this.maxScrub) - this.scrub;
    this.scrub += twist;
    velocity.w += twist / this.inertia;

    // Both wheels, lengthwise and sideways, from the same state, so that equal duties stay equal to the last bit.
    const forward = velocity.v.x * this.cos + velocity.v.y * this.sin;
    const sideways = velocity.v.y * this.cos - velocity.v.x * this.sin;
    const halfSide = sideways / this.inverseMass / 2;
    const [leftBefore, rightBefore] = [left.impulse, right.impulse];
    const sideBefore = left.side + right.side;
    left.speed = forward - left.y * velocity.w;
    right.speed = forward - right.y * velocity.w;
    left.halfSide = halfSide;
    right.halfSide = halfSide;
    left.solve();
    right.solve();
    this.push(left.impulse - leftBefore, right.impulse - rightBefore, left.side + right.side - sideBefore, 0);
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
      if (isAwake) wheel.settle();
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

const clamp = (value: number, limit: number): number => (value > limit ? limit : value < -limit ? -limit : value);
