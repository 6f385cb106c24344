import { exactCos, exactSin } from '#core/exact-math';
import type { Pose, Vec } from '#core/geometry';
import type { BlockHandle, BlockShape } from '../shapes';
import { dragOn, FloorJoint } from './floor-joint';
import { centroidOf, engineShapes, formParts, meanRadiusMm } from './form';
import { Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { MM_PER_UNIT, toUnits, UNITS_PER_MM } from './scale';
import { Kind, Solid } from './solid';
import { moveBody } from './solver-body';

/** A wooden block of 5 × 5 cm weighs 40 g (chosen: beech cube cut to 25 mm height); others by their area. */
const BLOCK_G_PER_MM2 = 40 / 2500;

/** Block against block, wall or robot. Chosen: like the robot against walls. */
const BLOCK_CONTACT_FRICTION = 0.3;

/** A ball touches at a point, and jumps back with half of its speed. Chosen: a rubber or table tennis ball against wood. */
const BALL_CONTACT = { friction: 0.1, restitution: 0.5 };

/** The tool that holds blocks: a gripper or a fork. */
export interface Holder {
  /** The robot that carries it. */
  readonly body: Body;
  /** Height of the held blocks above the floor, mm. */
  heightMm(): number;
  /** A block was let go or taken away by hand: it is free again. */
  letGone(block: Fixture): void;
}

/** Position of a body, in units. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly angle: number;
}

/** A block that is held: a part of the robot's body, while its own body waits aside. */
interface Hold {
  readonly by: Holder;
  /** One for each part. */
  readonly solids: readonly Solid[];
  /** In the robot's frame. */
  readonly at: Place;
}

/** A block's body. It lies still by the friction of the floor until something pushes or takes it, or it is fixed. */
export class BlockBody implements BlockHandle {
  /** Its convex parts about its centroid, counter-clockwise, in units. */
  readonly parts: readonly (readonly Vec[])[];
  /** Friction force of the floor, in the engine's unit of force. */
  readonly drag: number;
  /** Mean distance of its area from its centroid, in units: the lever of the floor's friction in a turn. */
  readonly meanRadius: number;
  readonly body: Body;
  /** One for each part. */
  readonly fixtures: readonly Fixture[];
  /** From the middle of its shape to its centroid, in its own frame; they differ only for polygons. */
  private readonly offsetMm: Vec;
  private readonly joint: FloorJoint | null;
  private readonly onPlaced: () => void;
  private hold: Hold | null = null;

  /** @param onPlaced called after the hand tool has put it somewhere */
  constructor(world: PlanckWorld, floor: Body, block: BlockShape, onPlaced: () => void) {
    if (!(block.sizeMm.x > 0 && block.sizeMm.y > 0)) {
      throw new RangeError(`A block needs sides above 0 mm, not ${block.sizeMm.x} × ${block.sizeMm.y}.`);
    }
    this.onPlaced = onPlaced;
    const given = formParts(block);
    this.offsetMm = block.partsMm ? centroidOf(given) : { x: 0, y: 0 };
    const partsMm = block.partsMm ? given.map((part) => part.map((corner) => moved(corner, this.offsetMm, -1))) : given;
    this.parts = partsMm.map((part) => part.map(toUnits));
    this.meanRadius = meanRadiusMm(block, partsMm) * UNITS_PER_MM;
    const { x, y } = moved(block.atMm, this.offsetAt(block.angleRad), 1);
    this.body = world.createBody({
      type: block.fixed ? 'static' : 'dynamic',
      position: toUnits({ x, y }),
      angle: block.angleRad,
    });
    this.fixtures = engineShapes(block, partsMm).map((shape) =>
      this.body.createFixture({
        shape,
        density: BLOCK_G_PER_MM2 * MM_PER_UNIT * MM_PER_UNIT,
        friction: BLOCK_CONTACT_FRICTION,
        ...(block.rolls === true ? BALL_CONTACT : {}),
        filterCategoryBits: block.fixed ? Kind.other : Kind.movableBlock,
        userData: block.id,
      }),
    );
    this.body.setUserData(this.fixtures[0]);
    if (block.massG !== undefined) this.weigh(block.massG);
    this.drag = dragOn(block, this.body.getMass());
    this.joint = block.fixed ? null : new FloorJoint(floor, this.body, this.drag, this.meanRadius);
    if (this.joint) world.createJoint(this.joint);
  }

  /** Gives it another mass, spread evenly. Fixed blocks have none. */
  private weigh(massG: number): void {
    const now = this.body.getMass();
    if (!this.body.isDynamic()) return;
    for (const fixture of this.fixtures) fixture.setDensity((fixture.getDensity() * massG) / now);
    this.body.resetMassData();
  }

  get isMovable(): boolean {
    return this.joint !== null && this.hold === null;
  }

  pose(): Pose {
    const { x, y, angle } = this.at();
    const at = moved({ x: x * MM_PER_UNIT, y: y * MM_PER_UNIT }, this.offsetAt(angle), -1);
    return { xMm: at.x, yMm: at.y, headingRad: angle };
  }

  place(pose: Pose): void {
    this.release();
    const at = moved({ x: pose.xMm, y: pose.yMm }, this.offsetAt(pose.headingRad), 1);
    this.body.setTransform(toUnits(at), pose.headingRad);
    this.body.setLinearVelocity(new Vec2(0, 0));
    this.body.setAngularVelocity(0);
    this.joint?.forget();
    this.onPlaced();
  }

  isHeld(): boolean {
    return this.hold !== null;
  }

  liftMm(): number {
    return this.hold?.by.heightMm() ?? 0;
  }

  isHeldBy(holder: Holder): boolean {
    return this.hold?.by === holder;
  }

  /** Its position, in units. */
  at(): Place {
    if (!this.hold) {
      const { x, y } = this.body.getPosition();
      return { x, y, angle: this.body.getAngle() };
    }
    const { at, by } = this.hold;
    const { x, y } = by.body.getWorldPoint(at);
    return { x, y, angle: by.body.getAngle() + at.angle };
  }

  /** Moves it a little without giving it a speed, for slow pushes. */
  shove(to: Place): void {
    moveBody(this.body, to.x, to.y, to.angle);
  }

  /** Takes it out of the world, also from a robot that holds it. Do not use it afterwards. */
  remove(): void {
    this.release();
    this.body.getWorld().destroyBody(this.body);
  }

  /** Becomes a part of the robot's body; the robot's mass stays the same. A block that cannot be taken ignores it. */
  take(holder: Holder): void {
    if (!this.isMovable) return;
    const { x, y } = holder.body.getLocalPoint(this.body.getPosition());
    const at: Place = { x, y, angle: this.body.getAngle() - holder.body.getAngle() };
    this.body.setLinearVelocity(new Vec2(0, 0));
    this.body.setAngularVelocity(0);
    this.body.setActive(false);
    this.joint?.forget();
    this.hold = { by: holder, at, solids: this.parts.map((part) => new Solid(holder.body, turned(part, at))) };
  }

  /** Lies on the floor again where it is, with the speed at which the robot carried it. */
  release(): void {
    if (!this.hold) return;
    const { by, solids } = this.hold;
    const { x, y, angle } = this.at();
    for (const solid of solids) solid.remove();
    this.hold = null;
    moveBody(this.body, x, y, angle);
    this.body.setActive(true);
    this.body.setLinearVelocity(by.body.getLinearVelocityFromWorldPoint({ x, y }));
    this.body.setAngularVelocity(by.body.getAngularVelocity());
    for (const fixture of this.fixtures) by.letGone(fixture);
  }

  /** Its offset when it is turned so, in mm. */
  private offsetAt(angle: number): Vec {
    const { x, y } = this.offsetMm;
    if (x === 0 && y === 0) return this.offsetMm;
    const [cos, sin] = [exactCos(angle), exactSin(angle)];
    return { x: cos * x - sin * y, y: sin * x + cos * y };
  }
}

/** Corners given about a place's origin, turned and shifted there. */
export function turned(corners: readonly Vec[], { x, y, angle }: Place): Vec[] {
  const cos = exactCos(angle);
  const sin = exactSin(angle);
  return corners.map((corner) => ({
    x: x + cos * corner.x - sin * corner.y,
    y: y + sin * corner.x + cos * corner.y,
  }));
}

const moved = (place: Vec, by: Vec, times: 1 | -1): Vec =>
  by.x === 0 && by.y === 0 ? place : { x: place.x + times * by.x, y: place.y + times * by.y };
