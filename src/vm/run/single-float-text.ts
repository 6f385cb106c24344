// Single floats and decimal digits, as the board's MicroPython turns one into the other: in single precision, so that
// the last of many digits may be off, there and here alike. Its version says how.
import { scaledDigits, subtractedDigits } from './single-float-digits';
import { EXPONENT_ROOM, powerOfTen, single, type Digits, type Layout } from './single-float-layout';

/** The board's buffers, in bytes: for `print` and `str`, and for formats such as `%f`. */
const REPR_BUFFER = 16;
const FORMAT_BUFFER = 32;
/** Digits that `print` shows. */
const REPR_DIGITS = 7;
/** The precision by which the firmware's C asks for as many digits as `repr` shows. */
const REPR_PRECISION = 99;
/** The MicroPython 1.x since which decimal numbers are read and written differently. */
const NEWER_MINOR = 20;

/**
 * Writes a number as the board's firmware does.
 *
 * @param minor the firmware's MicroPython: 18 for 1.18
 * @param letter character code of `e`, `f` or `g`; a capital letter gives a capital exponent
 * @param precision digits (as in `%.3f`); negative: 6
 * @param sign character code of what stands before numbers that are not negative; 0: nothing
 */
export function formatSingle(minor: number, value: number, letter: number, precision: number, sign: number): string {
  const way = minor < NEWER_MINOR ? scaledDigits : subtractedDigits;
  const repr = precision === REPR_PRECISION;
  const negative = value < 0 || Object.is(value, -0);
  const prefix = negative ? '-' : sign === 0 ? '' : String.fromCharCode(sign);
  const capital = (letter & 0x20) === 0;
  if (!Number.isFinite(value)) {
    const name = Number.isNaN(value) ? 'nan' : 'inf';
    return prefix + (capital ? name.toUpperCase() : name);
  }
  const asked = String.fromCharCode(letter | 0x20) as Layout['style'];
  const buffer = repr ? REPR_BUFFER : FORMAT_BUFFER;
  const room = buffer - 1 - prefix.length;
  const text = prefix.split('');
  const layout: Layout = {
    style: asked,
    rest: single(Math.abs(value)),
    exponent: 0,
    exponentSign: '',
    precision: repr ? REPR_DIGITS : precision < 0 ? 6 : asked === 'g' && precision === 0 ? 1 : precision,
    digits: 0,
    point: 0,
  };
  if (layout.rest === 0) layOutZero(layout, room);
  else if (layout.rest < 1) way.belowOne(layout, room, text);
  else layOutFromOne(layout, room, way);
  layout.precision = Math.max(0, layout.precision);
  if (layout.style === 'e') layout.digits = layout.precision + 1;
  else if (layout.style === 'g') layout.digits = layout.precision = Math.max(1, layout.precision);
  if (way.write(layout, text, asked)) roundUp(layout, text, way.keepsInBuffer ? buffer - 1 : Infinity);
  if (asked === 'g' && layout.precision > 0) dropZeros(text);
  if (layout.exponentSign !== '') text.push(capital ? 'E' : 'e', layout.exponentSign, twoDigits(layout.exponent));
  return text.join('');
}

const twoDigits = (number: number): string => String(number % 100).padStart(2, '0');

function layOutZero(layout: Layout, room: number): void {
  if (layout.style === 'f') {
    layout.precision = Math.min(layout.precision, room - 2);
    layout.digits = layout.precision + 1;
  } else {
    layout.precision = Math.min(layout.precision, room - EXPONENT_ROOM);
    if (layout.style === 'e') layout.exponentSign = '+';
  }
}

function layOutFromOne(layout: Layout, room: number, way: Digits): void {
  way.fromOne(layout);
  fitFromOne(layout, room);
  if (layout.style === 'g' && layout.exponent < layout.precision) {
    layout.style = 'f';
    layout.precision -= layout.exponent + 1;
  }
  if (layout.style === 'f') {
    layout.point = layout.exponent;
    layout.digits = layout.precision + layout.exponent + 1;
  } else {
    layout.exponentSign = '+';
  }
}

/** Takes digits away, or the style, where the board's buffer has no room. */
function fitFromOne(layout: Layout, room: number): void {
  const { exponent } = layout;
  if (layout.style === 'f' && exponent >= room) layout.style = 'e';
  else if (layout.style === 'f' && exponent + layout.precision + 2 > room) {
    layout.precision = room - exponent - 2;
    if (layout.precision < 0) layout.precision++; // without a point
  }
  if (layout.style === 'e') layout.precision = Math.min(layout.precision, room - EXPONENT_ROOM);
  if (layout.style === 'g') layout.precision = Math.min(layout.precision, room - EXPONENT_ROOM + 1);
}

/** Adds one to the last digit; where that makes the text longer than it may be, the last digit goes. */
function roundUp(layout: Layout, text: string[], longest: number): void {
  let at = text.length - 1;
  for (; at >= 0; at--) {
    const character = text[at] ?? '';
    if (character === '.') continue;
    if (character < '0' || character > '9') break;
    if (character < '9') {
      text[at] = String(Number(character) + 1);
      return;
    }
    text[at] = '0';
  }
  // All digits were nines: the first one to be zero now gets a 1 before it.
  const first = at + 1;
  if (text[first] !== '0') return;
  if (text[first + 1] === '.' && layout.style !== 'f') {
    text[first] = '.';
    text[first + 1] = '0';
    if (layout.exponentSign === '-') {
      if (--layout.exponent === 0) layout.exponentSign = '+';
    } else {
      layout.exponent++;
    }
    text.pop();
  }
  text.splice(first, 0, '1');
  if (text.length > longest) text.pop();
}

function dropZeros(text: string[]): void {
  while (text.at(-1) === '0') text.pop();
  if (text.at(-1) === '.') text.pop();
}

/** Digits beyond this value only move the exponent. */
const MANTISSA_LIMIT = single(1e20);
/** The smallest power of ten that a single holds with all its digits. */
const SMALLEST_POWER = -37;
/** Powers of ten up to this one are exact in a single. */
const EXACT_POWER = 9;

/** The number that the board reads: digits with an optional point, exponent and underscores. */
export function parseSingle(minor: number, text: string): number {
  const [, whole = '', fraction = '', power = '0'] = /^([\d_]*)\.?([\d_]*)(?:e([-+]?[\d_]+))?/i.exec(text) ?? [];
  const read = { mantissa: 0, exponent: 0 };
  const zeros = { whole: 0, fraction: 0 };
  const accept = (digit: number, inFraction: boolean): void => {
    if (read.mantissa < MANTISSA_LIMIT) {
      read.mantissa = single(single(10 * read.mantissa) + digit);
      if (inFraction) read.exponent--;
    } else if (!inFraction) {
      read.exponent++;
    }
  };
  for (const part of ['whole', 'fraction'] as const)
    for (const character of (part === 'whole' ? whole : fraction).replaceAll('_', '')) {
      const digit = Number(character);
      // In a newer MicroPython zeros wait until another digit shows that they count.
      if (minor >= NEWER_MINOR && (digit === 0 || read.mantissa >= MANTISSA_LIMIT)) {
        zeros[part]++;
        continue;
      }
      for (; zeros.whole > 0; zeros.whole--) accept(0, false);
      for (; zeros.fraction > 0; zeros.fraction--) accept(0, true);
      accept(digit, part === 'fraction');
    }
  let exponent = Number(power.replaceAll('_', '')) + read.exponent + zeros.whole;
  if (exponent < SMALLEST_POWER) {
    exponent -= SMALLEST_POWER;
    read.mantissa = single(read.mantissa * powerOfTen(SMALLEST_POWER));
  }
  return exponent < 0 && exponent >= -EXACT_POWER
    ? single(read.mantissa / powerOfTen(-exponent))
    : single(read.mantissa * powerOfTen(exponent));
}
