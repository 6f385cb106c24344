/**
 * Number of the physics: it goes up whenever the same course and programs make the robots go another way than before.
 * A recorded run states its number, so that a different result after a change of the physics is not taken for a fault.
 *
 * 1: motors took a new power at the next step. 2: docs/decisions/0071-the-second-physics.md.
 */
export const PHYSICS = 2;
