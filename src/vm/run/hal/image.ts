import type { Board } from '#board/board';
import { numberOf, textOf, wholeOf } from '../arguments';
import type { Machine, SyscallTable, Value } from '../syscall';

const SIDE = 5;
const BRIGHTEST = 9;
const ZERO = 0x30;

const single = Math.fround;

/**
 * The pixels of images, a byte each (0 to 9), row after row. Addresses are those of buffers in Python's memory; the
 * library has checked arguments and sizes.
 *
 * - image_unpack(bits, to): a built-in image, 25 bits, first row in the highest, as 25 pixels
 * - image_size(text) → width · 2¹² + height of a picture written in digits, lines ended by `:` or a line's end
 * - image_parse(text, to, width) → False at a character that no picture has
 * - image_limit(at, count): what is brighter than 9 becomes 9
 * - image_sum(a, b, count, sign, to), image_scale(a, width, height, factor, to), image_invert(a, count, to)
 * - image_fill(at, count, value) · image_pixel(): one of them is read or set
 * - image_blit(from, fromWidth, fromHeight, x, y, to, toWidth, toHeight, xTo, yTo, width, height): pixels outside the
 *   source are dark, those outside the target are dropped; source and target may be the same
 * - image_text(at, width, height, between) → the digits of the rows, each with `:` behind it, and `between` between them
 */
export function createImageCalls(machine: Machine, board: Board): SyscallTable {
  return { ...makeCalls(machine, board), ...changeCalls(machine, board) };
}

/** What a call that makes or changes so many pixels costs; what it makes is one object more on the heap. */
type Charge = (count: number, pixelUs: number, made?: 'new' | 'same') => void;

const chargeFor =
  (machine: Machine, { type: { costsUs } }: Board): Charge =>
  (count, pixelUs, made = 'new') =>
    machine.spend(costsUs.callUs + count * pixelUs + (made === 'new' ? costsUs.allocationUs : 0));

/** No image is larger: all of the program's memory holds fewer pixels. */
const MOST = 65_536;
const whole = (value: Value | undefined): number => Math.max(-MOST, Math.min(wholeOf(value) ?? 0, MOST));
/** The pixels of an image; no more than there can be. */
const area = (width: number, height: number): number => Math.min(Math.max(width, 0) * Math.max(height, 0), MOST);

/** The rows of a picture's text. */
function rowsOf(text: string): readonly string[] {
  const rows = text.replaceAll('\n', ':').split(':');
  return rows.at(-1) === '' ? rows.slice(0, -1) : rows;
}

function makeCalls(machine: Machine, board: Board): SyscallTable {
  const { pixelMoveUs, pixelTextUs } = board.type.costsUs;
  const charge = chargeFor(machine, board);
  const pixels = (address: Value | undefined, count: number): Uint8Array =>
    machine.memory(wholeOf(address) ?? 0, count);
  return {
    image_unpack: (bits, to) => {
      const all = wholeOf(bits) ?? 0;
      const target = pixels(to, SIDE * SIDE);
      for (let i = 0; i < SIDE * SIDE; i++) target[i] = ((all >> (SIDE * SIDE - 1 - i)) & 1) * BRIGHTEST;
      return null;
    },
    image_size: (text) => {
      const rows = rowsOf(textOf(text));
      return (rows.reduce((most, row) => Math.max(most, row.length), 0) << 12) + rows.length;
    },
    image_parse: (text, to, width) => {
      const rows = rowsOf(textOf(text));
      const target = pixels(to, area(rows.length, whole(width)));
      charge(textOf(text).length, pixelTextUs);
      for (const [y, row] of rows.entries())
        for (let x = 0; x < row.length; x++) {
          const value = row.charCodeAt(x) - ZERO;
          if (value > BRIGHTEST) return false;
          // Below '0' the device stores whatever comes out; only a space is meant to be dark.
          target[y * whole(width) + x] = Math.max(value, 0);
        }
      return true;
    },
    image_limit: (at, count) => {
      const given = pixels(at, whole(count));
      charge(given.length, pixelMoveUs);
      for (let i = 0; i < given.length; i++) given[i] = Math.min(given[i] ?? 0, BRIGHTEST);
      return null;
    },
    image_text: (at, width, height, between) => {
      const [w, h] = [whole(width), whole(height)];
      const given = pixels(at, area(w, h));
      charge(given.length, pixelTextUs);
      const rows = Array.from({ length: Math.max(h, 0) }, (_, y) => `${given.subarray(y * w, (y + 1) * w).join('')}:`);
      return rows.join(textOf(between));
    },
  };
}

function changeCalls(machine: Machine, board: Board): SyscallTable {
  const { pixelMoveUs, pixelSumUs, pixelScaleUs } = board.type.costsUs;
  const charge = chargeFor(machine, board);
  const pixels = (address: Value | undefined, count: number): Uint8Array =>
    machine.memory(wholeOf(address) ?? 0, count);
  return {
    image_sum: (a, b, count, sign, to) => {
      const [first, second] = [pixels(a, whole(count)), pixels(b, whole(count))];
      const sum = pixels(to, whole(count));
      charge(sum.length, pixelSumUs);
      for (let i = 0; i < sum.length; i++)
        sum[i] = Math.min(Math.max((first[i] ?? 0) + whole(sign) * (second[i] ?? 0), 0), BRIGHTEST);
      return null;
    },
    // micropython-microbit-v2 v2.1.2, image_dim: both loops go up to the width, so rows beyond it stay dark.
    image_scale: (a, width, height, factor, to) => {
      const [w, h] = [whole(width), whole(height)];
      const [given, scaled] = [pixels(a, area(w, h)), pixels(to, area(w, h))];
      charge(area(w, w), pixelScaleUs);
      const by = single(numberOf(factor) ?? 0);
      scaled.fill(0);
      for (let i = 0; i < Math.min(w * w, scaled.length); i++)
        scaled[i] = Math.min(Math.trunc((given[i] ?? 0) * by + 0.5), BRIGHTEST);
      return null;
    },
    image_invert: (a, count, to) => {
      const [given, inverted] = [pixels(a, whole(count)), pixels(to, whole(count))];
      charge(given.length, pixelMoveUs);
      for (let i = 0; i < given.length; i++) inverted[i] = BRIGHTEST - (given[i] ?? 0);
      return null;
    },
    image_pixel: () => {
      charge(1, pixelMoveUs / 2, 'same');
      return null;
    },
    image_fill: (at, count, value) => {
      const target = pixels(at, whole(count));
      charge(target.length, pixelMoveUs / 2, 'same');
      target.fill(whole(value));
      return null;
    },
    image_blit: (from, fromWidth, fromHeight, x, y, to, toWidth, toHeight, xTo, yTo, width, height) => {
      const [fw, fh, tw, th] = [whole(fromWidth), whole(fromHeight), whole(toWidth), whole(toHeight)];
      const [left, top] = [whole(xTo), whole(yTo)];
      const given = pixels(from, area(fw, fh)).slice();
      const target = pixels(to, area(tw, th));
      charge(area(whole(width), whole(height)), pixelMoveUs);
      if (target.length < tw * th) return null;
      for (let row = Math.max(-top, 0); row < Math.min(whole(height), th - top); row++)
        for (let column = Math.max(-left, 0); column < Math.min(whole(width), tw - left); column++) {
          const [fromX, fromY] = [whole(x) + column, whole(y) + row];
          const inside = fromX >= 0 && fromX < fw && fromY >= 0 && fromY < fh;
          target[(top + row) * tw + left + column] = inside ? (given[fromY * fw + fromX] ?? 0) : 0;
        }
      return null;
    },
  };
}
