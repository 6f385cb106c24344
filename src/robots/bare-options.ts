import { optionOf, type Option } from '#core/option';
import { GAMEPAD, GAMEPAD_BOARD, IN_HAND } from './in-hand';
import words from './words';

const inHand = optionOf(IN_HAND, words.inHand, ['nothing', GAMEPAD]);

/** The options of a board that carries no robot. */
export const bareOptions = (board: { readonly id: string }): readonly Option[] =>
  board.id === GAMEPAD_BOARD ? [inHand] : [];
