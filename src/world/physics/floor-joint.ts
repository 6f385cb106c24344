import { Joint, Vec2 } from './planck';
import type { Body, TimeStep } from './planck';
import type { BlockShape } from '../shapes';
import { GRAVITY } from './scale';
import { solverBodyOf } from './solver-body';
import type { SolverBody } from './solver-body';

/** Block on floor. Source: wood on wood or plastic 0.2 … 0.5; chosen in between. */
const BLOCK_FRICTION = 0.3;

/** Ball on floor. Chosen: one on hard felt or lino; at 20 cm/s it rolls on for 10 cm. */
const ROLLING_FRICTION = 0.02;

/** Friction force of the floor on a block, in the engine's unit of force. */
export function dragOn({ friction, rolls }: Pick<BlockShape, 'friction' | 'rolls'>, mass: number): number {
  return (friction ?? (rolls === true ? ROLLING_FRICTION : BLOCK_FRICTION)) * mass * GRAVITY;
}

/**
 * Dry friction between a flat body and the floor it lies on, solved together with the contacts of a step.
 *
 * Planck's own FrictionJoint is not used: in 1.5.0 it compares its impulse with itself, so that the linear friction of
 * a step is only applied in the next one. (It extends Joint because planck's solver accepts nothing else.)
 */
export class FloorJoint extends Joint {
  private readonly body: Body;
  private readonly solved: SolverBody;
  private readonly maxForce: number;
  private readonly maxTorque: number;
  private impulseX = 0;
  private impulseY = 0;
  private twist = 0;

  /**
   * @param maxForce friction force of the floor on the sliding body
   * @param meanRadius mean distance of the body's area from its middle, in units: the lever of friction in a turn
   */
  constructor(floor: Body, body: Body, maxForce: number, meanRadius: number) {
    super({}, floor, body);
    this.body = body;
    this.solved = solverBodyOf(body);
    this.maxForce = maxForce;
    this.maxTorque = this.maxForce * meanRadius;
  }

  override initVelocityConstraints(): void {
    this.push(this.impulseX, this.impulseY, this.twist);
  }

  override solveVelocityConstraints(step: TimeStep): void {
    const { v, w } = this.solved.c_velocity;
    const maxTwist = this.maxTorque * step.dt;
    const twist = Math.min(Math.max(this.twist - w * this.body.getInertia(), -maxTwist), maxTwist);
    let x = this.impulseX - v.x * this.body.getMass();
    let y = this.impulseY - v.y * this.body.getMass();
    const size = Math.sqrt(x * x + y * y);
    const maxImpulse = this.maxForce * step.dt;
    if (size > maxImpulse) {
      x *= maxImpulse / size;
      y *= maxImpulse / size;
    }
    this.push(x - this.impulseX, y - this.impulseY, twist - this.twist);
    this.impulseX = x;
    this.impulseY = y;
    this.twist = twist;
  }

  override solvePositionConstraints(): boolean {
    return true;
  }

  /** Forgets the impulses of the last step, after the body was moved by hand. */
  forget(): void {
    this.impulseX = 0;
    this.impulseY = 0;
    this.twist = 0;
  }

  private push(x: number, y: number, twist: number): void {
    const velocity = this.solved.c_velocity;
    velocity.v.x += x / this.body.getMass();
    velocity.v.y += y / this.body.getMass();
    velocity.w += twist / this.body.getInertia();
  }

  // The rest is required by planck's type; nothing here uses it.
  override getAnchorA(): Vec2 {
    return this.body.getPosition();
  }
  override getAnchorB(): Vec2 {
    return this.body.getPosition();
  }
  override getReactionForce(perSecond: number): Vec2 {
    return new Vec2(this.impulseX * perSecond, this.impulseY * perSecond);
  }
  override getReactionTorque(perSecond: number): number {
    return this.twist * perSecond;
  }
  override _reset(): void {
    this.forget();
  }
}
