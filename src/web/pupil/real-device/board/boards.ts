import { hexBoards, type HexBoard } from '#hex/firmware';

/** The boards' own names. */
export const boardNames: Readonly<Record<HexBoard, string>> = {
  'microbit-v1': 'micro:bit V1',
  'microbit-v2': 'micro:bit V2',
  'calliope-mini-1': 'Calliope mini 1/2',
  'calliope-mini-3': 'Calliope mini 3',
};

/** The names of several boards. */
export const namesOf = (boards: readonly HexBoard[]): string => boards.map((board) => boardNames[board]).join(', ');

/** Boards in the order in which they are offered: the new ones first. */
export const offeredBoards: readonly HexBoard[] = ['microbit-v2', 'microbit-v1', 'calliope-mini-3', 'calliope-mini-1'];

/** The real board for a board of the simulation, by its id. */
export const realBoardOf = (id: string | undefined): HexBoard =>
  hexBoards.find((board) => board === id) ?? 'microbit-v2';
