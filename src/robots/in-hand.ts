import type { OptionValues } from '#core/option';

/** Id of the option of a board without a robot: what it is plugged into. */
export const IN_HAND = 'inHand';

/** The choice for DFRobot's gamepad. */
export const GAMEPAD = 'gamepad';

/** The board whose edge connector the gamepad has a slot for. */
export const GAMEPAD_BOARD = 'microbit-v2';

/** The chosen options that mean something on a board without a robot; those of robots do not. */
export const optionsInHand = (board: { readonly id: string }, chosen: OptionValues = {}): OptionValues =>
  board.id === GAMEPAD_BOARD && holdsGamepad(chosen) ? { [IN_HAND]: GAMEPAD } : {};

/** True if a board with these options is plugged into a gamepad. */
export const holdsGamepad = (options: OptionValues): boolean => options[IN_HAND] === GAMEPAD;
