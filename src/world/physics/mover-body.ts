import type { Pose, Vec } from '#core/geometry';
import type { MoverHandle, MoverShape } from '../shapes';
import { STEP_S, STEP_US } from '../step';
import { gapBetween } from './convex';
import { engineShapes, formParts } from './form';
import { Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { toUnits, UNITS_PER_MM } from './scale';
import { CONTACT_FRICTION, outlineOf } from './solid';

/**
 * A body pressed this far into a moving obstacle cannot yield any more, and the obstacle passes over it. Chosen: more
 * than the solver leaves of a push, less than half of the thinnest blocks and walls of usual courses.
 */
const JAMMED = 4 * UNITS_PER_MM;

/**
 * A box that moves to and fro whatever is in its path. Its position follows from the time alone. The engine is told its
 * speed for each step, so that it pushes what it meets.
 */
export class MoverBody implements MoverHandle {
  readonly body: Body;
  private readonly mover: MoverShape;
  /** Length of one leg. */
  private readonly lengthMm: number;
  private readonly velocity = new Vec2(0, 0);
  private steps = 0;

  /** Throws RangeError if a side or the speed is not above 0. */
  constructor(world: PlanckWorld, mover: MoverShape) {
    const { sizeMm, speedMmPerS, atMm, toMm, angleRad } = mover;
    if (!(sizeMm.x > 0 && sizeMm.y > 0 && speedMmPerS > 0))
      throw new RangeError(
        `A moving obstacle needs sides and a speed above 0, not ${sizeMm.x} × ${sizeMm.y} mm at ${speedMmPerS} mm/s.`,
      );
    this.mover = mover;
    const [dx, dy] = [toMm.x - atMm.x, toMm.y - atMm.y];
    this.lengthMm = Math.sqrt(dx * dx + dy * dy);
    this.body = world.createBody({
      type: 'kinematic',
      position: toUnits(atMm),
      angle: angleRad,
      allowSleep: false, // it would not notice a body in its path
    });
    for (const shape of engineShapes(mover, formParts(mover)))
      this.body.createFixture({ shape, friction: CONTACT_FRICTION, userData: mover.id });
  }

  pose(): Pose {
    const { x, y } = this.placeAfter(this.steps);
    return { xMm: x, yMm: y, headingRad: this.mover.angleRad };
  }

  /** Gives it the speed from its position in the engine to its next position, so that rounding errors do not add up. */
  beforeStep(): void {
    const now = this.body.getPosition();
    const to = this.placeAfter(this.steps + 1);
    this.velocity.setNum((to.x * UNITS_PER_MM - now.x) / STEP_S, (to.y * UNITS_PER_MM - now.y) / STEP_S);
    this.body.setLinearVelocity(this.velocity);
  }

  afterStep(): void {
    this.steps++;
  }

  /**
   * Whether something is so deep inside that it must be jammed between this and a wall. Nothing stops this obstacle, so
   * it would press a jammed body through the wall. Instead it passes over the body, which is free again behind it.
   */
  isPassingOver(own: Fixture, other: Fixture): boolean {
    const mine = this.body.getLinearVelocity();
    const its = other.getBody().getLinearVelocity();
    const [dx, dy] = [mine.x - its.x, mine.y - its.y];
    // Two bodies that have just met overlap by at most one step's movement.
    const justMet = Math.sqrt(dx * dx + dy * dy) * STEP_S;
    return gapBetween(outlineOf(own), outlineOf(other)).gap < -(JAMMED + justMet);
  }

  /** Its middle after this many steps of the world, in mm. */
  private placeAfter(steps: number): Vec {
    const { atMm, toMm, speedMmPerS } = this.mover;
    if (this.lengthMm === 0) return atMm;
    const travelled = ((steps * STEP_US * speedMmPerS) / 1_000_000) % (2 * this.lengthMm);
    const share = (travelled <= this.lengthMm ? travelled : 2 * this.lengthMm - travelled) / this.lengthMm;
    return { x: atMm.x + share * (toMm.x - atMm.x), y: atMm.y + share * (toMm.y - atMm.y) };
  }
}
