import type { Pose, Vec } from '#core/geometry';
import type { MoverHandle, MoverShape, Way } from '../shapes';
import { STEP_S, STEP_US } from '../step';
import { gapBetween } from './convex';
import { engineShapes, formParts } from './form';
import { Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { toUnits, UNITS_PER_MM } from './scale';
import { CONTACT_FRICTION, outlineOf } from './solid';
import { placesAlong } from './way';

/**
 * A body pressed this far into a moving obstacle cannot yield any more, and the obstacle passes over it. Chosen: more
 * than the solver leaves of a push, less than half of the thinnest blocks and walls of usual courses.
 */
const JAMMED = 4 * UNITS_PER_MM;

/** The fixtures of a moving obstacle. Throws RangeError if a side or the speed is not above 0. */
export function moverFixtures(mover: MoverShape): readonly FixtureOf[] {
  const { id, sizeMm, speedMmPerS } = mover;
  if (!(sizeMm.x > 0 && sizeMm.y > 0 && speedMmPerS > 0))
    throw new RangeError(
      `A moving obstacle needs sides and a speed above 0, not ${sizeMm.x} × ${sizeMm.y} mm at ${speedMmPerS} mm/s.`,
    );
  return engineShapes(mover, formParts(mover)).map((shape) => ({ shape, userData: id }));
}

interface FixtureOf {
  readonly shape: ReturnType<typeof engineShapes>[number];
  readonly userData: string | undefined;
}

/**
 * A body that moves along its way and turns, whatever is in its path. Its pose follows from the time alone. The engine is
 * told its speed for each step, so that it pushes what it meets.
 */
export class MoverBody implements MoverHandle {
  readonly body: Body;
  private readonly mover: MoverShape;
  private readonly placeAfter: (steps: number) => Vec;
  private readonly velocity = new Vec2(0, 0);
  /** Speed of its outermost corner by its turning alone, in units per second. */
  private readonly rimSpeed: number;
  private steps = 0;

  constructor(world: PlanckWorld, mover: MoverShape, way: Way) {
    const fixtures = moverFixtures(mover);
    const { sizeMm, spinRadPerS } = mover;
    this.mover = mover;
    this.placeAfter = placesAlong(way, mover.speedMmPerS);
    this.rimSpeed = (Math.abs(spinRadPerS) * Math.sqrt(sizeMm.x * sizeMm.x + sizeMm.y * sizeMm.y) * UNITS_PER_MM) / 2;
    this.body = world.createBody({
      type: 'kinematic',
      position: toUnits(this.placeAfter(0)),
      angle: mover.angleRad,
      allowSleep: false, // it would not notice a body in its path
    });
    for (const fixture of fixtures) this.body.createFixture({ ...fixture, friction: CONTACT_FRICTION });
  }

  pose(): Pose {
    const { x, y } = this.placeAfter(this.steps);
    return { xMm: x, yMm: y, headingRad: this.angleAfter(this.steps) };
  }

  /** Gives it the speed from its pose in the engine to its next one, so that rounding errors do not add up. */
  beforeStep(): void {
    const now = this.body.getPosition();
    const to = this.placeAfter(this.steps + 1);
    this.velocity.setNum((to.x * UNITS_PER_MM - now.x) / STEP_S, (to.y * UNITS_PER_MM - now.y) / STEP_S);
    this.body.setLinearVelocity(this.velocity);
    if (this.mover.spinRadPerS !== 0)
      this.body.setAngularVelocity((this.angleAfter(this.steps + 1) - this.body.getAngle()) / STEP_S);
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
    const justMet = (Math.sqrt(dx * dx + dy * dy) + this.rimSpeed) * STEP_S;
    return gapBetween(outlineOf(own), outlineOf(other)).gap < -(JAMMED + justMet);
  }

  /** Its angle after this many steps of the world. */
  private angleAfter(steps: number): number {
    return this.mover.angleRad + (steps * STEP_US * this.mover.spinRadPerS) / 1_000_000;
  }
}
