import { gapBetween } from './convex';
import type { Body, Fixture } from './planck';
import { UNITS_PER_MM } from './scale';
import { Kind, outlineOf, toWorld } from './solid';
import type { Solid } from './solid';
import type { Surroundings } from './surroundings';

/** Two things that overlap by this much are inside each other. Chosen: more than any contact yields. */
export const OVERLAP = 2 * UNITS_PER_MM;

/**
 * Remembers which parts of a robot have been inside something since they were put there: a wall around the robot when
 * it was given a bumper, or the wall to which the hand tool has moved it. The engine would push such a part out at the
 * nearest side, which may be the wall's far one, and hold the robot there. So these two do not collide until the part
 * has come out.
 */
export class Lodged {
  private readonly body: Body;
  private readonly around: Surroundings;
  private readonly pairs = new Map<Fixture, Set<Fixture>>();

  constructor(body: Body, around: Surroundings) {
    this.body = body;
    this.around = around;
  }

  /** Finds what these parts are inside of. Movable blocks are left out: they are pushed aside. */
  note(solids: Iterable<Solid>): void {
    for (const solid of solids) {
      this.pairs.delete(solid.fixture);
      const outline = toWorld(this.body, solid.corners());
      for (const { fixture, outline: other } of this.around.near([outline])) {
        if (fixture.getBody() === this.body || fixture.getFilterCategoryBits() === Kind.movableBlock) continue;
        if (gapBetween(outline, other).gap < -OVERLAP) this.add(solid.fixture, fixture);
      }
    }
  }

  /** True if this part is inside something. */
  has({ fixture }: Solid): boolean {
    return this.pairs.has(fixture);
  }

  /** True if these two are still inside each other; once they are not, they collide from then on. */
  stillHolds(own: Fixture, other: Fixture): boolean {
    if (this.pairs.get(own)?.has(other) !== true) return false;
    if (gapBetween(outlineOf(own), outlineOf(other)).gap < -OVERLAP) return true;
    this.forget(own, other);
    return false;
  }

  /** Call it when they no longer touch. */
  forget(own: Fixture, other: Fixture): void {
    const others = this.pairs.get(own);
    others?.delete(other);
    if (others?.size === 0) this.pairs.delete(own);
  }

  /** Call it when the part is removed. */
  drop({ fixture }: Solid): void {
    this.pairs.delete(fixture);
  }

  private add(own: Fixture, other: Fixture): void {
    const others = this.pairs.get(own);
    if (others) others.add(other);
    else this.pairs.set(own, new Set([other]));
  }
}
