import { WORDS } from './columns';
import { DamagedBytes } from './damaged-bytes';
import type { ValueReader, ValueWriter } from './value-port';

/** One description of a value for both directions, so that writing and reading cannot diverge. */
export interface Codec<T> {
  write(out: ValueWriter, value: T): void;
  read(from: ValueReader): T;
}

/** A whole number of either sign, with knowledge about it from earlier values. */
export interface NearCodec {
  write(out: ValueWriter, value: number, near: readonly number[]): void;
  read(from: ValueReader, near: readonly number[]): number;
}

/**
 * Makes codecs and gives each leaf a column of its own, in the order in which they are made. That order is part of the
 * format.
 */
export class Columns {
  private count = WORDS + 1;

  /** Number of columns that the codecs use. */
  get used(): number {
    return this.count;
  }

  /** A whole number, not negative. */
  uint(): Codec<number> {
    const column = this.next();
    return { write: (out, value) => out.uint(column, value), read: (from) => from.uint(column) };
  }

  /** A whole number of either sign. */
  int(): Codec<number> {
    const column = this.next();
    return { write: (out, value) => out.int(column, value), read: (from) => from.int(column) };
  }

  /** A whole number of either sign; the caller knows something about its likely values. */
  near(): NearCodec {
    const column = this.next();
    return {
      write: (out, value, near) => {
        out.int(column, value, near);
      },
      read: (from, near) => from.int(column, near),
    };
  }

  /** A whole number of mm: the difference of the cm from the previous ones, and the remaining mm (0 on a grid). */
  coordinate(): Codec<number> {
    const [cm, mm] = [this.next(), this.next()];
    return {
      write(out, value) {
        const whole = Math.floor(value / 10);
        out.delta(cm, whole);
        out.uint(mm, value - 10 * whole);
      },
      read: (from) => 10 * from.delta(cm) + from.uint(mm),
    };
  }

  /** Any finite number: hundredths as a whole number, others as the eight bytes of a double. */
  number(): Codec<number> {
    const [kind, bytes] = [this.next(), this.next()];
    return {
      write(out, value) {
        const hundredths = Math.round(value * 100);
        const isShort = Math.abs(hundredths) < 0x7fffffff && hundredths / 100 === value;
        out.int(kind, isShort ? (hundredths < 0 ? hundredths : hundredths + 1) : 0);
        if (!isShort) for (const byte of doubleBytes(value)) out.byte(bytes, byte);
      },
      read(from) {
        const value = from.int(kind);
        if (value !== 0) return (value < 0 ? value : value - 1) / 100;
        const number = doubleOf(Array.from({ length: 8 }, () => from.byte(bytes)));
        if (!Number.isFinite(number)) throw new DamagedBytes();
        return number;
      },
    };
  }

  flag(): Codec<boolean> {
    return this.choice([false, true]);
  }

  /** One of a list of values; the list may grow only at its end. */
  choice<const T>(values: readonly T[]): Codec<T> {
    const column = this.next();
    return {
      write: (out, value) => out.uint(column, values.indexOf(value)),
      read(from) {
        const index = from.uint(column);
        if (index >= values.length) throw new DamagedBytes();
        return values[index] as T; // the index is in the list
      },
    };
  }

  /** Text, by UTF-16 units: any text of a file comes back unchanged. */
  text(): Codec<string> {
    const length = this.next();
    return {
      write(out, value) {
        out.uint(length, value.length);
        for (let index = 0; index < value.length; index += 1) out.uint(WORDS, value.charCodeAt(index));
      },
      read(from) {
        const count = countOf(from, length, WORDS);
        const pieces: string[] = [];
        for (let done = 0; done < count; done += 1) {
          const unit = from.uint(WORDS);
          if (unit > 0xffff) throw new DamagedBytes();
          pieces.push(String.fromCharCode(unit));
        }
        return pieces.join('');
      },
    };
  }

  /** A text that occurs repeatedly: written once, then by its number. */
  word(text: Codec<string>): Codec<string> {
    const column = this.next();
    return {
      write(out, value) {
        const number = out.known(value);
        out.uint(column, number);
        if (number === 0) text.write(out, value);
      },
      read(from) {
        const number = from.uint(column);
        if (number !== 0) return from.word(number);
        const word = text.read(from);
        from.learn(word);
        return word;
      },
    };
  }

  bytes(): Codec<Uint8Array> {
    const [length, bytes] = [this.next(), this.next()];
    return {
      write(out, value) {
        out.uint(length, value.length);
        for (const byte of value) out.byte(bytes, byte);
      },
      read: (from) => Uint8Array.from({ length: countOf(from, length, bytes) }, () => from.byte(bytes)),
    };
  }

  /** A value or `null`. */
  optional<T>(codec: Codec<T>): Codec<T | null> {
    const isThere = this.flag();
    return {
      write(out, value) {
        isThere.write(out, value !== null);
        if (value !== null) codec.write(out, value);
      },
      read: (from) => (isThere.read(from) ? codec.read(from) : null),
    };
  }

  /** A list of at most `max` entries. */
  list<T>(codec: Codec<T>, max: number): Codec<readonly T[]> {
    const column = this.next();
    return {
      write(out, values) {
        out.uint(column, values.length);
        for (const value of values) codec.write(out, value);
      },
      read(from) {
        const count = from.uint(column);
        if (count > max) throw new DamagedBytes();
        return Array.from({ length: count }, () => codec.read(from));
      },
    };
  }

  private next(): number {
    this.count += 1;
    return this.count - 1;
  }
}

/** An object, property by property in the order given here. */
export function record<T extends object>(codecs: { readonly [K in keyof T]: Codec<T[K]> }): Codec<T> {
  const keys = Object.keys(codecs) as (keyof T & string)[];
  return {
    write(out, value) {
      for (const key of keys) codecs[key].write(out, value[key]);
    },
    read: (from) => Object.fromEntries(keys.map((key) => [key, codecs[key].read(from)])) as T,
  };
}

/** A value in another form. `to` may throw `DamagedBytes`. */
export function mapped<T, U>(codec: Codec<U>, from: (value: T) => U, to: (value: U) => T): Codec<T> {
  return { write: (out, value) => codec.write(out, from(value)), read: (reader) => to(codec.read(reader)) };
}

/** Always the same value: takes no room. */
export const constant = <const T>(value: T): Codec<T> => ({ write: () => undefined, read: () => value });

/** A count of things that take at least a byte each, so that a hostile count costs no memory. */
function countOf(from: ValueReader, length: number, things: number): number {
  const count = from.uint(length);
  if (count > from.left(things)) throw new DamagedBytes();
  return count;
}

function doubleBytes(value: number): number[] {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value, true);
  return Array.from({ length: 8 }, (_, index) => view.getUint8(index));
}

function doubleOf(bytes: readonly number[]): number {
  const view = new DataView(new ArrayBuffer(8));
  for (const [index, byte] of bytes.entries()) view.setUint8(index, byte);
  return view.getFloat64(0, true);
}
