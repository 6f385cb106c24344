import type { BlockBody, Place } from './block-body';
import { gapBetween } from './convex';
import { Vec2 } from './planck';
import type { Body } from './planck';
import { UNITS_PER_MM } from './scale';
import { outlineOf } from './solid';

/**
 * A block that a step has pressed this far into something fixed is put back. Chosen: more than the solver leaves of a
 * push, less than half of the thinnest walls of usual courses, through which it would come out at the other side.
 */
const PRESSED = 0.5 * UNITS_PER_MM;

/**
 * Keeps blocks on their side of walls. A moving obstacle is stronger than any wall: what it presses against one, or
 * throws at one, the solver alone lets through a thin one.
 */
export class WallGuard {
  private readonly before = new Map<BlockBody, Place>();

  /** Call it before each step of the world. */
  note(blocks: Iterable<BlockBody>): void {
    this.before.clear();
    for (const block of blocks) if (block.isMovable && block.body.isAwake()) this.before.set(block, block.at());
  }

  /** Call it after the step: a block that is too deep in something fixed lies where it was before. */
  putBack(): void {
    for (const [block, place] of this.before) {
      if (!block.isMovable || !isPressed(block.body)) continue;
      block.shove(place);
      block.body.setLinearVelocity(new Vec2(0, 0));
      block.body.setAngularVelocity(0);
    }
  }
}

function isPressed(body: Body): boolean {
  for (let edge = body.getContactList(); edge; edge = edge.next ?? null) {
    if (edge.other?.isStatic() !== true) continue;
    const { contact } = edge;
    const [a, b] = [contact.getFixtureA(), contact.getFixtureB()];
    if (gapBetween(outlineOf(a), outlineOf(b)).gap < -PRESSED) return true;
  }
  return false;
}
