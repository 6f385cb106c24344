import { exactCos, exactSin } from '#core/exact-math';
import type { Pose, Vec } from '#core/geometry';
import { rectangleCorners } from '../shapes';
import type { BlockHandle, BlockShape } from '../shapes';
import { BLOCK_FRICTION, FloorJoint } from './floor-joint';
import { PolygonShape, Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { GRAVITY, MM_PER_UNIT, toUnits, UNITS_PER_MM } from './scale';
import { Kind, Solid } from './solid';
import { moveBody } from './solver-body';

/** A wooden block of 5 × 5 cm weighs 40 g (chosen: beech cube cut to 25 mm height); others by their area. */
const BLOCK_G_PER_MM2 = 40 / 2500;

/** Block against block, wall or robot. Chosen: like the robot against walls. */
const BLOCK_CONTACT_FRICTION = 0.3;

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

/** How a block is held: as a part of the robot's body. Its own body waits aside. */
interface Hold {
  readonly by: Holder;
  readonly solid: Solid;
  /** In the robot's frame. */
  readonly at: Place;
}

/** A block's body. It lies still by the friction of the floor until something pushes or takes it, or it is fixed. */
export class BlockBody implements BlockHandle {
  /** About its middle, counter-clockwise. */
  readonly cornersMm: readonly Vec[];
  /** About its middle, counter-clockwise, in units. */
  readonly corners: readonly Vec[];
  /** Friction force of the floor, in the engine's unit of force. */
  readonly drag: number;
  /** Mean distance of its area from its middle, in units: the lever of the floor's friction in a turn. */
  readonly meanRadius: number;
  readonly body: Body;
  readonly fixture: Fixture;
  private readonly joint: FloorJoint | null;
  private readonly onPlaced: () => void;
  private hold: Hold | null = null;

  /** @param onPlaced called after the hand tool has put it somewhere */
  constructor(world: PlanckWorld, floor: Body, block: BlockShape, onPlaced: () => void) {
    if (!(block.sizeMm.x > 0 && block.sizeMm.y > 0)) {
      throw new RangeError(`A block needs sides above 0 mm, not ${block.sizeMm.x} × ${block.sizeMm.y}.`);
    }
    this.onPlaced = onPlaced;
    this.cornersMm = rectangleCorners(block.sizeMm);
    this.corners = this.cornersMm.map(toUnits);
    this.meanRadius = meanRadiusMm(block.sizeMm) * UNITS_PER_MM;
    this.body = world.createBody({
      type: block.fixed ? 'static' : 'dynamic',
      position: toUnits(block.atMm),
      angle: block.angleRad,
    });
    this.fixture = this.body.createFixture({
      shape: new PolygonShape(this.cornersMm.map(toUnits)),
      density: BLOCK_G_PER_MM2 * MM_PER_UNIT * MM_PER_UNIT,
      friction: BLOCK_CONTACT_FRICTION,
      filterCategoryBits: block.fixed ? Kind.other : Kind.movableBlock,
      userData: block.id,
    });
    this.drag = BLOCK_FRICTION * this.body.getMass() * GRAVITY;
    this.joint = block.fixed ? null : new FloorJoint(floor, this.body, this.meanRadius);
    if (this.joint) world.createJoint(this.joint);
  }

  get isMovable(): boolean {
    return this.joint !== null && this.hold === null;
  }

  pose(): Pose {
    const { x, y, angle } = this.at();
    return { xMm: x * MM_PER_UNIT, yMm: y * MM_PER_UNIT, headingRad: angle };
  }

  place(pose: Pose): void {
    this.release();
    this.body.setTransform(toUnits({ x: pose.xMm, y: pose.yMm }), pose.headingRad);
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
    this.hold = { by: holder, at, solid: new Solid(holder.body, turned(this.corners, at)) };
  }

  /** Lies on the floor again where it is, with the speed at which the robot carried it. */
  release(): void {
    if (!this.hold) return;
    const { by, solid } = this.hold;
    const { x, y, angle } = this.at();
    solid.remove();
    this.hold = null;
    moveBody(this.body, x, y, angle);
    this.body.setActive(true);
    this.body.setLinearVelocity(by.body.getLinearVelocityFromWorldPoint({ x, y }));
    this.body.setAngularVelocity(by.body.getAngularVelocity());
    by.letGone(this.fixture);
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

/** Mean distance of a rectangle's area from its middle, in mm, from a grid of 16 × 16 points. */
function meanRadiusMm(sizeMm: Vec): number {
  let sum = 0;
  for (let i = 0; i < 16; i++) {
    for (let j = 0; j < 16; j++) {
      const x = ((i + 0.5) / 16 - 0.5) * sizeMm.x;
      const y = ((j + 0.5) / 16 - 0.5) * sizeMm.y;
      sum += Math.sqrt(x * x + y * y);
    }
  }
  return sum / 256;
}
