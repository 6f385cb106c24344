import { BLOCK_END, BLOCK_START, LAST_LINE, PADDING, record } from './records';

/** The part of a board in a universal hex. */
export interface UniversalPart {
  /** The number by which boards and apps know their part. */
  readonly boardId: number;
  /** Its data records. */
  readonly records: string;
}

/** Each part ends at a multiple of this, since boards take in a file in pieces of 512 bytes. */
const BLOCK = 512;
/** Most bytes of a line that only fills. */
const FILLING_BYTES = 16;
/** Signs of a line without bytes. */
const EMPTY = record(PADDING, 0, []).length;

/** Several boards' hexes in one file, of which each board takes its own: sections of spec-universal-hex 0.4.0. */
export const universalHex = (parts: readonly UniversalPart[]): string => parts.map(section).join('') + LAST_LINE;

function section({ boardId, records }: UniversalPart): string {
  // Readers know the file by its first two lines: an upper address, and the board.
  const first = records.indexOf('\n') + 1;
  const start = record(BLOCK_START, 0, [boardId >>> 8, boardId & 0xff, 0xc0, 0xde]);
  const filling: string[] = [];
  let missing = (BLOCK - ((records.length + start.length + EMPTY) % BLOCK)) % BLOCK;
  while (missing > 2 * FILLING_BYTES) {
    const line = filled(PADDING, Math.min(FILLING_BYTES, (missing - EMPTY) >> 1));
    filling.push(line);
    missing -= line.length;
  }
  return [records.slice(0, first), start, records.slice(first), ...filling, filled(BLOCK_END, missing >> 1)].join('');
}

const filled = (type: number, count: number): string => record(type, 0, new Uint8Array(count).fill(0xff));
