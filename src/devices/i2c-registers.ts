/**
 * A register machine: how most I2C chips and robot controllers talk.
 *
 *      write  [register, data, data …]   data for that register and the following ones
 *      write  [register]                 selects it
 *      read   n bytes                    from the selected register on; the selection moves along
 *
 * Register numbers are bytes and wrap from 255 to 0. A register without a part ignores writes and reads as 0. After data
 * most chips have selected the register behind them; some read from the one that was named, again and again
 * (`RegisterOptions`).
 */
import type { I2cTarget } from '#board/wires/i2c-bus';

const REGISTER_COUNT = 256;

/** Consecutive registers that belong together. `offset` counts from the first of them. */
export interface RegisterPart {
  readonly first: number;
  readonly count: number;
  /**
   * How many bytes a read that starts in this part gets from it, if these are more than its registers. It then goes on
   * behind them, not with the registers in between, which still answer when they are selected. Left out: `count`.
   */
  readonly readCount?: number;
  readonly read: (offset: number) => number;
  /** Left out: read-only. */
  readonly write?: (offset: number, byte: number) => void;
  /** Called once at the end of each transfer that wrote at least one of them, with those that it wrote. */
  readonly written?: (touched: Touched) => void;
}

/** Registers of a part that a transfer has written: the offsets of the first and the last of them. */
export interface Touched {
  readonly first: number;
  readonly last: number;
}

/** Registers that keep what was written; at the start `start`, or 0. `written` gets their contents. */
export function memoryRegisters(
  first: number,
  count: number,
  written: (bytes: Readonly<Uint8Array>, touched: Touched) => void = () => undefined,
  start: readonly number[] = [],
): RegisterPart {
  const bytes = new Uint8Array(count);
  bytes.set(start);
  return {
    first,
    count,
    read: (offset) => bytes[offset] ?? 0,
    write: (offset, byte) => {
      bytes[offset] = byte;
    },
    written: (touched) => written(bytes, touched),
  };
}

/** Read-only registers; `read` is called again for every byte. */
export function liveRegisters(first: number, count: number, read: (offset: number) => number): RegisterPart {
  return { first, count, read };
}

/** Whole numbers of two bytes each, read-only; `read` gets the place of the word and is called again for every byte. */
export function wordRegisters(
  first: number,
  words: number,
  order: 'high-first' | 'low-first',
  read: (word: number) => number,
): RegisterPart {
  return liveRegisters(first, 2 * words, (offset) =>
    byteOf(read(offset >> 1), order === 'high-first' ? offset % 2 : 1 - (offset % 2)),
  );
}

/** A byte of a whole number of `count` bytes, the highest at place 0; of a negative one as its two's complement. */
export const byteOf = (value: number, place: number, count = 2): number => (value >> (8 * (count - 1 - place))) & 0xff;

/** A byte with a bit for each of these, from bit 0 on. */
export const bitsOf = <Name>(names: readonly Name[], isSet: (name: Name) => boolean): number =>
  names.reduce((bits, name, bit) => (isSet(name) ? bits | (1 << bit) : bits), 0);

/**
 * An ASCII text, read-only: its length in the first register, its characters in the following ones.
 *
 * @param room registers that it has, if they are fewer than it needs; a read gets all of it all the same
 */
export function textRegisters(first: number, text: string, room = text.length + 1): RegisterPart {
  const readCount = text.length + 1;
  const read = (offset: number): number => (offset === 0 ? text.length : text.charCodeAt(offset - 1));
  return { first, count: Math.min(room, readCount), readCount, read };
}

/** How a chip differs from most. */
export interface RegisterOptions {
  /** Every read begins at the register that was named last, whatever was written to it or read from it since. */
  readonly staysSelected?: boolean;
}

/** Makes the device. Where parts overlap, the first one in the list counts. */
export function createRegisterMachine(parts: readonly RegisterPart[], options: RegisterOptions = {}): I2cTarget {
  const partOf = Array.from({ length: REGISTER_COUNT }, (_, register) =>
    parts.find(({ first, count }) => register >= first && register < first + count),
  );
  let selected = 0;
  /** The part in which reading began, if it gives more bytes than it has registers. */
  let long: RegisterPart | undefined;
  const next = (): number => (selected + 1) % REGISTER_COUNT;
  const select = (register: number): void => {
    selected = register;
    const part = partOf[register];
    long = (part?.readCount ?? 0) > (part?.count ?? 0) ? part : undefined;
  };
  const readNext = (): number => {
    const offset = long === undefined ? 0 : selected - long.first;
    const part = long !== undefined && offset >= 0 && offset < (long.readCount ?? 0) ? long : partOf[selected];
    const byte = part?.read(selected - part.first) ?? 0;
    selected = next();
    return byte;
  };

  return {
    write: (bytes) => {
      if (bytes.length === 0) return; // an address probe
      const start = bytes[0] ?? 0;
      const whole = partOf[start];
      let isWhole = true;
      selected = start;
      for (let i = 1; i < bytes.length; i++) {
        const part = partOf[selected];
        isWhole &&= part === whole;
        part?.write?.(selected - part.first, bytes[i] ?? 0);
        selected = next();
      }
      select(options.staysSelected === true ? start : selected);
      const count = bytes.length - 1;
      if (count === 0) return;
      // Nearly every transfer stays within one part, and in simple loops they come by the thousand.
      if (!isWhole || start + count > REGISTER_COUNT) tell(partOf, start, count);
      else if (whole?.write) whole.written?.({ first: start - whole.first, last: start - whole.first + count - 1 });
    },
    read: (count) => {
      const answer = new Uint8Array(count);
      const start = selected;
      for (let i = 0; i < count; i++) answer[i] = readNext();
      if (options.staysSelected === true) selected = start;
      return answer;
    },
  };
}

/** Calls `written` once for each part in which a transfer has written, from this register on. */
function tell(partOf: readonly (RegisterPart | undefined)[], register: number, count: number): void {
  const touched = new Map<RegisterPart, Touched>();
  for (let i = 0; i < count; i++) {
    const at = (register + i) % REGISTER_COUNT;
    const part = partOf[at];
    if (part?.write) touched.set(part, around(touched.get(part), at - part.first));
  }
  for (const [part, registers] of touched) part.written?.(registers);
}

const around = (before: Touched | undefined, offset: number): Touched => ({
  first: Math.min(before?.first ?? offset, offset),
  last: Math.max(before?.last ?? offset, offset),
});
