import type { Firmware, HexBoard } from '#hex/firmware';
import { fittingFiles } from '#hex/fitting-files';
import type { SourceFile } from '#project/project';

import type { HexWriter } from '../board/hex-writer';
import { HexError, type BoardVersion } from './usb-problem';

/** A program and the robot that it drives: all that a board's files depend on. */
export interface BoardProgram {
  readonly own: readonly SourceFile[];
  /** Id of the robot; `null`: the bare board. */
  readonly robot: string | null;
}

/** A program as a hex for a board. */
export interface BoardHex {
  readonly text: string;
  readonly boards: readonly HexBoard[];
  /** Libraries without their comments, because they would not have fitted otherwise. */
  readonly smaller: readonly string[];
  /** Empty files that have got a line end. */
  readonly filled: readonly string[];
}

/** The firmwares at hand, by their board. */
export type Firmwares = (board: HexBoard) => Firmware | null;

/** Number of files that are named when there is too much. */
const NAMED = 3;

/**
 * Makes the hex of a program for these firmwares.
 *
 * @throws HexError (as a rejection) `too-large`, `name`, `not-written`
 */
export async function hexOf(
  { own, robot }: BoardProgram,
  firmwares: readonly Firmware[],
  write: HexWriter,
): Promise<BoardHex> {
  const room = Math.min(...firmwares.map(({ roomBytes }) => roomBytes));
  const { files, smaller } = fittingFiles(own, robot, room);
  const made = await write(firmwares, files).catch(() => {
    throw new HexError({ kind: 'not-written' });
  });
  if (made.kind === 'hex') return { ...made, smaller };
  if (made.kind === 'name') throw new HexError({ kind: 'name', name: made.name });
  if (made.kind === 'boards') throw new Error(`No hex is for ${made.boards.join(' and ')} together.`);
  const large = made.large.slice(0, NAMED).map(({ name }) => name);
  throw new HexError({ kind: 'too-large', missingBytes: made.missingBytes, large });
}

const SIBLINGS: Readonly<Record<HexBoard, HexBoard>> = {
  'microbit-v1': 'microbit-v2',
  'microbit-v2': 'microbit-v1',
  'calliope-mini-1': 'calliope-mini-3',
  'calliope-mini-3': 'calliope-mini-1',
};

/** The firmwares for a file to save: the board's, and its older or newer sibling's where it is at hand, as a class may have both. */
export const firmwaresToSave = (board: HexBoard, firmwares: Firmwares): readonly Firmware[] =>
  [firmwares(board), firmwares(SIBLINGS[board])].filter((firmware) => firmware !== null);

/**
 * The firmware for the board at the cable, which tells its version alone.
 *
 * @throws HexError `other-board`: it is not the chosen one, and there is no firmware for it
 */
export function firmwareToFlash(chosen: HexBoard, version: BoardVersion, firmwares: Firmwares): Firmware {
  const isOld = (board: HexBoard): boolean => board === 'microbit-v1' || board === 'calliope-mini-1';
  const there = isOld(chosen) === (version === 'V1') ? chosen : SIBLINGS[chosen];
  const firmware = firmwares(there);
  if (firmware === null) throw new HexError({ kind: 'other-board', found: there });
  return firmware;
}
