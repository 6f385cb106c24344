// The two ways of MicroPython from a single float to its digits, py/formatfloat.c before and since 1.20.
import { layOutSmall, powerOfTen, single, type Digits, type Layout } from './single-float-layout';

/** From here on a number below 1 counts as 1. */
const ALMOST_ONE = single(0.9999995);

const POWERS = [32, 16, 8, 4, 2, 1].map((power) => ({ power, up: powerOfTen(power), down: powerOfTen(-power) }));

/**
 * Before 1.20: the number is brought between 1 and 10 first. Each product on the way is rounded, so that the last of
 * seven digits may be off.
 */
export const scaledDigits: Digits = {
  keepsInBuffer: false,
  belowOne(layout, room, text) {
    const first = layout.rest >= ALMOST_ONE ? '1' : '0';
    const exponentSign = scaleUp(layout);
    if (layout.style === 'e' || (layout.style === 'g' && layout.exponent > 4)) {
      layOutSmall(layout, room, exponentSign);
      return;
    }
    if (layout.style === 'g') layout.precision += layout.exponent - 1;
    layout.style = 'f';
    layout.point = -1;
    text.push(first);
    layout.precision = Math.min(layout.precision, room - 2);
    layout.digits = layout.precision;
    if (layout.digits === 0) return;
    text.push('.');
    while (--layout.exponent !== 0 && layout.digits !== 0) {
      text.push('0');
      layout.digits--;
    }
  },
  fromOne(layout) {
    for (const { power, up, down } of POWERS)
      if (up <= layout.rest) {
        layout.exponent += power;
        layout.rest = single(layout.rest * down);
      }
    if (layout.rest >= 10) {
      layout.exponent++;
      layout.rest = single(layout.rest * single(0.1));
    }
  },
  write(layout, text, asked) {
    let { point } = layout;
    for (let count = 0; count < layout.digits; count++, point--) {
      const digit = Math.trunc(layout.rest);
      text.push(digit < 0 ? '0' : String.fromCharCode(48 + digit));
      if (point === 0 && layout.precision > 0) text.push('.');
      layout.rest = single(single(layout.rest - digit) * 10);
    }
    // Where the digit to round by is too far away, `%f` has nothing to round.
    return (asked !== 'f' || layout.exponent <= layout.digits) && layout.rest >= 5;
  },
};

/** Multiplies a number below 1 until it is at least 1. Returns its exponent's sign. */
function scaleUp(layout: Layout): '+' | '-' {
  for (const { power, up, down } of POWERS)
    if (down > layout.rest) {
      layout.exponent += power;
      layout.rest = single(layout.rest * up);
    }
  if (layout.rest >= 1) return '-';
  if (layout.rest >= ALMOST_ONE) {
    layout.rest = 1;
    return layout.exponent === 0 ? '+' : '-';
  }
  layout.exponent++;
  layout.rest = single(layout.rest * 10);
  return '-';
}

/** 1 / log2(10) */
const DIGITS_PER_BIT = single(0.3010299956639812);
const bits = new DataView(new ArrayBuffer(4));

/** The decimal exponent of a number by its binary one: never further from 0 than the true one. */
function guessExponent(value: number): number {
  bits.setFloat32(0, value);
  return Math.trunc(single(((bits.getUint32(0) >>> 23) - 127) * DIGITS_PER_BIT));
}

/** Since 1.20: powers of ten are taken off the number as it is, so that whole numbers are written exactly. */
export const subtractedDigits: Digits = {
  keepsInBuffer: true,
  belowOne(layout, room) {
    layout.exponent = -guessExponent(layout.rest);
    while (powerOfTen(-layout.exponent) > layout.rest) layout.exponent++;
    if (layout.style === 'e' || (layout.style === 'g' && layout.exponent > 4)) {
      layout.rest = single(layout.rest / powerOfTen(-layout.exponent));
      layOutSmall(layout, room, '-');
      return;
    }
    if (layout.style === 'g') layout.precision += layout.exponent - 1;
    layout.style = 'f';
    layout.precision = Math.min(layout.precision, room - 2);
    layout.digits = layout.precision + 1;
  },
  fromOne(layout) {
    layout.exponent = guessExponent(layout.rest);
    while (layout.rest >= powerOfTen(layout.exponent + 1)) layout.exponent++;
  },
  write(layout, text) {
    let { point } = layout;
    let place = layout.exponentSign === '-' || layout.rest < 1 ? 0 : layout.exponent;
    let digit = 0;
    // One more digit than is shown, to round by.
    for (let count = 0; count <= layout.digits; count++, point--, place--) {
      const unit = powerOfTen(Math.max(0, place));
      for (digit = 0; digit < 9 && layout.rest >= unit; digit++) layout.rest = single(layout.rest - unit);
      if (count < layout.digits) {
        text.push(String(digit));
        if (point === 0 && layout.precision > 0) text.push('.');
      }
      // Below 1 the rest grows instead: this keeps 1/16 and the like exact.
      if (place <= 0) layout.rest = single(layout.rest * 10);
    }
    return digit >= 5;
  },
};
