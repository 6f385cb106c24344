import type { HexProblem, Region } from './firmware';

/** The bytes of one board in a hex. */
export interface HexPart {
  /** The board's number in a universal hex; `null`: an ordinary hex. */
  readonly boardId: number | null;
  /** Its bytes in pieces as long as possible, by address. */
  readonly regions: readonly Region[];
}

/** The content of a hex. */
export interface ParsedHex {
  readonly parts: readonly HexPart[];
  /** It carries data beside the boards' own, as MakeCode keeps its source. */
  readonly hasOtherData: boolean;
}

/** Kinds of records: Intel's, and those of the universal hex (spec-universal-hex 0.4.0). */
const DATA = 0x00;
const END = 0x01;
const SEGMENT = 0x02;
const START_SEGMENT = 0x03;
const UPPER = 0x04;
const START_LINEAR = 0x05;
const BLOCK_START = 0x0a;
const BLOCK_END = 0x0b;
const PADDING = 0x0c;
const CUSTOM_DATA = 0x0d;
const OTHER_DATA = 0x0e;
const IGNORED = [START_SEGMENT, START_LINEAR, BLOCK_END, PADDING];

/** A board has its memory here, and no flash: MakeCode's first form keeps its source at this address. */
const MEMORY = 0x20000000;

interface Record {
  readonly type: number;
  readonly offset: number;
  readonly data: Uint8Array;
}

/**
 * Reads the lines of a hex, also one for several boards. After the record at its end only other data is looked for, since
 * MakeCode's files go on there.
 */
export function parseHex(text: string): ParsedHex | { readonly problem: HexProblem } {
  const reading = new Reading();
  let line = 0;
  for (const raw of text.replace(/^\ufeff/, '').split(/\r\n|\r|\n/)) {
    line += 1;
    const content = raw.trim();
    // The old editor marks with a row of colons where the script goes.
    if (content === '' || /^::+$/.test(content)) continue;
    if (!content.startsWith(':') && !reading.hasBegun) return { problem: { code: 'no-hex' } };
    const record = recordOf(content);
    if (reading.isAtEnd) {
      if (record !== null) reading.takeBehindEnd(record);
    } else if (record === null || !reading.take(record, line)) return { problem: { code: 'line', line } };
  }
  return reading.result();
}

/** The record in a line; `null`: the line is damaged. */
function recordOf(line: string): Record | null {
  const count = (line.length - 1) >> 1;
  if (!line.startsWith(':') || line.length % 2 === 0 || count < 5) return null;
  const bytes = new Uint8Array(count);
  let sum = 0;
  let digits = 0;
  for (let index = 0; index < count; index++) {
    const high = digitOf(line.charCodeAt(2 * index + 1));
    const low = digitOf(line.charCodeAt(2 * index + 2));
    digits |= high | low;
    const byte = (high << 4) | low;
    bytes[index] = byte;
    sum += byte;
  }
  if (digits > 0xf || (bytes[0] ?? 0) !== count - 5 || (sum & 0xff) !== 0) return null;
  const offset = 256 * (bytes[1] ?? 0) + (bytes[2] ?? 0);
  return { type: bytes[3] ?? 0, offset, data: bytes.subarray(4, count - 1) };
}

/** The value of a hexadecimal digit by the number of its sign; 16: it is none. */
function digitOf(code: number): number {
  if (code >= 0x30 && code <= 0x39) return code - 0x30;
  const letter = code & ~0x20;
  return letter >= 0x41 && letter <= 0x46 ? letter - 0x37 : 16;
}

interface Piece extends Region {
  readonly line: number;
}

class Reading {
  /** A line was one of a hex. */
  hasBegun = false;
  isAtEnd = false;
  private upper = 0;
  private boardId: number | null = null;
  private hasOtherData = false;
  private readonly pieces = new Map<number | null, Piece[]>();

  /** Takes a record; false: there can be no such one. */
  take({ type, offset, data }: Record, line: number): boolean {
    this.hasBegun = true;
    if (type === DATA || type === CUSTOM_DATA) this.add({ address: this.upper + offset, bytes: data, line });
    else if (type === END) this.isAtEnd = true;
    else if (type === UPPER || type === SEGMENT) this.upper = wordOf(data) * (type === UPPER ? 0x10000 : 0x10);
    else if (type === BLOCK_START) this.boardId = wordOf(data);
    else if (type === OTHER_DATA) this.hasOtherData = true;
    else return IGNORED.includes(type);
    return true;
  }

  takeBehindEnd({ type, data }: Record): void {
    if (type === OTHER_DATA || (type === UPPER && wordOf(data) * 0x10000 === MEMORY)) this.hasOtherData = true;
  }

  result(): ParsedHex | { readonly problem: HexProblem } {
    if (!this.hasBegun) return { problem: { code: 'no-hex' } };
    if (!this.isAtEnd) return { problem: { code: 'cut' } };
    const parts: HexPart[] = [];
    for (const [boardId, pieces] of this.pieces) {
      const regions = joined(pieces);
      if ('line' in regions) return { problem: { code: 'line', line: regions.line } };
      parts.push({ boardId, regions });
    }
    return { parts, hasOtherData: this.hasOtherData };
  }

  private add(piece: Piece): void {
    if (piece.address >= MEMORY) this.hasOtherData = true;
    const before = this.pieces.get(this.boardId);
    if (before === undefined) this.pieces.set(this.boardId, [piece]);
    else before.push(piece);
  }
}

const wordOf = (data: Uint8Array): number => 256 * (data[0] ?? 0) + (data[1] ?? 0);

/** Pieces that follow each other as one; the line of one that lies upon another, if there is such. */
function joined(pieces: readonly Piece[]): readonly Region[] | { readonly line: number } {
  const sorted = pieces.toSorted((a, b) => a.address - b.address);
  const regions: Region[] = [];
  let run: Piece[] = [];
  let end = -1;
  for (const piece of sorted) {
    if (piece.address < end) return { line: piece.line };
    if (piece.address > end && run.length > 0) {
      regions.push(oneOf(run));
      run = [];
    }
    run.push(piece);
    end = piece.address + piece.bytes.length;
  }
  if (run.length > 0) regions.push(oneOf(run));
  return regions;
}

function oneOf(run: readonly Piece[]): Region {
  const address = run[0]?.address ?? 0;
  const bytes = new Uint8Array(run.reduce((sum, piece) => sum + piece.bytes.length, 0));
  for (const piece of run) bytes.set(piece.bytes, piece.address - address);
  return { address, bytes };
}
