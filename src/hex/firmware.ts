/** The boards for which a hex can be made or read. */
export const hexBoards = ['microbit-v1', 'microbit-v2', 'calliope-mini-1', 'calliope-mini-3'] as const;
export type HexBoard = (typeof hexBoards)[number];

/** Bytes of the flash in one piece. */
export interface Region {
  readonly address: number;
  readonly bytes: Uint8Array;
}

/** The MicroPython of one board without anybody's files: plain data that can be kept. */
export interface Firmware {
  /** The Calliope mini 1 and 2 have the same firmware. */
  readonly board: HexBoard;
  /** The text by which it calls itself, such as `micro:bit v2.1.2+0697c6d on 2023-10-30; MicroPython v1.18 …`; may be empty. */
  readonly version: string;
  /** The release whose bytes it has, such as `micro:bit V2 MicroPython 2.1.2`; `null`: its bytes are not among those tried. */
  readonly known: string | null;
  /** Everything in the flash except files, by address. */
  readonly regions: readonly Region[];
  /** Space of the file system, in bytes. */
  readonly roomBytes: number;
}

/** A text that is no hex to work with. */
export interface HexProblem {
  readonly code:
    | /** No line of it is one of a hex. */ 'no-hex'
      /** A line is damaged. */
    | 'line'
    /** It breaks off: the record at its end is missing. */
    | 'cut'
    /** Its files are damaged. */
    | 'files'
    /** Its parts for several boards hold different files. */
    | 'parts'
    /** MakeCode's program, which has no Python in it. */
    | 'makecode'
    /** Some other program for a board, with no MicroPython in it. */
    | 'no-python';
  /** Number of the damaged line, from 1; with `line` only. */
  readonly line?: number;
}

/** The firmwares in a hex; a universal one has two. */
export type Cleaned = { readonly firmwares: readonly Firmware[] } | { readonly problem: HexProblem };
