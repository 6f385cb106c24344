import { mdiAlert, mdiArrowAll, mdiArrowLeftRightBold, mdiFlagCheckered, mdiLock } from '@mdi/js';
import type { Block, Label, Mover, Point, SceneObject, Spikes, Stroke, Wall, Zone } from '#scene/scene';

import { CAPITAL } from '../arena/picture/draw-label';
import { teeth } from '../arena/picture/draw-obstacles';
import { needsRim } from '../arena/picture/draw-stroke';
import { wallJoints } from '../arena/picture/draw-walls';
import { lightPalette as colors } from '../arena/picture/palette';
import { element, escapeXml, pathThrough } from './svg-write';

/** Fonts of the texts in a picture; every viewer has one of them. */
export const SVG_FONT = 'Roboto, Arial, Helvetica, sans-serif';

/** From world mm (y up) to the picture's mm (y down). */
export type ToPicture = (at: Point) => Point;

/**
 * An object of the course as SVG, in mm of the picture, with presentation attributes only: office programs read no style
 * sheets. Simpler than on the screen (no shadows), with the same shapes, colours and signs.
 */
export function objectSvg(object: SceneObject, to: ToPicture): string {
  switch (object.type) {
    case 'stroke':
      return strokeSvg(object, to);
    case 'wall':
      return wallSvg(object, to);
    case 'block':
      return boxFrame(object, to, blockSvg(object.size));
    case 'fixed-block':
      return boxFrame(object, to, fixedBlockSvg(object.size));
    case 'spikes':
      return boxFrame(object, to, spikesSvg(object.size));
    case 'mover':
      return moverSvg(object, to);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return zoneSvg(object, to);
    case 'label':
      return labelSvg(object, to);
    default:
      return object satisfies never;
  }
}

function strokeSvg({ points, width, color }: Stroke, to: ToPicture): string {
  const [first = [0, 0]] = points;
  const places = points.length === 1 ? [first, first] : points;
  const common = {
    d: pathThrough(places.map(to)),
    fill: 'none',
    'stroke-linecap': 'round',
    'stroke-linejoin': 'round',
  };
  const rim = needsRim({ color })
    ? element('path', { ...common, stroke: colors.strokeEdge, 'stroke-width': width + 2 })
    : '';
  return rim + element('path', { ...common, stroke: colors.strokes[color], 'stroke-width': width });
}

function wallSvg({ from, to: end, thickness }: Wall, to: ToPicture): string {
  const [x, y] = to(from);
  const [dx, dy] = [end[0] - from[0], end[1] - from[1]];
  const length = Math.hypot(dx, dy);
  const courses = Math.max(2, Math.min(4, Math.round(thickness / 5)));
  const height = thickness / courses;
  const brick = height * 3.4;
  const lines: string[] = [];
  for (let course = 0; course < courses; course += 1) {
    const top = -thickness / 2 + course * height;
    if (course > 0) lines.push(pathThrough([[0, top], [length, top]])); // prettier-ignore
    // Of a very long wall the first bricks are enough to see what it is made of.
    for (let i = 1; i < 400; i += 1) {
      const at = (i - (course % 2) / 2) * brick;
      if (at >= length) break;
      lines.push(pathThrough([[at, top], [at, top + height]])); // prettier-ignore
    }
  }
  return element(
    'g',
    { transform: turned([x, y], -degrees(Math.atan2(dy, dx))) },
    element('rect', { y: -thickness / 2, width: length, height: thickness, rx: 1, fill: colors.wall }),
    element('path', { d: lines.join(''), fill: 'none', stroke: colors.wallInk, 'stroke-width': height * 0.16 }),
  );
}

/** Closes the notches where walls meet; to be put under them. */
export const jointsSvg = (objects: readonly SceneObject[], to: ToPicture): string =>
  wallJoints(objects.filter((object): object is Wall => object.type === 'wall'))
    .map(({ at, thickness }) => {
      const [cx, cy] = to(at);
      return element('circle', { cx, cy, r: thickness / 2, fill: colors.wall });
    })
    .join('');

function blockSvg([width, height]: Point): string {
  const short = Math.min(width, height);
  const frame = Math.min(3, short * 0.09);
  return (
    rect([width - frame, height - frame], Math.min(5, short / 6), {
      fill: colors.movableLight,
      stroke: colors.movableInk,
      'stroke-width': frame,
    }) + icon(mdiArrowAll, short * 0.66, colors.movableInk)
  );
}

function fixedBlockSvg([width, height]: Point): string {
  const short = Math.min(width, height);
  const frame = Math.min(3, short * 0.08);
  return (
    rect([width, height], Math.min(3, short / 8), { fill: colors.fixed }) +
    element('path', {
      d: diagonals([width, height], Math.max(9, short / 5)),
      stroke: '#fff',
      'stroke-opacity': 0.4,
      'stroke-width': Math.max(9, short / 5) * 0.36,
      fill: 'none',
    }) +
    rect([width - frame, height - frame], Math.min(2, short / 10), {
      fill: 'none',
      stroke: colors.fixedEdge,
      'stroke-width': frame,
    }) +
    element('circle', { r: short * 0.28, fill: colors.fixed }) +
    icon(mdiLock, short * 0.4, colors.fixedInk)
  );
}

function spikesSvg([x, y]: Point): string {
  return toothed([x, y]) + icon(mdiAlert, Math.min(x, y) * 0.42, colors.spikesInk);
}

const toothed = ([x, y]: Point): string =>
  element('path', {
    d: pathThrough(
      teeth({ x, y }).map((place) => [place.x, place.y] as const),
      true,
    ),
    fill: colors.spikes,
    stroke: colors.spikesInk,
    'stroke-width': 1,
  });

function moverSvg(mover: Mover, to: ToPicture): string {
  const { at, to: end, size, spiked } = mover;
  const [from, turning] = [to(at), to(end)];
  const inner: Point = spiked ? [size[0] * 0.6, size[1] * 0.6] : size;
  const short = Math.min(...inner);
  const frame = Math.min(3, short * 0.09);
  const wayDeg = degrees(Math.atan2(end[1] - at[1], end[0] - at[0]));
  const line = { fill: 'none', stroke: colors.moverInk, 'stroke-width': 2.5 };
  return (
    element('path', { ...line, d: pathThrough([from, turning]), 'stroke-dasharray': '7.5 6' }) +
    boxFrame({ at: end, turn: mover.turn }, to, rect(size, 4, { ...line, 'stroke-dasharray': '6 5' })) +
    element('circle', {
      cx: turning[0],
      cy: turning[1],
      r: 6.5,
      fill: colors.floor,
      stroke: colors.moverInk,
      'stroke-width': 2.5,
    }) + // prettier-ignore
    boxFrame(
      mover,
      to,
      (spiked ? toothed(size) : '') +
        rect([inner[0] - frame, inner[1] - frame], Math.min(5, short / 6), {
          fill: colors.moverLight,
          stroke: colors.moverInk,
          'stroke-width': frame,
        }) +
        element('g', { transform: `rotate(${String(mover.turn * 45 - wayDeg)})` }, icon(mdiArrowLeftRightBold, short * 0.72, colors.moverInk)), // prettier-ignore
    )
  );
}

function zoneSvg(zone: Zone, to: ToPicture): string {
  const [width, height] = zone.size;
  const line = Math.min(3, Math.min(width, height) / 12);
  const color = colors[zone.type];
  const dash = { target: '10 7', checkpoint: '4 5', forbidden: undefined }[zone.type];
  const shape = { fill: color, 'fill-opacity': 0.1, stroke: color, 'stroke-width': line, 'stroke-dasharray': dash };
  const inset: Point = [width - line, height - line];
  const outline = zone.round
    ? element('ellipse', { rx: inset[0] / 2, ry: inset[1] / 2, ...shape })
    : rect(inset, Math.min(4, width / 6), shape);
  const hatch =
    zone.type === 'forbidden' && !zone.round
      ? element('path', { d: diagonals(zone.size, 16), stroke: color, 'stroke-opacity': 0.42, 'stroke-width': 2.5, fill: 'none' }) // prettier-ignore
      : '';
  const chequers = zone.type === 'target' && !zone.round ? chequersSvg(zone.size) : '';
  return boxFrame(zone, to, outline + hatch + chequers);
}

/** The sign in the middle of a zone, upright: to be put over the lines. */
export const zoneSignSvg = (zone: Zone, to: ToPicture): string =>
  element('g', { transform: turned(to(zone.at), 0) }, signSvg(zone));

function chequersSvg([width, height]: Point): string {
  const square = Math.min(11, width / 8, height / 8);
  const squares: string[] = [];
  for (let row = 0; row < 2; row += 1)
    for (let x = row * square; x < width - 0.01; x += 2 * square) {
      const [left, right] = [-width / 2 + x, -width / 2 + Math.min(width, x + square)];
      const [top, bottom] = [height / 2 - (row + 1) * square, height / 2 - row * square];
      squares.push(pathThrough([[left, top], [right, top], [right, bottom], [left, bottom]], true)); // prettier-ignore
    }
  return element('path', { d: squares.join(''), fill: colors.target, 'fill-opacity': 0.8 });
}

function signSvg({ type, size, number, blocks }: Zone): string {
  const radius = Math.min(20, 0.3 * Math.min(...size));
  const color = colors[type];
  if (type === 'target' && blocks === 0)
    return icon(mdiFlagCheckered, radius * 2.2, color, { stroke: colors.signGround, 'stroke-width': 4, 'stroke-linejoin': 'round' }) + icon(mdiFlagCheckered, radius * 2.2, color); // prettier-ignore
  if (type === 'target') {
    const side = radius * 1.15;
    const block = rect([side, side], side * 0.16, { fill: colors.movable, stroke: colors.movableInk, 'stroke-width': side * 0.13 }); // prettier-ignore
    const ground = {
      x: -radius * 1.35,
      y: -radius * 0.85,
      width: radius * 2.85,
      height: radius * 1.7,
      rx: radius * 0.3,
    };
    return (
      element('rect', { ...ground, fill: colors.signGround }) +
      written(`${String(blocks)}×`, radius * 0.95, color, -radius * 0.62) +
      element('g', { transform: turned([radius * 0.73, 0], 0) }, block)
    );
  }
  const isNumber = type === 'checkpoint';
  const stroke = radius * (isNumber ? 0.16 : 0.26);
  const disc = element('circle', { r: radius * 0.9, fill: '#fff', stroke: color, 'stroke-width': stroke });
  const end = radius * 0.62;
  return isNumber
    ? disc + written(String(number), radius * (number > 9 ? 0.95 : 1.2), color, 0)
    : disc + element('path', { d: pathThrough([[-end, -end], [end, end]]), stroke: color, 'stroke-width': stroke }); // prettier-ignore
}

const written = (text: string, size: number, color: string, x: number): string =>
  element(
    'text',
    { x, y: size * 0.355, 'font-family': SVG_FONT, 'font-size': size, 'font-weight': 700, 'text-anchor': 'middle', fill: color }, // prettier-ignore
    escapeXml(text),
  );

function labelSvg({ at, text, height, turn }: Label, to: ToPicture): string {
  return element(
    'text',
    {
      transform: turned(to(at), -45 * turn),
      y: height / 2,
      'font-family': SVG_FONT,
      'font-size': height / CAPITAL,
      'font-weight': 600,
      'text-anchor': 'middle',
      fill: colors.label,
    },
    escapeXml(text),
  );
}

/** A group in the frame of a box: origin in its centre, turned as it is. */
const boxFrame = ({ at, turn }: Pick<Block | Spikes, 'at' | 'turn'>, to: ToPicture, inside: string): string =>
  element('g', { transform: turned(to(at), -45 * turn) }, inside);

/** A move, then a turn by degrees clockwise. */
function turned([x, y]: Point, deg: number): string {
  const move = `translate(${x.toFixed(3)} ${y.toFixed(3)})`;
  return deg === 0 ? move : `${move} rotate(${deg.toFixed(3)})`;
}

const degrees = (rad: number): number => (rad * 180) / Math.PI;

const rect = ([width, height]: Point, rx: number, attributes: Record<string, string | number | undefined>): string =>
  element('rect', { x: -width / 2, y: -height / 2, width, height, rx, ...attributes });

/** An icon of 24 units in the middle, this many mm wide. */
const icon = (path: string, sizeMm: number, fill: string, rim: Record<string, string | number> = {}): string =>
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
