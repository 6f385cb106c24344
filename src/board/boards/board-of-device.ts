import { findBoard } from './index';

/**
 * A microcomputer of projects without a board of its own here: it has another chip, and its programs run on the mini 3.
 */
export const CALLIOPE_1_2 = { id: 'calliope-mini-2', board: 'calliope-mini-3' } as const;

/** Id of the board that simulates a project's microcomputer; `auto` for `auto` and for an unknown one. */
export function boardOf(device: string): string {
  if (device === CALLIOPE_1_2.id) return CALLIOPE_1_2.board;
  return findBoard(device)?.id ?? 'auto';
}
