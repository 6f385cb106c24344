import { mdiFlagCheckered } from '@mdi/js';
import type { jsPDF } from 'jspdf';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet, boxOutline, type Bounds } from '#scene/outline';
import type { Point, Zone } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';

import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { formOf, roomIn } from '../../../pupil/arena/picture/kinds/shape-path';
import { signPlace } from '../../../pupil/arena/picture/kinds/zone';
import { ellipse, polygon, write } from './pdf-parts';
import { element, pathThrough } from './svg-write';
import type { PrintKind, ToPicture, ToSheet } from './kind';
import { boxFrame, diagonals, formSvg, icon, rect, turned, written } from './svg-parts';

/** Zones of all kinds. */
export const zone: PrintKind<Zone> = {
  layer: 0,
  svg: zoneSvg,
  signSvg: (zone, to, leastMm) => element('g', { transform: turned(to(signAt(zone)), 0) }, signSvg(zone, leastMm)),
  pdf: printZone,
};

function zoneSvg(zone: Zone, to: ToPicture): string {
  const [width, height] = zone.size;
  const line = Math.min(3, Math.min(width, height) / 12);
  const color = colors[zone.type];
  const dash = { target: '10 7', checkpoint: '4 5', forbidden: undefined }[zone.type];
  const shape = { fill: color, 'fill-opacity': 0.1, stroke: color, 'stroke-width': line, 'stroke-dasharray': dash };
  const form = formOf(zone);
  const outline = formSvg(form, line / 2, Math.min(4, width / 6), shape);
  const hatch =
    zone.type === 'forbidden' && !zone.round
      ? element('path', { d: diagonals(zone, 16), stroke: color, 'stroke-opacity': 0.42, 'stroke-width': 2.5, fill: 'none' }) // prettier-ignore
      : '';
  const chequers = zone.type === 'target' && !zone.round ? chequersSvg(zone) : '';
  return boxFrame(zone, to, outline + hatch + chequers);
}

function chequersSvg(zone: Zone): string {
  const [width, height] = zone.size;
  const square = Math.min(11, width / 8, height / 8);
  if (zone.corners) {
    const edge = { fill: 'none', stroke: colors.target, 'stroke-opacity': 0.8, 'stroke-width': square };
    return [0, 1]
      .map((row) =>
        formSvg(formOf(zone), (row + 0.5) * square, 0, {
          ...edge,
          'stroke-dasharray': `${String(square)} ${String(square)}`,
          'stroke-dashoffset': row * square,
        }),
      ) // prettier-ignore
      .join('');
  }
  const squares: string[] = [];
  for (let row = 0; row < 2; row += 1)
    for (let x = row * square; x < width - 0.01; x += 2 * square) {
      const [left, right] = [-width / 2 + x, -width / 2 + Math.min(width, x + square)];
      const [top, bottom] = [height / 2 - (row + 1) * square, height / 2 - row * square];
      squares.push(pathThrough([[left, top], [right, top], [right, bottom], [left, bottom]], true)); // prettier-ignore
    }
  return element('path', { d: squares.join(''), fill: colors.target, 'fill-opacity': 0.8 });
}

const signAt = (zone: Zone): Point => {
  const { x, y } = signPlace(zone);
  return [x, y];
};

function signSvg({ type, number, blocks, ...zone }: Zone, leastMm: number): string {
  const radius = Math.max(leastMm, Math.min(20, 0.3 * roomIn(formOf(zone)).acrossMm));
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

function printZone(pdf: jsPDF, zone: Zone, to: ToSheet, shown: Bounds): void {
  if (!boundsMeet(boundsOf(zone), shown)) return;
  pdf.setDrawColor(colors[zone.type]);
  pdf.setLineWidth(0.6);
  pdf.setLineCap('butt');
  pdf.setLineDashPattern(zone.type === 'forbidden' ? [] : [5, 3], 0);
  const corners = boxOutline(zone);
  if (zone.round) ellipse(pdf, corners, to);
  else polygon(pdf, shapeOutline(zone), to);
  if (zone.type === 'forbidden' && !zone.round && !zone.corners) {
    const [a, b, c, d] = corners.map(({ x, y }) => to([x, y]));
    if (a && b && c && d) pdf.line(a[0], a[1], c[0], c[1]).line(b[0], b[1], d[0], d[1]);
  }
  pdf.setLineDashPattern([], 0);
  if (zone.type !== 'checkpoint') return;
  const height = Math.min(15, 0.25 * roomIn(formOf(zone)).acrossMm);
  pdf.setTextColor(colors.checkpoint);
  write(pdf, String(zone.number), to(signAt(zone)), height, 0);
}
