import type { Vec } from '#core/geometry';
import { turned } from './block-body';
import type { BlockBody, Place } from './block-body';
import { gapBetween, touchPoint } from './convex';
import type { Gap, Polygon } from './convex';
import type { Fixture } from './planck';
import { UNITS_PER_MM } from './scale';
import { outlineOf } from './solid';
import type { Surroundings, Thing } from './surroundings';

/**
 * Things are moved up to this close to each other: inside the engine's skin (0.4 mm), so that they touch, and outside
 * what its solver corrects (0.3 mm), so that it does not push back.
 */
export const NEAR = 0.3 * UNITS_PER_MM;

/** Gaps smaller by less than this, 2 µm, count as equal. */
export const EQUAL = 1e-4;

/** Maximum number of blocks in a row that one push moves. */
const MAX_ROW = 5;

/** A block that is pushed more often than this in one plan counts as jammed. */
const MAX_PUSHES = 12;

/** A pushed block, as the plan has it. */
interface Moved {
  readonly place: Place;
  /** One for each of its parts. */
  readonly outlines: readonly Polygon[];
  /** Direction of the last push. */
  readonly normal: Vec;
}

/**
 * A plan of where a slow push would move blocks: tried first, then carried out as a whole or not at all.
 *
 * A pushed block slides and turns as the floor's dry friction lets it (force and torque on an ellipse, the usual model
 * of slow pushing); it takes the blocks before it along, and stops at everything else.
 */
export class PushPlan {
  private readonly around: Surroundings;
  /** True if a fixture is the one that pushes. */
  private readonly pushes: (fixture: Fixture) => boolean;
  private readonly moved = new Map<BlockBody, Moved>();

  constructor(around: Surroundings, pushes: (fixture: Fixture) => boolean) {
    this.around = around;
    this.pushes = pushes;
  }

  /** Outline of a thing in the plan. */
  outlineOf(thing: Thing): Polygon {
    return (thing.block && this.moved.get(thing.block)?.outlines[thing.part]) ?? thing.outline;
  }

  /** True if the plan has already pushed a block against this direction. */
  isPinched(block: BlockBody, normal: Vec): boolean {
    const before = this.moved.get(block)?.normal;
    return before !== undefined && before.x * normal.x + before.y * normal.y < 0;
  }

  /**
   * Pushes a block that an outline touches, and the blocks in front of it.
   *
   * @param by outline of the pushing body
   * @param normal direction of the push, length 1
   * @param force available force
   * @returns the remaining force, negative if something did not yield; the plan is then useless
   */
  push(by: Polygon, thing: Thing, normal: Vec, distance: number, force: number, row = 1): number {
    const { block } = thing;
    if (!block || row > MAX_ROW) return -1;
    const before = this.moved.get(block);
    const left = before ? force : force - block.drag;
    if (left < 0) return -1;
    const from = before?.place ?? block.at();
    const place = slide(from, touchPoint(by, this.outlineOf(thing), normal), normal, distance, block.meanRadius);
    const fromOutlines = before?.outlines ?? block.fixtures.map(outlineOf);
    const outlines = block.parts.map((part) => turned(part, place));
    this.moved.set(block, { place, outlines, normal });
    return this.clear(block, fromOutlines, outlines, left, row);
  }

  /** Pushes on the things that a block meets on its way from one place to another. */
  private clear(
    block: BlockBody,
    from: readonly Polygon[],
    to: readonly Polygon[],
    force: number,
    row: number,
  ): number {
    const [fixture] = block.fixtures;
    let left = force;
    for (const other of this.around.near(to)) {
      if (other.block === block || this.pushes(other.fixture)) continue;
      if (fixture === undefined || !other.fixture.shouldCollide(fixture)) continue;
      const allowed = Math.min(NEAR, nearestPart(from, this.outlineOf(other)).gap);
      // A block that turns as it yields may come closer at another corner.
      for (let push = 0; ; push++) {
        const { part, gap, normal } = nearestPart(to, this.outlineOf(other));
        if (gap >= allowed - EQUAL) break;
        if (push === MAX_PUSHES) return -1;
        left = this.push(part, other, normal, allowed - gap, left, row + 1);
        if (left < 0) return left;
      }
    }
    return left;
  }

  /** Puts the blocks where the plan has them. */
  carryOut(): void {
    for (const [block, { place }] of this.moved) block.shove(place);
  }
}

/** The part of a block that is nearest to an outline, and their gap. */
function nearestPart(parts: readonly Polygon[], outline: Polygon): Gap & { readonly part: Polygon } {
  const gaps = parts.map((part) => ({ part, ...gapBetween(part, outline) }));
  return gaps.reduce((least, one) => (one.gap < least.gap ? one : least));
}

/** The position of a body after a point of it was pushed this far along a normal. */
function slide(from: Place, at: Vec, normal: Vec, distance: number, meanRadius: number): Place {
  const lever = (at.x - from.x) * normal.y - (at.y - from.y) * normal.x;
  const turn = lever / (meanRadius * meanRadius);
  const way = distance / (1 + lever * turn);
  return { x: from.x + normal.x * way, y: from.y + normal.y * way, angle: from.angle + turn * way };
}
