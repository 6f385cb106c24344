import { emptyPixels, type Pixels } from './pixels';
import type { Extent, Quad } from './quad';

/**
 * The part of a picture between four corners, seen from straight above: its pixels are looked up where the perspective of
 * the four corners puts them, each mixed from its four neighbours. Only + − × ÷ and rounding: every engine makes the
 * same of the same pixels.
 */
export function straightened(picture: Pixels, quad: Quad, { width, height }: Extent): Pixels {
  const out = emptyPixels(width, height);
  const { x, y, w } = perspectiveOf(quad);
  for (let row = 0; row < height; row += 1) {
    const v = 2 * row + 1; // the middle of a pixel: half a pixel is 1
    for (let column = 0; column < width; column += 1) {
      const u = 2 * column + 1;
      const at = (axis: Axis): number => axis.u * u * height + axis.v * v * width + axis.one * 2 * width * height;
      const depth = at(w);
      mix(picture, Math.round((256 * at(x)) / depth) - 128, Math.round((256 * at(y)) / depth) - 128, out, row * width + column); // prettier-ignore
    }
  }
  return out;
}

/** One row of the matrix of a perspective: what it takes of u and v (0 … 1) and of 1. */
interface Axis {
  readonly u: number;
  readonly v: number;
  readonly one: number;
}

/**
 * The perspective that takes the corners of the unit square to those of a quadrilateral, x/w and y/w: Heckbert,
 * _Fundamentals of Texture Mapping_ (1989), 2.2.3, times its denominator, so that all figures are whole.
 */
function perspectiveOf([one, two, three, four]: Quad): { readonly x: Axis; readonly y: Axis; readonly w: Axis } {
  const [dx1, dx2] = [two[0] - three[0], four[0] - three[0]];
  const [dy1, dy2] = [two[1] - three[1], four[1] - three[1]];
  const sumX = one[0] - two[0] + three[0] - four[0];
  const sumY = one[1] - two[1] + three[1] - four[1];
  const whole = dx1 * dy2 - dx2 * dy1;
  const w = { u: sumX * dy2 - dx2 * sumY, v: dx1 * sumY - sumX * dy1, one: whole };
  const axis = (i: 0 | 1): Axis => ({
    u: (two[i] - one[i]) * whole + w.u * two[i],
    v: (four[i] - one[i]) * whole + w.v * four[i],
    one: one[i] * whole,
  });
  return { x: axis(0), y: axis(1), w };
}

/** Writes the pixel at a place in 256ths of a pixel, mixed from the four around it; the edge goes on outside. */
function mix({ width, height, data }: Pixels, x: number, y: number, out: Pixels, index: number): void {
  const [right, below] = [x & 255, y & 255];
  const column = 4 * clamp(x >> 8, width);
  const nextColumn = 4 * clamp((x >> 8) + 1, width);
  const row = 4 * width * clamp(y >> 8, height);
  const nextRow = 4 * width * clamp((y >> 8) + 1, height);
  for (let channel = 0; channel < 4; channel += 1) {
    const upper = (data[row + column + channel] ?? 0) * (256 - right) + (data[row + nextColumn + channel] ?? 0) * right;
    const lower =
      (data[nextRow + column + channel] ?? 0) * (256 - right) + (data[nextRow + nextColumn + channel] ?? 0) * right;
    out.data[4 * index + channel] = (upper * (256 - below) + lower * below + 32768) >> 16;
  }
}

const clamp = (at: number, length: number): number => (at < 0 ? 0 : at < length ? at : length - 1);
