import { varintBytes, WORDS } from './columns';
import { DamagedBytes } from './damaged-bytes';
import { RangeDecoder, RangeEncoder } from './range-coder';
import { ValueModel } from './value-model';
import { OrderedReader, OrderedWriter } from './ordered-values';
import { LIKELY_TEXT } from './likely-text';

/**
 * The maximum that is written or read with a model, in bytes of columns: a model takes about 5 µs a byte on a laptop,
 * so no link keeps a tablet busy for long. Chosen: sixteen times a drawing of 5,000 pen points.
 */
export const MODELLED_BYTES = 64 * 1024;

/** Reading would give more than `MODELLED_BYTES`. */
export class TooManyBytes extends Error {}

/** Writes values one after the other; an unlikely value takes more bits (`value-model.ts`). */
export class ModelWriter extends OrderedWriter {
  private readonly coder = new RangeEncoder();
  private readonly model = new ValueModel((yes, bit) => {
    this.coder.encode(bit, yes);
    return bit;
  }, taughtModel());

  uint(column: number, value: number, near?: readonly number[]): void {
    if (column === WORDS) this.model.unit(value);
    else this.model.uint(column, value, near);
  }

  byte(column: number, value: number): void {
    this.uint(column, value);
  }

  /** Everything that was written. */
  bytes(): Uint8Array {
    return this.coder.bytes();
  }
}

/** Reads what a `ModelWriter` wrote. Throws `DamagedBytes` for anything else, `TooManyBytes` if it does not end. */
export class ModelReader extends OrderedReader {
  private readonly coder: RangeDecoder;
  private readonly model: ValueModel;
  private room = MODELLED_BYTES;

  constructor(bytes: Uint8Array) {
    super();
    this.coder = new RangeDecoder(bytes);
    this.model = new ValueModel((yes) => this.coder.decode(yes), taughtModel());
  }

  uint(column: number, near?: readonly number[]): number {
    const value = column === WORDS ? this.model.unit(0) : this.model.uint(column, 0, near);
    this.room -= varintBytes(value);
    if (this.room < 0) throw new TooManyBytes();
    return value;
  }

  byte(column: number): number {
    const value = this.uint(column);
    if (value > 0xff) throw new DamagedBytes();
    return value;
  }

  left(): number {
    return this.room;
  }

  /** True if everything was read. */
  get isAtEnd(): boolean {
    return this.coder.isAtEnd;
  }
}

/** A model that has read the likely text; made once. */
function taughtModel(): ValueModel {
  if (taught !== null) return taught;
  taught = new ValueModel((_, bit) => bit);
  for (let index = 0; index < LIKELY_TEXT.length; index += 1) taught.unit(LIKELY_TEXT.charCodeAt(index));
  return taught;
}
let taught: ValueModel | null = null;
