import { gapBetween } from './convex';
import type { Body, Fixture } from './planck';
import { UNITS_PER_MM } from './scale';
import { Kind, outlineOf, toWorld } from './solid';
import type { Solid } from './solid';
import type { Surroundings } from './surroundings';

/** Two things that reach this far into each other stand in each other. Chosen: more than any contact gives way. */
export const OVERLAP = 2 * UNITS_PER_MM;

/**
 * What parts of a robot stand in since they were put there: a wall in which the robot stood when it was given a bumper, or
 * to which the hand has moved it. The engine would push such a part out at the nearest side, which may be the wall's far
 * one, and hold the robot there. So these two do not meet until the part has come out.
 */
export class Lodged {
  private readonly body: Body;
  private readonly around: Surroundings;
  private readonly pairs = new Map<Fixture, Set<Fixture>>();

  constructor(body: Body, around: Surroundings) {
    this.body = body;
    this.around = around;
  }

  /** Looks what these parts stand in. Movable blocks are left out: they are pushed aside. */
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

  /** Whether this part stands in something. */
  has({ fixture }: Solid): boolean {
    return this.pairs.has(fixture);
  }

  /** Whether these two still stand in each other; once they no longer do, they meet from then on. */
  holds(own: Fixture, other: Fixture): boolean {
    if (this.pairs.get(own)?.has(other) !== true) return false;
    if (gapBetween(outlineOf(own), outlineOf(other)).gap < -OVERLAP) return true;
    this.forget(own, other);
    return false;
  }

  /** They no longer touch. */
  forget(own: Fixture, other: Fixture): void {
    const others = this.pairs.get(own);
    others?.delete(other);
    if (others?.size === 0) this.pairs.delete(own);
  }

  /** The part is gone. */
  drop({ fixture }: Solid): void {
    this.pairs.delete(fixture);
  }

  private add(own: Fixture, other: Fixture): void {
    const others = this.pairs.get(own);
    if (others) others.add(other);
    else this.pairs.set(own, new Set([other]));
  }
}
