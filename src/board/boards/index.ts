import type { BoardType } from './board-type';
import { calliopeMini3 } from './calliope-mini-3';
import { microbitV2 } from './microbit-v2';

/** All boards, the default first. */
export const boardTypes: readonly BoardType[] = [microbitV2, calliopeMini3];

/** The board with this id, or `undefined`. */
export function findBoard(id: string): BoardType | undefined {
  return boardTypes.find((type) => type.id === id);
}
