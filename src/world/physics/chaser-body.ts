import type { Pose, Vec } from '#core/geometry';
import type { Chase, MoverHandle, MoverShape } from '../shapes';
import { STEP_S } from '../step';
import { moverFixtures } from './mover-body';
import { Vec2 } from './planck';
import type { Body, PlanckWorld } from './planck';
import { MM_PER_UNIT, toUnits, UNITS_PER_MM, UNITS_PER_NEWTON } from './scale';

/** Chosen: several times as heavy as the robots, which hardly move it by driving against it. */
const MASS_G = 1000;

/** How hard it drives. Chosen: it shoves a robot whose motors brake, and a wall stops it. */
const PUSH_N = 4;

/** How quickly it becomes faster or slower, in units/s². */
const ACCELERATION = (PUSH_N * UNITS_PER_NEWTON) / MASS_G;

/** A robot that it may chase. */
export interface Prey {
  pose(): Pose;
  /** Convex parts of all of it, with what it holds, world mm. */
  bodyMm(): readonly (readonly Vec[])[];
}

/**
 * A body that runs straight after the nearest robot. It is moved like others: walls and fixed blocks stop it, or it
 * slides along them without friction, for it looks for no way around; robots and blocks are pushed with limited force.
 * Only its own spin turns it.
 */
export class ChaserBody implements MoverHandle {
  private readonly body: Body;
  private readonly velocity = new Vec2(0, 0);
  /** Its place, or the place it returns to, while it chases nothing. */
  private rest: Vec | null;

  constructor(
    world: PlanckWorld,
    private readonly mover: MoverShape,
    private readonly chase: Chase,
  ) {
    const fixtures = moverFixtures(mover);
    this.rest = chase.homeMm;
    this.body = world.createBody({
      type: 'dynamic',
      position: toUnits(chase.homeMm),
      angle: mover.angleRad,
      fixedRotation: true,
      allowSleep: false, // it has to notice robots
    });
    for (const fixture of fixtures) this.body.createFixture({ ...fixture, density: 0, friction: 0 });
    this.body.setMassData({ mass: MASS_G, center: new Vec2(0, 0), I: 0 });
  }

  pose(): Pose {
    const { x, y } = this.place();
    return { xMm: x, yMm: y, headingRad: this.body.getAngle() };
  }

  /** Drives towards its goal, as far as its force allows. */
  beforeStep(robots: readonly Prey[]): void {
    const { x, y } = this.wishTowards(this.goal(robots));
    const now = this.body.getLinearVelocity();
    const [dx, dy] = [x - now.x, y - now.y];
    const change = Math.sqrt(dx * dx + dy * dy);
    const most = ACCELERATION * STEP_S;
    const share = change > most ? most / change : 1;
    this.velocity.setNum(now.x + share * dx, now.y + share * dy);
    this.body.setLinearVelocity(this.velocity);
    this.body.setAngularVelocity(this.mover.spinRadPerS);
  }

  /** The velocity at which it wants to go to a place, in units/s: it brakes in time and goes no farther. */
  private wishTowards(goalMm: Vec): Vec {
    const { x, y } = this.body.getPosition();
    const [dx, dy] = [goalMm.x * UNITS_PER_MM - x, goalMm.y * UNITS_PER_MM - y];
    const distance = Math.sqrt(dx * dx + dy * dy);
    if (distance === 0) return { x: 0, y: 0 };
    const braking = Math.sqrt(2 * ACCELERATION * distance);
    const speed = Math.min(this.mover.speedMmPerS * UNITS_PER_MM, braking, distance / STEP_S);
    return { x: (speed * dx) / distance, y: (speed * dy) / distance };
  }

  /** The middle of the axle of its robot; without one its home, or the place where it was when it lost the last one. */
  private goal(robots: readonly Prey[]): Vec {
    const prey = this.nearest(robots);
    if (prey !== null) {
      this.rest = null;
      return prey;
    }
    this.rest ??= this.chase.returns ? this.chase.homeMm : this.place();
    return this.rest;
  }

  /** The nearest robot that it runs after, and the first of those equally near. */
  private nearest(robots: readonly Prey[]): Vec | null {
    const { x, y } = this.place();
    let nearest: Vec | null = null;
    let leastSquared = this.chase.reachMm * this.chase.reachMm;
    for (const robot of robots) {
      const { xMm, yMm } = robot.pose();
      const squared = (xMm - x) * (xMm - x) + (yMm - y) * (yMm - y);
      const isNearer = nearest === null ? squared <= leastSquared : squared < leastSquared;
      if (!isNearer || this.chase.wants?.(robot.bodyMm()) === false) continue;
      nearest = { x: xMm, y: yMm };
      leastSquared = squared;
    }
    return nearest;
  }

  private place(): Vec {
    const { x, y } = this.body.getPosition();
    return { x: x * MM_PER_UNIT, y: y * MM_PER_UNIT };
  }
}
