/**
 * Reads texts that LZ-String packed with `compressToBase64`. Our own reader, because the library's has no limit: a link
 * of a few kB can unpack to hundreds of MB.
 *
 * The format: six bits a character of base64, the highest first, and as many characters as it needs, even a number of
 * characters that whole bytes never have. A code has as many bits as the dictionary needs, the lowest first; 0 and 1
 * bring a new character (8 or 16 bits follow), 2 is the end, others name an entry. After each code except the first,
 * the previous piece and the first character of the present one make a new entry.
 */

/** Why a text could not be unpacked: it is not packed text, or it exceeds the limit. */
export type LzProblem = 'damaged' | 'too-large';

const END = 2;
const FIRST_ENTRY = 3;
/** Codes never need more bits: an entry takes at least one. */
const LAST_WIDTH = 30;

/**
 * Unpacks base64 in either alphabet.
 *
 * @param maxCharacters maximum length of the text
 */
export function textOfLzBase64(base64: string, maxCharacters: number): { readonly text: string } | LzProblem {
  const sixes = sixesOf(base64.replace(/={1,3}$/, ''));
  return sixes === null ? 'damaged' : new LzReader(sixes, maxCharacters).read();
}

const SIGNS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
/** Both alphabets; a space was a `+` before something decoded it as in a form. */
const values = new Map([
  ...Array.from(SIGNS, (sign, value) => [sign, value] as const),
  ['-', 62],
  ['_', 63],
  [' ', 62],
]);

/** The six bits of each character. */
function sixesOf(base64: string): Uint8Array | null {
  const sixes = new Uint8Array(base64.length);
  for (let index = 0; index < base64.length; index += 1) {
    const value = values.get(base64.charAt(index));
    if (value === undefined) return null;
    sixes[index] = value;
  }
  return sixes;
}

/** An entry of the dictionary: an earlier piece of the text, or a single character of its own. */
interface Entry {
  readonly start: number;
  readonly length: number;
}

class LzReader {
  private bit = 0;
  private readonly units: number[] = [];
  private readonly entries: Entry[] = [];

  constructor(
    private readonly sixes: Uint8Array,
    private readonly maxCharacters: number,
  ) {}

  read(): { readonly text: string } | LzProblem {
    let width = 2;
    let left = 0; // the number of codes of this width; the first one is separate
    let before: Entry | null = null;
    for (;;) {
      const code = this.number(width);
      if (code === null) return 'damaged';
      if (code === END) return { text: this.text() };
      const isNew = code < END;
      const now: Entry | null = isNew ? this.append(code === 0 ? 8 : 16) : this.repeat(code, before);
      if (now === null) return 'damaged';
      if (this.units.length > this.maxCharacters) return 'too-large';
      if (before === null) [width, left] = [3, 4];
      else {
        if (isNew) [width, left] = counted(width, left);
        // The previous piece and one more character: the text contains exactly this.
        this.entries.push({ start: before.start, length: before.length + 1 });
        [width, left] = counted(width, left);
      }
      if (width > LAST_WIDTH) return 'damaged';
      before = now;
    }
  }

  /** A new character: at the end of the text, and an entry. */
  private append(bits: number): Entry | null {
    const unit = this.number(bits);
    if (unit === null) return null;
    const entry = { start: this.units.length, length: 1 };
    this.units.push(unit);
    this.entries.push(entry);
    return entry;
  }

  /** Appends an entry to the text again. The entry that is just being made may already be named. */
  private repeat(code: number, before: Entry | null): Entry | null {
    const index = code - FIRST_ENTRY;
    const known = this.entries[index];
    if (before === null || (known === undefined && index !== this.entries.length)) return null;
    const { start, length } = known ?? { start: before.start, length: before.length + 1 };
    if (this.units.length + length > this.maxCharacters) {
      this.units.length = this.maxCharacters + 1; // the caller reports it as too large
      return before;
    }
    const entry = { start: this.units.length, length };
    for (let at = start; at < start + length; at += 1) this.units.push(this.units[at] ?? 0);
    return entry;
  }

  private number(bits: number): number | null {
    if (this.bit + bits > this.sixes.length * 6) return null;
    let value = 0;
    for (let index = 0; index < bits; index += 1) {
      const six = this.sixes[Math.floor(this.bit / 6)] ?? 0;
      if ((six >> (5 - (this.bit % 6))) & 1) value += 1 << index;
      this.bit += 1;
    }
    return value;
  }

  private text(): string {
    const pieces: string[] = [];
    for (let at = 0; at < this.units.length; at += 4096)
      pieces.push(String.fromCharCode(...this.units.slice(at, at + 4096)));
    return pieces.join('');
  }
}

/** One code fewer of this width; after the last one, codes are one bit longer. */
function counted(width: number, left: number): readonly [width: number, left: number] {
  return left > 1 ? [width, left - 1] : [width + 1, 1 << width];
}
