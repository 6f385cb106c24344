import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { Gripper, GripperType } from '../chassis';
import type { BlockBody, Holder } from './block-body';
import { gapBetween } from './convex';
import type { Polygon } from './convex';
import type { Body, Fixture } from './planck';
import { EQUAL, NEAR, PushPlan } from './push-plan';
import { toUnits, UNITS_PER_MM, UNITS_PER_NEWTON } from './scale';
import { Kind, Solid, toWorld } from './solid';
import type { Thing } from './surroundings';
import type { Tool, ToolPlace } from './tool';

/** Maximum swing of the jaws in one step. Chosen: 10 rad/s, a little faster than small servos (60° in 0.12 s). */
const MAX_SWING_RAD = 0.04;

/** Shares of a step that are tried if the whole step is impossible. */
const SHARES = [1, 1 / 2, 1 / 4, 1 / 8, 1 / 16];
const LEAST = [1 / 16];

/** A block this close to both jaws, which can close no farther, is held. Chosen: NEAR and the least step at 60 mm. */
const GRIPPED = 0.6 * UNITS_PER_MM;

/** Maximum number of successive pushes until nothing is too close any more. */
const ROUNDS = 8;

/** A convex part of a jaw. */
interface JawPart {
  /** 0 = left jaw, 1 = right jaw. */
  readonly side: 0 | 1;
  readonly solid: Solid;
  /** About the hinge at swing 0, in units. */
  readonly corners: Polygon;
}

/** A part of a jaw, and a thing within its reach. */
interface Pair {
  readonly part: JawPart;
  readonly thing: Thing;
  /** The closest they may come: NEAR, or their present distance if they are closer already. */
  readonly allowed: number;
}

/**
 * A gripper: its jaws are parts of the robot's body that change their shape as they swing. Their possible swing is
 * found before each step of the engine: blocks are pushed aside without a speed, everything else stops the jaws. So
 * jaws never press on anything, and they never move the robot.
 */
export class GripperBody implements Gripper, Tool, Holder {
  readonly body: Body;
  private readonly place: ToolPlace;
  private readonly hinges: readonly [Vec, Vec];
  private readonly parts: readonly JawPart[];
  private readonly force: number;
  private held: BlockBody[] = [];
  private swing = 0;
  private target = 0;
  private wasSet = false;
  private isStuck = false;

  constructor(place: ToolPlace, type: GripperType) {
    this.place = place;
    this.body = place.body;
    this.force = type.forceN * UNITS_PER_NEWTON;
    const mirrored = ({ x, y }: Vec): Vec => ({ x, y: -y });
    const hinge = toUnits(type.hingeMm);
    this.hinges = [hinge, mirrored(hinge)];
    const left = type.jawMm.map((part) => part.map(toUnits));
    const right = left.map((part) => part.map(mirrored).reverse());
    this.parts = [
      ...left.map((corners) => this.makePart(0, corners)),
      ...right.map((corners) => this.makePart(1, corners)),
    ];
  }

  private makePart(side: 0 | 1, corners: Polygon): JawPart {
    const hinge = this.hinges[side];
    const solid = new Solid(
      this.body,
      corners.map(({ x, y }) => ({ x: hinge.x + x, y: hinge.y + y })),
      Kind.tool,
    );
    // The engine reorders them.
    return { side, solid, corners: solid.corners().map(({ x, y }) => ({ x: x - hinge.x, y: y - hinge.y })) };
  }

  setSwing(swingRad: number): void {
    if (!(swingRad >= 0)) return this.setSwing(0); // NaN too
    this.target = swingRad;
    if (this.wasSet) return;
    this.wasSet = true;
    this.swing = this.target;
    this.reshape();
  }

  swingRad(): number {
    return this.swing;
  }

  isHolding(): boolean {
    return this.held.some((block) => block.isHeldBy(this));
  }

  heightMm(): number {
    return 0;
  }

  letGone(block: Fixture): void {
    this.place.expectTouch(block);
  }

  readonly remove = (): void => {
    this.release();
    for (const { solid } of this.parts) solid.remove();
    this.place.drop(this);
  };

  solids(): readonly Solid[] {
    return this.parts.map(({ solid }) => solid);
  }

  beforeStep(): void {
    if (this.isHolding()) {
      if (this.target < this.swing) return; // the servo still presses
      this.release();
    }
    if (this.target === this.swing) return;
    const way = Math.min(Math.max(this.target - this.swing, -MAX_SWING_RAD), MAX_SWING_RAD);
    const aim = this.swing + way;
    const things = this.thingsNear(aim);
    const pairs = this.pairs(things);
    // Jaws that were stuck try a small swing first: its failure costs the least.
    for (const share of this.isStuck ? LEAST : SHARES) {
      const swing = share === 1 ? aim : this.swing + way * share;
      const plan = this.plan(swing, pairs);
      if (!plan) continue;
      plan.carryOut();
      this.swing = swing;
      this.reshape();
      this.isStuck = false;
      return;
    }
    this.isStuck = true;
    if (way < 0) this.grip(things);
  }

  blockPlaced(): void {
    // A block that the hand tool puts between the jaws waits there until they close.
  }

  private thingsNear(aim: number): Thing[] {
    const reach = [...this.outlinesAt(this.swing), ...this.outlinesAt(aim)];
    const { body } = this;
    return this.place.around.near(reach).filter(({ fixture }) => fixture.getBody() !== body);
  }

  private pairs(things: readonly Thing[]): Pair[] {
    const pairs: Pair[] = [];
    this.outlinesAt(this.swing).forEach((outline, i) => {
      const part = this.parts[i];
      if (!part) return;
      for (const thing of things) {
        if (!part.solid.shouldCollide(thing.fixture)) continue;
        pairs.push({ part, thing, allowed: Math.min(NEAR, gapBetween(outline, thing.outline).gap) });
      }
    });
    return pairs;
  }

  /** The pushes that let the jaws swing there; `null` if they cannot. */
  private plan(swing: number, pairs: readonly Pair[]): PushPlan | null {
    const plan = new PushPlan(this.place.around, (fixture) => this.parts.some(({ solid }) => solid.owns(fixture)));
    const force: [number, number] = [this.force, this.force];
    for (let round = 0; round < ROUNDS; round++) {
      let isClear = true;
      for (const { part, thing, allowed } of pairs) {
        const outline = toWorld(this.body, this.cornersAt(part, swing));
        const { gap, normal } = gapBetween(outline, plan.outlineOf(thing));
        if (gap >= allowed - EQUAL) continue;
        if (!thing.block || plan.isPinched(thing.block, normal)) return null;
        isClear = false;
        force[part.side] = plan.push(outline, thing, normal, allowed - gap, force[part.side]);
        if (force[part.side] < 0) return null;
      }
      if (isClear) return plan;
    }
    return null;
  }

  /** Holds what both jaws touch: one block, or a few that stand against each other. */
  private grip(things: readonly Thing[]): void {
    const jaws = this.outlinesAt(this.swing);
    const touches = (side: 0 | 1, { outline }: Thing): boolean =>
      this.parts.some((part, i) => part.side === side && isNear(jaws[i] ?? [], outline));
    const blocks = things.filter(({ block }) => block !== null);
    const leftOnes = blocks.filter((thing) => touches(0, thing));
    const rightOnes = blocks.filter((thing) => touches(1, thing));
    const linked = rightOnes.filter((right) => leftOnes.some((left) => isLinked(left, right, blocks)));
    const all = new Set([
      ...linked,
      ...leftOnes.filter((left) => linked.some((right) => isLinked(left, right, blocks))),
    ]);
    for (const { block } of all) {
      if (!block) continue;
      block.take(this);
      this.held.push(block);
    }
  }

  private release(): void {
    for (const block of this.held) if (block.isHeldBy(this)) block.release();
    this.held = [];
  }

  private reshape(): void {
    for (const part of this.parts) part.solid.reshape(this.cornersAt(part, this.swing));
    Solid.settle(this.body);
  }

  private outlinesAt(swing: number): Polygon[] {
    return this.parts.map((part) => toWorld(this.body, this.cornersAt(part, swing)));
  }

  /** Robot frame, units. */
  private cornersAt({ side, corners }: JawPart, swing: number): Polygon {
    const hinge = this.hinges[side];
    const cos = exactCos(swing);
    const sin = side === 0 ? exactSin(swing) : -exactSin(swing);
    return corners.map(({ x, y }) => ({ x: hinge.x + cos * x - sin * y, y: hinge.y + sin * x + cos * y }));
  }
}

const isNear = (a: Polygon, b: Polygon): boolean => gapBetween(a, b).gap < GRIPPED;

/** Whether two blocks are the same, or stand against each other, directly or with one more between them. */
function isLinked(a: Thing, b: Thing, blocks: readonly Thing[]): boolean {
  if (a.block === b.block || isNear(a.outline, b.outline)) return true;
  return blocks.some(({ outline }) => isNear(a.outline, outline) && isNear(outline, b.outline));
}
