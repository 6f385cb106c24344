import type { Board } from '#board/board';
import { numberOf, textOf, wholeOf } from '../arguments';
import type { Machine, SyscallTable, Value } from '../syscall';

const SIDE = 5;
const BRIGHTEST = 9;
const ZERO = 0x30;

/**
 * An image in Python's memory is one buffer: its width and its height in two bytes each, a byte that is 1 if it cannot
 * be modified, and its pixels, a byte each (0 to 9), row after row.
 */
const IMAGE_HEAD = 5;
const CONSTANT = 4;

/** The result of image_pixel, image_set and image_fill if they fail: a wrong place or brightness, a constant image. */
const BAD_PLACE = -1;

const single = Math.fround;

/**
 * Images, given by the addresses of their buffers. The library has checked arguments, and made the buffers of new images
 * large enough.
 *
 * - image_head(to, width, height): makes a buffer an image · image_unpack(bits, to): a built-in image, 25 bits, first
 *   row in the highest
 * - image_size(text) → width · 2¹² + height of a picture written in digits, lines ended by `:` or a line's end ·
 *   image_parse(to): that picture → False at a character that no picture has
 * - image_limit(image): what is brighter than 9 becomes 9
 * - image_sum(a, b, sign, to) → False if they differ in size · image_scale(a, factor, to) · image_invert(a, to) ·
 *   image_copy(a, to) · image_crop(a, x, y, width, height, to)
 * - image_width(image), image_height(image)
 * - image_fill(image, value), image_set(image, x, y, value) → 0, or −1 at a wrong place or brightness, and if the image
 *   cannot be modified · image_pixel(image, x, y) → its value or −1
 * - image_blit(from, x, y, to, xTo, yTo, width, height): pixels outside the source are dark, those outside the target
 *   are dropped; source and target may be the same
 * - image_text(image, lines) → the image as Python writes it, on one line or with a line for each row
 */
export function createImageCalls(machine: Machine, board: Board): SyscallTable {
  const charge = chargeFor(machine, board);
  return {
    ...makeCalls(machine, board, charge),
    ...arithmeticCalls(machine, board, charge),
    ...pixelCalls(machine, board, charge),
    ...partCalls(machine, board, charge),
  };
}

/** An image as it lies in memory. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly isConstant: boolean;
  readonly pixels: Uint8Array;
}

/** The image whose buffer is at this address: a view, valid until the syscall returns. */
export function pictureAt(machine: Machine, address: Value | undefined): Picture {
  const start = wholeOf(address) ?? 0;
  const head = machine.memory(start, IMAGE_HEAD);
  const width = sizeIn(head, 0);
  const height = sizeIn(head, 2);
  const pixels = machine.memory(start + IMAGE_HEAD, width * height);
  return { width, height, isConstant: head[CONSTANT] === 1, pixels };
}

const sizeIn = (head: Uint8Array, place: number): number => (head[place] ?? 0) + ((head[place + 1] ?? 0) << 8);

/** Writes the head of a new image. */
function newPicture(machine: Machine, address: Value | undefined, width: number, height: number): Picture {
  const head = machine.memory(wholeOf(address) ?? 0, IMAGE_HEAD);
  head[0] = width;
  head[1] = width >> 8;
  head[2] = height;
  head[3] = height >> 8;
  head[CONSTANT] = 0;
  return pictureAt(machine, address);
}

/** Charges a call that makes or changes `count` pixels; a new image is one object more on the heap. */
type Charge = (count: number, pixelUs: number, made?: 'new' | 'same') => void;

const chargeFor =
  (machine: Machine, { type: { costsUs } }: Board): Charge =>
  (count, pixelUs, made = 'new') =>
    machine.spend(costsUs.callUs + count * pixelUs + (made === 'new' ? costsUs.allocationUs : 0));

/** No image is larger: all of the program's memory holds fewer pixels. */
const MOST = 65_536;
const whole = (value: Value | undefined): number => Math.max(-MOST, Math.min(wholeOf(value) ?? 0, MOST));
const size = (value: Value | undefined): number => Math.max(whole(value), 0);

/** The rows of a picture's text. */
function rowsOf(text: string): readonly string[] {
  const rows = text.replaceAll('\n', ':').split(':');
  return rows.at(-1) === '' ? rows.slice(0, -1) : rows;
}

function makeCalls(machine: Machine, board: Board, charge: Charge): SyscallTable {
  const { pixelMoveUs, pixelTextUs } = board.type.costsUs;
  let written = '';
  return {
    image_head: (to, width, height) => {
      newPicture(machine, to, size(width), size(height));
      return null;
    },
    image_unpack: (bits, to) => {
      const all = wholeOf(bits) ?? 0;
      const { pixels } = newPicture(machine, to, SIDE, SIDE);
      for (let i = 0; i < SIDE * SIDE; i++) pixels[i] = ((all >> (SIDE * SIDE - 1 - i)) & 1) * BRIGHTEST;
      machine.memory(wholeOf(to) ?? 0, IMAGE_HEAD)[CONSTANT] = 1;
      return null;
    },
    image_size: (text) => {
      written = textOf(text);
      const rows = rowsOf(written);
      return (rows.reduce((most, row) => Math.max(most, row.length), 0) << 12) + rows.length;
    },
    image_parse: (to) => {
      const rows = rowsOf(written);
      const width = rows.reduce((most, row) => Math.max(most, row.length), 0);
      const { pixels } = newPicture(machine, to, width, rows.length);
      charge(written.length, pixelTextUs);
      for (let y = 0; y < rows.length; y++) {
        const row = rows[y] ?? '';
        for (let x = 0; x < row.length; x++) {
          const value = row.charCodeAt(x) - ZERO;
          if (value > BRIGHTEST) return false;
          // Below '0' the device stores whatever comes out; only a space is meant to be dark.
          pixels[y * width + x] = Math.max(value, 0);
        }
      }
      return true;
    },
    image_limit: (image) => {
      const { pixels } = pictureAt(machine, image);
      charge(pixels.length, pixelMoveUs);
      for (let i = 0; i < pixels.length; i++) pixels[i] = Math.min(pixels[i] ?? 0, BRIGHTEST);
      return null;
    },
    image_text: (image, lines) => {
      const { width, height, pixels } = pictureAt(machine, image);
      charge(pixels.length, pixelTextUs);
      const [before, between, after] = lines === true ? ["Image(\n    '", "'\n    '", "'\n)"] : ["Image('", '', "')"];
      let text = before;
      for (let y = 0; y < height; y++) {
        if (y > 0) text += between;
        for (let x = 0; x < width; x++) text += String.fromCharCode(ZERO + (pixels[y * width + x] ?? 0));
        text += ':';
      }
      return text + after;
    },
  };
}

function arithmeticCalls(machine: Machine, board: Board, charge: Charge): SyscallTable {
  const { pixelMoveUs, pixelSumUs, pixelScaleUs } = board.type.costsUs;
  const like = (to: Value | undefined, { width, height }: Picture): Uint8Array =>
    newPicture(machine, to, width, height).pixels;
  return {
    image_sum: (a, b, sign, to) => {
      const [first, second] = [pictureAt(machine, a), pictureAt(machine, b)];
      if (first.width !== second.width || first.height !== second.height) return false;
      const sum = like(to, first);
      const times = whole(sign);
      charge(sum.length, pixelSumUs);
      for (let i = 0; i < sum.length; i++) {
        const value = (first.pixels[i] ?? 0) + times * (second.pixels[i] ?? 0);
        sum[i] = Math.min(Math.max(value, 0), BRIGHTEST);
      }
      return true;
    },
    // micropython-microbit-v2 v2.1.2, image_dim: both loops go up to the width, so rows beyond it stay dark.
    image_scale: (a, factor, to) => {
      const given = pictureAt(machine, a);
      const scaled = like(to, given);
      const count = given.width * given.width;
      charge(Math.min(count, MOST), pixelScaleUs);
      const by = single(typeof factor === 'number' ? factor : (numberOf(factor) ?? 0));
      scaled.fill(0);
      for (let i = 0; i < Math.min(count, scaled.length); i++) {
        const value = (given.pixels[i] ?? 0) * by + 0.5;
        scaled[i] = value < BRIGHTEST ? Math.trunc(value) : BRIGHTEST; // 0 × ∞, which is no number, is bright in C, too
      }
      return null;
    },
    image_invert: (a, to) => {
      const given = pictureAt(machine, a);
      const inverted = like(to, given);
      charge(inverted.length, pixelMoveUs);
      for (let i = 0; i < inverted.length; i++) inverted[i] = BRIGHTEST - (given.pixels[i] ?? 0);
      return null;
    },
    image_copy: (a, to) => {
      const given = pictureAt(machine, a);
      charge(given.pixels.length, pixelMoveUs);
      like(to, given).set(given.pixels);
      return null;
    },
  };
}

function pixelCalls(machine: Machine, board: Board, charge: Charge): SyscallTable {
  const { pixelMoveUs } = board.type.costsUs;
  /** The buffer of an image, with what follows it: one view is quicker made than one of the head and one of the pixels. */
  const bufferAt = (image: Value | undefined): Uint8Array => machine.memory(wholeOf(image) ?? 0, IMAGE_HEAD + MOST);
  /** The place of a pixel in its image's buffer, or −1. */
  const placeIn = (buffer: Uint8Array, x: number, y: number): number => {
    const width = sizeIn(buffer, 0);
    return x >= 0 && y >= 0 && x < width && y < sizeIn(buffer, 2) ? IMAGE_HEAD + y * width + x : BAD_PLACE;
  };
  const isBrightness = (value: number): boolean => value >= 0 && value <= BRIGHTEST;
  const { callUs } = board.type.costsUs;
  return {
    image_width: (image) => {
      machine.spend(callUs);
      return sizeIn(bufferAt(image), 0);
    },
    image_height: (image) => {
      machine.spend(callUs);
      return sizeIn(bufferAt(image), 2);
    },
    image_pixel: (image, x, y) => {
      charge(1, pixelMoveUs / 2, 'same');
      const buffer = bufferAt(image);
      const place = placeIn(buffer, whole(x), whole(y));
      return place < 0 ? BAD_PLACE : (buffer[place] ?? 0);
    },
    image_set: (image, x, y, value) => {
      const buffer = bufferAt(image);
      if (buffer[CONSTANT] === 1 || !isBrightness(whole(value))) return BAD_PLACE;
      charge(1, pixelMoveUs / 2, 'same');
      const place = placeIn(buffer, whole(x), whole(y));
      if (place < 0) return BAD_PLACE;
      buffer[place] = whole(value);
      return 0;
    },
    image_fill: (image, value) => {
      const { isConstant, pixels } = pictureAt(machine, image);
      if (isConstant || !isBrightness(whole(value))) return BAD_PLACE;
      charge(pixels.length, pixelMoveUs / 2, 'same');
      pixels.fill(whole(value));
      return 0;
    },
  };
}

function partCalls(machine: Machine, board: Board, charge: Charge): SyscallTable {
  const { pixelMoveUs } = board.type.costsUs;
  /** Copies a part of the source from (x, y) to (left, top) in the target. */
  const blit = (from: Picture, x: number, y: number, to: Picture, left: number, top: number, w: number, h: number) => {
    charge(Math.min(Math.max(w, 0) * Math.max(h, 0), MOST), pixelMoveUs);
    if (to.pixels.length < to.width * to.height) return;
    for (let row = Math.max(-top, 0); row < Math.min(h, to.height - top); row++)
      for (let column = Math.max(-left, 0); column < Math.min(w, to.width - left); column++) {
        const [fromX, fromY] = [x + column, y + row];
        const inside = fromX >= 0 && fromX < from.width && fromY >= 0 && fromY < from.height;
        to.pixels[(top + row) * to.width + left + column] = inside ? (from.pixels[fromY * from.width + fromX] ?? 0) : 0;
      }
  };
  return {
    image_crop: (a, x, y, width, height, to) => {
      const [w, h] = [size(width), size(height)];
      blit(pictureAt(machine, a), whole(x), whole(y), newPicture(machine, to, w, h), 0, 0, w, h);
      return null;
    },
    image_blit: (a, x, y, to, xTo, yTo, width, height) => {
      const from = pictureAt(machine, a);
      const apart = { ...from, pixels: from.pixels.slice() };
      const target = pictureAt(machine, to);
      blit(apart, whole(x), whole(y), target, whole(xTo), whole(yTo), whole(width), whole(height));
      return null;
    },
  };
}
