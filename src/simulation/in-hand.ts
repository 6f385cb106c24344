import type { Board } from '#board/board';
import { attachGamepad, type Gamepad } from '#devices/gamepad';
import { holdsGamepad } from '#robots/in-hand';
import type { Hardware } from './hardware';

/** Plugs a board without a robot into what its options name; `null`: into nothing. */
export const mountInHand = (board: Board, { robot, options }: Hardware): Gamepad | null =>
  robot === null && holdsGamepad(options) ? attachGamepad((name) => board.wire(name)) : null;
