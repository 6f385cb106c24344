import type { Polygon } from './convex';
import { circleOutline } from './form';
import { CircleShape, PolygonShape, Vec2 } from './planck';
import type { Body, Fixture } from './planck';

/** Robot against wall or block. Chosen: ABS on wood or plastic. */
export const CONTACT_FRICTION = 0.3;

/** The kind of a fixture, as bits of the engine's filter. Ordinary fixtures have the engine's own default, 1. */
export const Kind = { other: 1, movableBlock: 2, tool: 4 } as const;

const EVERYTHING = 0xffff;

/** A convex part of a robot's body that comes and goes without changing the body's mass and inertia. */
export class Solid {
  private readonly body: Body;
  readonly fixture: Fixture;
  private readonly shape: PolygonShape;
  private isThere = true;

  /**
   * @param corners robot frame, units
   * @param kind `tool`: its contacts with movable blocks are not collisions
   */
  constructor(body: Body, corners: Polygon, kind: number = Kind.other) {
    this.body = body;
    this.shape = new PolygonShape(corners.map(({ x, y }) => new Vec2(x, y)));
    this.fixture = body.createFixture({
      shape: this.shape,
      density: 0, // the engine then leaves the mass alone
      friction: CONTACT_FRICTION,
      filterCategoryBits: kind,
    });
    body.setAwake(true);
  }

  /** Robot frame, units, counter-clockwise. The same corners in the same order for its whole life. */
  corners(): Polygon {
    return this.shape.m_vertices;
  }

  owns(fixture: Fixture): boolean {
    return this.fixture === fixture;
  }

  shouldCollide(other: Fixture): boolean {
    return this.fixture.shouldCollide(other);
  }

  /** Moves its corners, one to one. Call `Solid.settle` once all solids of a body are in place. */
  reshape(corners: Polygon): void {
    const { m_vertices: vertices, m_normals: normals, m_centroid: middle } = this.shape;
    let x = 0;
    let y = 0;
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % corners.length] ?? corner;
      const normal = new Vec2(next.y - corner.y, corner.x - next.x);
      normal.normalize();
      vertices[i]?.setNum(corner.x, corner.y);
      normals[i]?.setVec2(normal);
      x += corner.x / corners.length;
      y += corner.y / corners.length;
    });
    middle.setNum(x, y);
  }

  /** Tells the engine that solids of a body have changed shape. */
  static settle(body: Body): void {
    body.synchronizeFixtures();
    body.setAwake(true);
  }

  /** Sets whether it collides with movable blocks or lets them through. */
  meetsBlocks(meets: boolean): void {
    this.fixture.setFilterData({
      groupIndex: 0,
      categoryBits: this.fixture.getFilterCategoryBits(),
      maskBits: meets ? EVERYTHING : EVERYTHING & ~Kind.movableBlock,
    });
    this.body.setAwake(true);
  }

  /** True if something presses against it, according to the last step. */
  isTouched(): boolean {
    if (!this.isThere) return false;
    for (let edge = this.body.getContactList(); edge; edge = edge.next) {
      const { contact } = edge;
      const own = contact.getFixtureA() === this.fixture || contact.getFixtureB() === this.fixture;
      if (own && contact.isTouching() && contact.isEnabled()) return true;
    }
    return false;
  }

  remove(): void {
    if (!this.isThere) return;
    this.isThere = false;
    // The engine computes a new mass from the remaining fixtures; the robot's was not made from its outline.
    const { body } = this;
    const mass = { mass: 0, center: new Vec2(0, 0), I: 0 };
    body.getMassData(mass);
    const velocity = Vec2.clone(body.getLinearVelocity());
    const spin = body.getAngularVelocity();
    const isAwake = body.isAwake();
    body.destroyFixture(this.fixture);
    body.setMassData(mass);
    body.setLinearVelocity(velocity);
    body.setAngularVelocity(spin);
    body.setAwake(isAwake);
  }
}

/** Outline of a fixture in the world frame, units; of a circle, which lies in its body's middle, a polygon near to it. */
export function outlineOf(fixture: Fixture): Polygon {
  const shape = fixture.getShape();
  if (shape instanceof CircleShape) return toWorld(fixture.getBody(), circleOutline(shape.m_radius));
  if (!(shape instanceof PolygonShape)) throw new TypeError('A fixture of the world is neither polygon nor circle.');
  return toWorld(fixture.getBody(), shape.m_vertices);
}

/** From a body's frame to the world's, units. */
export function toWorld(body: Body, corners: Polygon): Polygon {
  const { p, q } = body.getTransform();
  return corners.map(({ x, y }) => ({ x: p.x + q.c * x - q.s * y, y: p.y + q.s * x + q.c * y }));
}
