import type { Form } from '../../../pupil/arena/model/arena-model';
import type { Point, Shaped } from '#scene/scene';
import { ownOutline } from '#scene/shape/shape';

import { polygonPath, type Room } from '../../../pupil/arena/picture/kinds/shape-path';
import { element, escapeXml, pathThrough } from './svg-write';
import type { ToPicture } from './kind';

/** Fonts of the texts in a picture; every viewer has one of them. */
export const SVG_FONT = 'Roboto, Arial, Helvetica, sans-serif';

/** Room around an arena without rulers, in parts of its longer side. */
export const RIM_SHARE = 0.004;

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

/** A form around the origin, its edges moved inward; `rx`: of a rectangle's corners. */
export function formSvg(
  form: Form,
  insetMm: number,
  rx: number,
  attributes: Record<string, string | number | undefined>,
): string {
  const [width, height] = [form.sizeMm.x - 2 * insetMm, form.sizeMm.y - 2 * insetMm];
  if (form.corners) {
    const places = polygonPath(form, insetMm).map(({ x, y }): Point => [x, y]);
    return element('path', { d: pathThrough(places, true), ...attributes });
  }
  if (form.round === true) return element('ellipse', { rx: width / 2, ry: height / 2, ...attributes });
  return rect([width, height], rx, attributes);
}

/** Something where a form has the most room. */
export const inRoom = ({ at }: Room, inside: string): string =>
  at.x === 0 && at.y === 0 ? inside : element('g', { transform: turned([at.x, at.y], 0) }, inside);

/** An icon of 24 units in the middle, this many mm wide. */
export const icon = (path: string, sizeMm: number, fill: string, rim: Record<string, string | number> = {}): string =>
  element('path', { d: path, fill, ...rim, transform: `scale(${(sizeMm / 24).toFixed(4)}) translate(-12 -12)` });

/** Lines at 45° across a shape around the origin, cut off at its edges. */
export function diagonals(shape: Pick<Shaped, 'size' | 'round' | 'corners'>, pitch: number): string {
  const outline = ownOutline(shape).map(({ x, y }): Point => [x, -y]);
  const sums = outline.map(([x, y]) => x + y);
  const [w, h] = [shape.size[0] / 2, shape.size[1] / 2];
  const lines: string[] = [];
  // On a line x + y is the same everywhere.
  for (let sum = -w - h + pitch / 2; sum < w + h; sum += pitch * Math.SQRT2) {
    const places: Point[] = [];
    for (const [index, one] of sums.entries()) {
      const next = (index + 1) % sums.length;
      const [other = one, from, to] = [sums[next], outline[index], outline[next]];
      if (!from || !to || one > sum === other > sum) continue;
      const share = (sum - one) / (other - one);
      places.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
    }
    places.sort(([x], [other]) => x - other);
    for (let pair = 0; pair + 1 < places.length; pair += 2) lines.push(pathThrough(places.slice(pair, pair + 2)));
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
