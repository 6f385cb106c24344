import type { Point } from '#scene/scene';

import { element, escapeXml, pathThrough } from './svg-write';
import type { ToPicture } from './kind';

/** Fonts of the texts in a picture; every viewer has one of them. */
export const SVG_FONT = 'Roboto, Arial, Helvetica, sans-serif';

/** A group in the frame of a box: origin in its centre, turned as it is. */
export const boxFrame = (
  { at, angle }: { readonly at: Point; readonly angle: number },
  to: ToPicture,
  inside: string,
): string => element('g', { transform: turned(to(at), -angle) }, inside);

/** A move, then a turn by degrees clockwise. */
export function turned([x, y]: Point, deg: number): string {
  const move = `translate(${x.toFixed(3)} ${y.toFixed(3)})`;
  return deg === 0 ? move : `${move} rotate(${deg.toFixed(3)})`;
}

/** An angle in degrees. */
export const degrees = (rad: number): number => (rad * 180) / Math.PI;

/** A rectangle around the origin. */
export const rect = (
  [width, height]: Point,
  rx: number,
  attributes: Record<string, string | number | undefined>,
): string => element('rect', { x: -width / 2, y: -height / 2, width, height, rx, ...attributes });

/** An icon of 24 units in the middle, this many mm wide. */
export const icon = (path: string, sizeMm: number, fill: string, rim: Record<string, string | number> = {}): string =>
  element('path', { d: path, fill, ...rim, transform: `scale(${(sizeMm / 24).toFixed(4)}) translate(-12 -12)` });

/** Lines at 45° across a box around the origin, cut off at its edges. */
export function diagonals([width, height]: Point, pitch: number): string {
  const [w, h] = [width / 2, height / 2];
  const lines: string[] = [];
  // On a line x + y is the same everywhere.
  for (let sum = -w - h + pitch / 2; sum < w + h; sum += pitch * Math.SQRT2) {
    const left = Math.max(-w, sum - h);
    const right = Math.min(w, sum + h);
    lines.push(pathThrough([[left, sum - left], [right, sum - right]])); // prettier-ignore
  }
  return lines.join('');
}

/** Bold words in the middle. */
export const written = (text: string, size: number, color: string, x: number): string =>
  element(
    'text',
    { x, y: size * 0.355, 'font-family': SVG_FONT, 'font-size': size, 'font-weight': 700, 'text-anchor': 'middle', fill: color }, // prettier-ignore
    escapeXml(text),
  );
