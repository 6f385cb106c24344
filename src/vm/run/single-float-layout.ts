// What the ways to write a single float's digits share.

export const single = Math.fround;

/** The single next to a power of ten. */
export const powerOfTen = (power: number): number => single(Number(`1e${power}`));

type Style = 'e' | 'f' | 'g';

/** How the digits of a number are set. */
export interface Layout {
  style: Style;
  /** The remainder of the number. */
  rest: number;
  /** Size of the decimal exponent. */
  exponent: number;
  /** Sign of the exponent, if it is shown. */
  exponentSign: '' | '+' | '-';
  precision: number;
  /** Digits still to write. */
  digits: number;
  /** Digits before the one after which the point stands; negative: it is written already. */
  point: number;
}

/** One version's way from a number to its digits. */
export interface Digits {
  /** True if a digit that rounding adds pushes the last one out of a full buffer. */
  readonly keepsInBuffer: boolean;
  /** Lays out a number below 1; zeros that it starts with may go to `text`. */
  belowOne(layout: Layout, room: number, text: string[]): void;
  /** Finds the exponent of a number from 1. */
  fromOne(layout: Layout): void;
  /** Writes the digits; `true`: the last one is to be rounded up. */
  write(layout: Layout, text: string[], asked: Style): boolean;
}

/** Bytes of the shortest number with an exponent: `9e+99` and a closing zero. */
export const EXPONENT_ROOM = 6;

/** Lays out a number below 1 that is shown with an exponent. */
export function layOutSmall(layout: Layout, room: number, exponentSign: '+' | '-'): void {
  layout.exponentSign = exponentSign;
  if (layout.precision > room - EXPONENT_ROOM) layout.precision = room - EXPONENT_ROOM + (layout.style === 'g' ? 1 : 0);
}
