import { VARINT_BYTES, WORDS } from './columns';
import { DamagedBytes } from './damaged-bytes';
import { joined, Likelihood } from './likelihood';

/**
 * Makes or takes a decision: a writer writes `bit` and returns it, a reader ignores it and returns what was written.
 *
 * @param yes the probability of a yes, in parts of `CERTAIN`
 */
export type Decide = (yes: number, bit: number) => number;

/** Longest number: 36 bits hold one more than the largest varint. */
const MOST_BITS = 36;
const POWERS = Array.from({ length: MOST_BITS + 1 }, (_, power) => powerOfTwo(power));

/** The first bits of a number use all contexts, the later ones only the two most general. */
const FIRST_BITS = 4;

/**
 * Values as decisions. The same code writes and reads, so that both see every decision in the same contexts: when
 * reading, the given value is ignored.
 *
 * A whole number: the number of bits of its successor, as that many times yes, then these bits, the highest first. Its
 * contexts are the earlier values: in its column, and in all columns. A character: the bytes of its varint, bit by bit;
 * its contexts are the characters before, up to six, and the beginning of the word.
 */
export class ValueModel {
  private readonly likelihood: Likelihood;
  private readonly last: number[] = [];
  private readonly lastButOne: number[] = [];
  private previous = 0;
  /** The bytes of the previous characters, the newest first. */
  private tail: readonly number[];
  private word: number;

  /** @param taught a model that has read characters; left out: no knowledge */
  constructor(
    private readonly decide: Decide,
    taught?: ValueModel,
  ) {
    this.likelihood = new Likelihood(taught?.likelihood);
    this.tail = taught?.tail ?? [0, 0, 0, 0, 0, 0];
    this.word = taught?.word ?? 0;
  }

  /** @param near knowledge about the value: contexts instead of the usual ones, most general first */
  uint(column: number, value: number, near?: readonly number[]): number {
    const done = this.number(column, value, near ?? this.contextsOf(column));
    this.lastButOne[column] = this.last[column] ?? 0;
    this.last[column] = done;
    this.previous = joined(column, done);
    return done;
  }

  /** A UTF-16 unit of a text. */
  unit(value: number): number {
    let [made, unit, rest] = [0, 1, value];
    for (let index = 0; index < VARINT_BYTES; index += 1) {
      const byte = this.byte((rest % 0x80) + (rest >= 0x80 ? 0x80 : 0));
      made += (byte & 0x7f) * unit;
      if (byte < 0x80) return made;
      unit *= 0x80;
      rest = Math.floor(rest / 0x80);
    }
    throw new DamagedBytes();
  }

  private contextsOf(column: number): readonly number[] {
    const last = joined(column, this.last[column] ?? 0);
    const both = joined(last, this.lastButOne[column] ?? 0);
    const after = joined(column, this.previous);
    return [column, last, both, after, joined(after, last)];
  }

  private number(column: number, value: number, near: readonly number[]): number {
    const contexts = near.map((context) => joined(column, context));
    const successor = value + 1;
    let bits = 1;
    while (
      this.bit(successor >= (POWERS[bits] ?? 0) ? 1 : 0, bits, contexts, joined(column, Math.min(bits, 7))) === 1
    ) {
      bits += 1;
      if (bits > MOST_BITS) throw new DamagedBytes();
    }
    let made = 1;
    for (let place = bits - 2; place >= 0; place -= 1) {
      const bit = Math.floor(successor / (POWERS[place] ?? 1)) % 2;
      const done = bits - 2 - place;
      const isFirst = done < FIRST_BITS;
      const node = joined(bits, isFirst ? made : -place);
      const mixer = joined(column, 8 + Math.min(done, FIRST_BITS));
      made = 2 * made + this.bit(bit, node, isFirst ? contexts : contexts.slice(0, 2), mixer);
    }
    return made - 1;
  }

  private byte(value: number): number {
    const contexts: number[] = [WORDS, joined(WORDS, this.word)];
    let before = 0;
    for (const [index, byte] of this.tail.entries()) {
      before = joined(before, byte);
      if (index !== 4) contexts.push(before);
    }
    let node = 1;
    for (let place = 7; place >= 0; place -= 1)
      node = 2 * node + this.bit((value >>> place) & 1, node, contexts, joined(-1, place));
    const byte = node & 0xff;
    this.tail = [byte, ...this.tail.slice(0, -1)];
    this.word = isLetter(byte) ? joined(this.word, byte) : 0;
    return byte;
  }

  private bit(bit: number, node: number, contexts: readonly number[], mixer: number): number {
    const done = this.decide(this.likelihood.of(contexts, node, mixer), bit);
    this.likelihood.learn(done);
    return done;
  }
}

/** A–Z, a–z, `_` and bytes of characters beyond ASCII. */
const isLetter = (byte: number): boolean =>
  (byte >= 65 && byte <= 90) || (byte >= 97 && byte <= 122) || byte === 95 || byte >= 128;

function powerOfTwo(power: number): number {
  let result = 1;
  for (let times = 0; times < power; times += 1) result *= 2;
  return result;
}
