import type { Pose, Vec } from '#core/geometry';
import type { Chassis, ChassisPart, ChassisType, ForkType, GripperType, Stance, WheelSide } from '../chassis';
import { STEP_S, STEP_US } from '../step';
import { DriveJoint } from './drive-joint';
import { ForkBody } from './fork-body';
import { GripperBody } from './gripper-body';
import { Lodged } from './lodged';
import { skipWhileNear } from './near-proxy';
import { PolygonShape, Vec2 } from './planck';
import type { Body, Fixture, PlanckWorld } from './planck';
import { MM_PER_UNIT, toUnits, UNITS_PER_MM } from './scale';
import { CONTACT_FRICTION, Kind, Solid } from './solid';
import type { Surroundings } from './surroundings';
import type { Tool, ToolPlace } from './tool';

/** A touch that begins within this many steps after the last one of the same thing is the same collision. Chosen: 0.1 s. */
const SAME_COLLISION_STEPS = 25;

/** A duty that was set for a moment after the end of the present step. */
interface LaterDuty {
  readonly wheel: WheelSide;
  readonly duty: number;
  readonly atUs: number;
}

interface Touch {
  /** Number of the robot's convex parts that touch it now. */
  parts: number;
  lastStep: number;
}

/** A robot's body with its drive, and the totals of its movement. */
export class RobotBody implements Chassis {
  private readonly body: Body;
  private readonly joint: DriveJoint;
  private readonly type: ChassisType;
  /** By one fixture of the thing (`thingOf`). */
  private readonly touches = new Map<Fixture, Touch>();
  private readonly parts = new Set<Solid>();
  private readonly tools = new Set<Tool>();
  private readonly toolPlace: ToolPlace;
  private readonly lodged: Lodged;
  /** Parts that were put somewhere since the last step. */
  private readonly placedAnew = new Set<Solid>();
  private steps = 0;
  private lastX: number;
  private lastY: number;
  private lastAngle: number;
  private path = 0;
  private turned = 0;
  private collisionCount = 0;
  private readonly wheelTurn: [number, number] = [0, 0];
  private readonly wheelDuty: [number, number] = [0, 0];
  /** Duties acting on the motors now, while `wheelDuty` may be ahead of them. */
  private readonly acting: [number, number] = [0, 0];
  private later: LaterDuty[] = [];
  private battery: (left: number, right: number) => number = () => 1;
  private readonly nowUs: (() => number) | null;

  /** @param nowUs time of the clock by which the duties are set; left out: each is set between two steps */
  constructor(
    world: PlanckWorld,
    floor: Body,
    around: Surroundings,
    type: ChassisType,
    pose: Pose,
    nowUs?: () => number,
  ) {
    this.type = type;
    this.nowUs = nowUs ?? null;
    this.body = createBody(world, type, pose);
    this.lodged = new Lodged(this.body, around);
    this.toolPlace = {
      body: this.body,
      around,
      expectTouch: (fixture) => this.expectTouch(fixture),
      drop: (tool) => {
        this.tools.delete(tool);
        for (const solid of tool.solids()) this.forget(solid);
      },
    };
    this.joint = new DriveJoint(floor, this.body, type);
    world.createJoint(this.joint);
    this.lastX = this.body.getPosition().x;
    this.lastY = this.body.getPosition().y;
    this.lastAngle = this.body.getAngle();
  }

  owns(body: Body): boolean {
    return this.body === body;
  }

  /** Convex parts of all of it, with what was added and what it holds, world mm. */
  bodyMm(): readonly (readonly Vec[])[] {
    return [...this.type.outlineMm, ...this.addedMm()].map((part) => part.map((corner) => this.toWorld(corner)));
  }

  pose(): Pose {
    const { x, y } = this.body.getPosition();
    return { xMm: x * MM_PER_UNIT, yMm: y * MM_PER_UNIT, headingRad: this.body.getAngle() };
  }

  place(pose: Pose): void {
    this.body.setTransform(toUnits({ x: pose.xMm, y: pose.yMm }), pose.headingRad);
    this.body.setLinearVelocity(new Vec2(0, 0));
    this.body.setAngularVelocity(0);
    this.joint.forget();
    this.lastX = this.body.getPosition().x;
    this.lastY = this.body.getPosition().y;
    this.lastAngle = this.body.getAngle();
    this.blockPlaced();
    for (const solid of this.solids()) this.placedAnew.add(solid);
  }

  setDuty(wheel: WheelSide, wanted: number): void {
    const duty = Math.min(Math.max(wanted, -1), 1);
    this.wheelDuty[wheel] = duty;
    const atUs = this.nowUs?.() ?? this.stepBeganUs;
    if (atUs - this.stepBeganUs >= STEP_US) this.later.push({ wheel, duty, atUs });
    else this.act(wheel, duty, atUs);
  }

  duty(wheel: WheelSide): number {
    return this.wheelDuty[wheel];
  }

  setBattery(supply: (left: number, right: number) => number): void {
    this.battery = supply;
    this.act(0, this.acting[0], this.stepBeganUs);
  }

  private get stepBeganUs(): number {
    return this.steps * STEP_US;
  }

  /** Sets a motor; what it draws changes the supply of both. */
  private act(wheel: WheelSide, duty: number, atUs: number): void {
    this.acting[wheel] = duty;
    const [left, right] = this.acting;
    const supply = this.battery(left, right);
    const share = Math.max(atUs - this.stepBeganUs, 0) / STEP_US; // a device's clock may be 1 µs behind at a step
    this.joint.setDuty(0, left * supply, share);
    this.joint.setDuty(1, right * supply, share);
  }

  /** Sets what was set for a moment of the step that begins. */
  private actLater(): void {
    const due = this.later;
    this.later = [];
    for (const change of due) {
      if (change.atUs - this.stepBeganUs >= STEP_US) this.later.push(change);
      else this.act(change.wheel, change.duty, change.atUs);
    }
  }

  wheelSpeedMmPerS(wheel: WheelSide): number {
    return this.joint.rimSpeed(wheel) * MM_PER_UNIT;
  }

  wheelTurnRad(wheel: WheelSide): number {
    return this.wheelTurn[wheel];
  }

  turnedRad(): number {
    return this.turned;
  }

  pathMm(): number {
    return this.path * MM_PER_UNIT;
  }

  collisions(): number {
    return this.collisionCount;
  }

  touching(): (string | null)[] {
    const ids: (string | null)[] = [];
    for (const [fixture, { parts }] of this.touches) {
      const id = fixture.getUserData();
      if (parts > 0) ids.push(typeof id === 'string' ? id : null);
    }
    return ids;
  }

  isTouching(other: Chassis): boolean {
    if (!(other instanceof RobotBody)) return false;
    for (const [fixture, { parts }] of this.touches) if (parts > 0 && other.owns(fixture.getBody())) return true;
    return false;
  }

  toWorld(point: Vec, { x, y, sin, cos } = this.stance()): Vec {
    const own = toUnits(point);
    // As the engine does it, to the last bit.
    return {
      x: (cos * own.x - sin * own.y + x) * MM_PER_UNIT,
      y: (sin * own.x + cos * own.y + y) * MM_PER_UNIT,
    };
  }

  stance(): Stance {
    const { p, q } = this.body.getTransform();
    return { x: p.x, y: p.y, sin: q.s, cos: q.c };
  }

  addPart(outlineMm: readonly Vec[]): ChassisPart {
    const solid = new Solid(this.body, outlineMm.map(toUnits));
    this.parts.add(solid);
    this.lodged.note([solid]);
    return {
      isTouched: () => solid.isTouched() || this.lodged.has(solid),
      remove: () => {
        this.parts.delete(solid);
        this.forget(solid);
        solid.remove();
      },
    };
  }

  addGripper(type: GripperType): GripperBody {
    return this.mount(new GripperBody(this.toolPlace, type));
  }

  addFork(type: ForkType): ForkBody {
    return this.mount(new ForkBody(this.toolPlace, type));
  }

  /** Its shape may still change before the next step. */
  private mount<T extends Tool>(tool: T): T {
    this.tools.add(tool);
    for (const solid of tool.solids()) this.placedAnew.add(solid);
    return tool;
  }

  private forget(solid: Solid): void {
    this.placedAnew.delete(solid);
    this.lodged.drop(solid);
  }

  private solids(): Solid[] {
    return [...this.parts, ...[...this.tools].flatMap((tool) => tool.solids())];
  }

  /** Outlines of everything that was added to the body, as they are now: robot frame, mm. */
  addedOutlinesMm(): Vec[][] {
    return this.solids().map((solid) =>
      solid.corners().map(({ x, y }) => ({ x: x * MM_PER_UNIT, y: y * MM_PER_UNIT })),
    );
  }

  addedMm(): Vec[][] {
    const outlines: Vec[][] = [];
    for (let fixture = this.body.getFixtureList(); fixture; fixture = fixture.getNext()) {
      const shape = fixture.getShape();
      if (shape instanceof PolygonShape)
        outlines.push(shape.m_vertices.map(({ x, y }) => ({ x: x * MM_PER_UNIT, y: y * MM_PER_UNIT })));
    }
    // The engine has the newest first, and those of the type at the end.
    return outlines.slice(0, -this.type.outlineMm.length);
  }

  /** Call it after the hand tool has moved a block. */
  blockPlaced(): void {
    for (const tool of this.tools) tool.blockPlaced();
  }

  beforeStep(): void {
    if (this.joint.isMoving()) this.body.setAwake(true);
    for (const tool of this.tools) tool.beforeStep();
    if (this.placedAnew.size === 0) return;
    this.lodged.note(this.placedAnew);
    this.placedAnew.clear();
  }

  /** True if a fixture of this body has been inside another since it was put there, so that the two do not collide. */
  isLodged(own: Fixture, other: Fixture): boolean {
    return this.lodged.stillHolds(own, other);
  }

  afterStep(): void {
    this.steps++;
    this.joint.settle();
    if (this.later.length > 0) this.actLater();
    if (!this.body.isAwake()) return;
    const { x, y } = this.body.getPosition();
    const angle = this.body.getAngle();
    const dx = x - this.lastX;
    const dy = y - this.lastY;
    this.path += Math.sqrt(dx * dx + dy * dy);
    this.turned += angle - this.lastAngle;
    this.lastX = x;
    this.lastY = y;
    this.lastAngle = angle;
    const [left, right] = this.type.wheels;
    this.wheelTurn[0] += (this.wheelSpeedMmPerS(0) * STEP_S) / left.radiusMm;
    this.wheelTurn[1] += (this.wheelSpeedMmPerS(1) * STEP_S) / right.radiusMm;
  }

  /** A fixture of this body begins to touch one of another. */
  beginTouch(own: Fixture, other: Fixture): void {
    if (isWork(own, other)) return;
    const thing = thingOf(other);
    const touch = this.touches.get(thing);
    if (!touch) {
      this.touches.set(thing, { parts: 1, lastStep: this.steps });
      this.collisionCount++;
      return;
    }
    if (touch.parts === 0 && this.steps - touch.lastStep > SAME_COLLISION_STEPS) this.collisionCount++;
    touch.parts++;
  }

  /** The end of such a touch. */
  endTouch(own: Fixture, other: Fixture): void {
    this.lodged.forget(own, other);
    if (isWork(own, other)) return;
    const touch = this.touches.get(thingOf(other));
    if (!touch) return;
    touch.parts--;
    touch.lastStep = this.steps;
  }

  /** Call it when something is removed from the world. */
  forgetThing(other: Fixture): void {
    this.touches.delete(other);
  }

  private expectTouch(other: Fixture): void {
    const thing = thingOf(other);
    const parts = this.touches.get(thing)?.parts ?? 0;
    this.touches.set(thing, { parts, lastStep: this.steps });
  }
}

/** The fixture that stands for all of a block; of anything else the fixture itself. */
const thingOf = (fixture: Fixture): Fixture => (fixture.getBody().getUserData() as Fixture | null) ?? fixture;

/** True for a contact of jaws or forks with a movable block, which is their work and not a collision. */
const isWork = (own: Fixture, other: Fixture): boolean =>
  own.getFilterCategoryBits() === Kind.tool && other.getFilterCategoryBits() === Kind.movableBlock;

function createBody(world: PlanckWorld, type: ChassisType, pose: Pose): Body {
  const body = world.createBody({
    type: 'dynamic',
    position: toUnits({ x: pose.xMm, y: pose.yMm }),
    angle: pose.headingRad,
  });
  for (const part of type.outlineMm) {
    body.createFixture({ shape: new PolygonShape(part.map(toUnits)), density: 1, friction: CONTACT_FRICTION });
  }
  skipWhileNear(body);
  // Inertia of the outline about its own middle, for a mass of 1 g.
  const shape = { mass: 0, center: new Vec2(0, 0), I: 0 };
  body.getMassData(shape);
  const spread =
    (shape.I - shape.mass * (shape.center.x * shape.center.x + shape.center.y * shape.center.y)) / shape.mass;
  const own = type.inertiaGMm2 === undefined ? type.massG * spread : type.inertiaGMm2 * UNITS_PER_MM * UNITS_PER_MM;
  // The solver's centre of mass is the middle of the axle, with the inertia about it. The drive law was fitted to the
  // motion of the wheels, which already includes the effect of the centre's real place in curves. The real place still
  // decides which wheel carries how much weight.
  const centre = type.centreOfMassMm;
  const offset = (centre.x * centre.x + centre.y * centre.y) * UNITS_PER_MM * UNITS_PER_MM;
  body.setMassData({ mass: type.massG, center: new Vec2(0, 0), I: own + type.massG * offset });
  return body;
}
