import { findBoard } from './index';

/** The microcomputer of a project that is no board of ours: it has another chip, and its programs run on the mini 3. */
export const CALLIOPE_1_2 = { id: 'calliope-mini-2', board: 'calliope-mini-3' } as const;

/** Id of the board that stands for a project's microcomputer; `auto` for `auto` and for an unknown one. */
export function boardOf(device: string): string {
  if (device === CALLIOPE_1_2.id) return CALLIOPE_1_2.board;
  return findBoard(device)?.id ?? 'auto';
}
