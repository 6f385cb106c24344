import type { HexBoard, HexProblem } from './firmware';

/** A text file on a board. */
export interface HexFile {
  readonly name: string;
  readonly text: string;
}

/** A file that does not fit, or helps to fill the room. */
export interface FileSize {
  readonly name: string;
  /** Its space in the file system: whole chunks of 128 bytes. */
  readonly bytes: number;
}

/** The outcome of writing a hex. */
export type MadeHex =
  | {
      readonly kind: 'hex';
      readonly text: string;
      readonly boards: readonly HexBoard[];
      readonly usedBytes: number;
      /** The smallest room among its boards. */
      readonly roomBytes: number;
      /** Files that were empty and have got a line end, since a board can hold no empty file. */
      readonly filled: readonly string[];
    }
  /** The files need more room than there is. */
  | {
      readonly kind: 'too-large';
      readonly missingBytes: number;
      readonly roomBytes: number;
      /** The largest first. */
      readonly large: readonly FileSize[];
    }
  /** A file's name is empty, taken twice, or longer than 120 bytes. */
  | { readonly kind: 'name'; readonly name: string }
  /** No firmware, two for one board, or a micro:bit's beside a Calliope mini's: a hex can be for one family only. */
  | { readonly kind: 'boards'; readonly boards: readonly HexBoard[] };

/** Hints on how a hex was made. */
export type HexMade = 'micropython' | 'micropython-appended' | 'makecode' | 'universal' | 'unknown';

/** Something to tell about a hex that was read. */
export type HexNote =
  /** A file that is no text was left out. */
  | { readonly code: 'not-text'; readonly file: string }
  /** MicroPython without any file. */
  | { readonly code: 'no-files' };

/** A hex that was read. */
export interface ReadHex {
  readonly kind: 'hex';
  readonly made: HexMade;
  readonly boards: readonly HexBoard[];
  /** The firmware's own words for each of the boards. */
  readonly versions: readonly string[];
  /** The text of main.py; `null`: it has none. */
  readonly program: string | null;
  /** All its files, main.py first. */
  readonly files: readonly HexFile[];
  readonly notes: readonly HexNote[];
}
export type HexResult = ReadHex | { readonly kind: 'problem'; readonly problem: HexProblem };
