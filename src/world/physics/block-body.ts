import type { Pose, Vec } from '#core/geometry';
import { rectangleCorners } from '../shapes';
import type { BlockHandle, BlockShape } from '../shapes';
import { FloorJoint } from './floor-joint';
import { PolygonShape, Vec2 } from './planck';
import type { Body, PlanckWorld } from './planck';
import { MM_PER_UNIT, toUnits, UNITS_PER_MM } from './scale';

/** A wooden block of 5 × 5 cm weighs 40 g (chosen: beech cube cut to 25 mm height); others by their area. */
const BLOCK_G_PER_MM2 = 40 / 2500;

/** Block against block, wall or robot. Chosen: like the robot against walls. */
const BLOCK_CONTACT_FRICTION = 0.3;

/** A block's body: lies still by the friction of the floor until something pushes it, or is fixed. */
export class BlockBody implements BlockHandle {
  /** About its middle, counter-clockwise. */
  readonly cornersMm: readonly Vec[];
  private readonly body: Body;
  private readonly joint: FloorJoint | null;

  constructor(world: PlanckWorld, floor: Body, block: BlockShape) {
    if (!(block.sizeMm.x > 0 && block.sizeMm.y > 0)) {
      throw new RangeError(`A block needs sides above 0 mm, not ${block.sizeMm.x} × ${block.sizeMm.y}.`);
    }
    this.cornersMm = rectangleCorners(block.sizeMm);
    this.body = world.createBody({
      type: block.fixed ? 'static' : 'dynamic',
      position: toUnits(block.atMm),
      angle: block.angleRad,
    });
    this.body.createFixture({
      shape: new PolygonShape(this.cornersMm.map(toUnits)),
      density: BLOCK_G_PER_MM2 * MM_PER_UNIT * MM_PER_UNIT,
      friction: BLOCK_CONTACT_FRICTION,
    });
    this.joint = block.fixed ? null : new FloorJoint(floor, this.body, meanRadiusMm(block.sizeMm) * UNITS_PER_MM);
    if (this.joint) world.createJoint(this.joint);
  }

  pose(): Pose {
    const { x, y } = this.body.getPosition();
    return { xMm: x * MM_PER_UNIT, yMm: y * MM_PER_UNIT, headingRad: this.body.getAngle() };
  }

  place(pose: Pose): void {
    this.body.setTransform(toUnits({ x: pose.xMm, y: pose.yMm }), pose.headingRad);
    this.body.setLinearVelocity(new Vec2(0, 0));
    this.body.setAngularVelocity(0);
    this.joint?.forget();
  }
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
