import type { Pose, Vec } from '#core/geometry';
import type { ChassisType } from '../chassis';
import { rectangleCorners } from '../shapes';
import type { BlockShape, MoverShape, WorldSize } from '../shapes';
import { STEP_S } from '../step';
import { BarrierBody } from './barrier-body';
import { BlockBody } from './block-body';
import { PlanckWorld, PolygonShape, Vec2 } from './planck';
import type { Body, Contact, Fixture } from './planck';
import { ChaserBody } from './chaser-body';
import { gapBetween } from './convex';
import { OVERLAP } from './lodged';
import { MoverBody } from './mover-body';
import { quietStep } from './quiet-step';
import { RobotBody } from './robot-body';
import { toUnits } from './scale';
import { CONTACT_FRICTION, Kind, outlineOf } from './solid';
import { createSurroundings } from './surroundings';
import { guarded } from './wall-guard';

// Rounds of the solver per step. Chosen: a train of five blocks is pushed without lag; more changes nothing visible.
const VELOCITY_ROUNDS = 12;
const POSITION_ROUNDS = 4;

/** Thickness of the wall around the arena, in mm; it is invisible. Chosen: enough to push anything back in. */
const EDGE_MM = 200;

/** Bodies that push each other. The rest of the world knows nothing else of the physics engine. */
export interface Physics {
  /** Adds something solid that never moves: a convex outline, counter-clockwise, world mm. */
  addFixture(cornersMm: readonly Vec[], id?: string): void;
  /** Adds an open barrier. */
  addBarrier(cornersMm: readonly Vec[], id?: string): BarrierBody;
  addBlock(block: BlockShape): BlockBody;
  /** Takes a block out of the world. */
  removeBlock(block: BlockBody): void;
  addMover(mover: MoverShape): MoverBody | ChaserBody;
  /** @param nowUs see `World.addChassis` */
  addRobot(type: ChassisType, pose: Pose, nowUs?: () => number): RobotBody;
  /** Moves all bodies on by one step of the world. */
  step(): void;
}

/** Makes an arena with a wall around its edge and nothing in it. */
export function createPhysics(size: WorldSize): Physics {
  const world = new PlanckWorld({ gravity: new Vec2(0, 0), allowSleep: true, continuousPhysics: false });
  // Two bodies: otherwise those joined to the floor would pass through the walls.
  const floor = world.createBody();
  const walls = world.createBody();
  const robots: RobotBody[] = [];
  const blocks = new Map<Body, BlockBody>();
  const movers: MoverBody[] = [];
  const chasers: ChaserBody[] = [];
  const barriers: BarrierBody[] = [];
  const around = createSurroundings(world, blocks);

  const forget = (fixture: Fixture): void => robots.forEach((robot) => robot.forgetThing(fixture));

  listen(world, robots, movers);

  const physics: Physics = {
    addFixture(cornersMm, id) {
      walls.createFixture({
        shape: new PolygonShape(cornersMm.map(toUnits)),
        friction: CONTACT_FRICTION,
        userData: id,
      });
    },
    addBarrier: (cornersMm, id) => added(barriers, new BarrierBody(world, around, cornersMm, id, forget)),
    addBlock(shape) {
      const block = new BlockBody(world, floor, shape, () => robots.forEach((robot) => robot.blockPlaced()));
      blocks.set(block.body, block);
      return block;
    },
    removeBlock(block) {
      blocks.delete(block.body);
      block.remove();
      block.fixtures.forEach(forget);
    },
    addMover(shape) {
      const { goes } = shape;
      if ('homeMm' in goes) return added(chasers, new ChaserBody(world, shape, goes));
      return added(movers, new MoverBody(world, shape, goes));
    },
    addRobot: (type, pose, nowUs) => added(robots, new RobotBody(world, floor, around, type, pose, nowUs)),
    step() {
      for (const barrier of barriers) barrier.beforeStep();
      for (const mover of movers) mover.beforeStep();
      for (const chaser of chasers) chaser.beforeStep(robots);
      for (const robot of robots) robot.beforeStep();
      moveOn(world, movers.length > 0 ? blocks.values() : []);
      for (const mover of movers) mover.afterStep();
      for (const robot of robots) robot.afterStep();
    },
  };
  for (const corners of edgeWalls(size)) physics.addFixture(corners);
  return physics;
}

/** Adds something to a list, and gives it back. */
function added<T>(list: T[], one: T): T {
  list.push(one);
  return one;
}

/** @param pressed blocks that a moving obstacle may press against a wall: nothing else is stronger than one */
function moveOn(world: PlanckWorld, pressed: Iterable<BlockBody>): void {
  if (quietStep(world, VELOCITY_ROUNDS)) return;
  guarded(pressed, () => world.step(STEP_S, VELOCITY_ROUNDS, POSITION_ROUNDS));
}

/** Reports to robots what they touch, and lets through what must not collide. */
function listen(world: PlanckWorld, robots: readonly RobotBody[], movers: readonly MoverBody[]): void {
  const robotOf = (body: Body): RobotBody | undefined => robots.find((robot) => robot.owns(body));
  world.on('begin-contact', (contact: Contact) => {
    const a = contact.getFixtureA();
    const b = contact.getFixtureB();
    robotOf(a.getBody())?.beginTouch(a, b);
    robotOf(b.getBody())?.beginTouch(b, a);
  });
  world.on('end-contact', (contact: Contact) => {
    const a = contact.getFixtureA();
    const b = contact.getFixtureB();
    robotOf(a.getBody())?.endTouch(a, b);
    robotOf(b.getBody())?.endTouch(b, a);
  });
  world.on('pre-solve', (contact: Contact) => {
    const a = contact.getFixtureA();
    const b = contact.getFixtureB();
    const isLodged = robotOf(a.getBody())?.isLodged(a, b) === true || robotOf(b.getBody())?.isLodged(b, a) === true;
    if (isLodged || isForkAcross(a, b) || isPassedOver(movers, a, b)) contact.setEnabled(false);
  });
}

/**
 * Whether a block reaches so far over or under a raised fork that it was there when the fork went up, or that the hand
 * tool put it there. Jaws have the kind of plates; they never come so close to a block by themselves.
 */
function isForkAcross(a: Fixture, b: Fixture): boolean {
  const kinds = a.getFilterCategoryBits() | b.getFilterCategoryBits();
  if (kinds !== (Kind.tool | Kind.movableBlock)) return false;
  return gapBetween(outlineOf(a), outlineOf(b)).gap < -OVERLAP;
}

/** True if one of the two is a moving obstacle that passes over the other. */
function isPassedOver(movers: readonly MoverBody[], a: Fixture, b: Fixture): boolean {
  return movers.some(
    (mover) =>
      (mover.body === a.getBody() && mover.isPassingOver(a, b)) ||
      (mover.body === b.getBody() && mover.isPassingOver(b, a)),
  );
}

/** The four walls around the arena: right, top, left, bottom. */
function edgeWalls({ widthMm, heightMm }: WorldSize): Vec[][] {
  const boxAt = (x: number, y: number, sizeMm: Vec): Vec[] =>
    rectangleCorners(sizeMm).map((corner) => ({ x: corner.x + x, y: corner.y + y }));
  const long = { x: EDGE_MM, y: heightMm + 2 * EDGE_MM };
  const wide = { x: widthMm + 2 * EDGE_MM, y: EDGE_MM };
  return [
    boxAt(widthMm + EDGE_MM / 2, heightMm / 2, long),
    boxAt(widthMm / 2, heightMm + EDGE_MM / 2, wide),
    boxAt(-EDGE_MM / 2, heightMm / 2, long),
    boxAt(widthMm / 2, -EDGE_MM / 2, wide),
  ];
}
