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
 * Moves the world on while blocks stay on their side of walls. A moving obstacle is stronger than any wall: what it
 * presses against one, or throws at one, the solver alone lets through a thin one. A block that is too deep in something
 * fixed after the step lies where it was before.
 */
export function guarded(blocks: Iterable<BlockBody>, step: () => void): void {
  const before: [BlockBody, Place][] = [];
  for (const block of blocks) if (block.isMovable && block.body.isAwake()) before.push([block, block.at()]);
  step();
  for (const [block, place] of before) {
    if (!block.isMovable || !isPressed(block.body)) continue;
    block.shove(place);
    block.body.setLinearVelocity(new Vec2(0, 0));
    block.body.setAngularVelocity(0);
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
