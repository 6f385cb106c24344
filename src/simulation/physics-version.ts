/**
 * Number of the physics: it goes up whenever the same course and programs make the robots go another way than before.
 * A recorded run says which it had, so that one that comes out differently is told from a fault.
 *
 * 1: motors took a new power at the next step. 2: docs/decisions/0071-the-second-physics.md.
 */
export const PHYSICS = 2;
