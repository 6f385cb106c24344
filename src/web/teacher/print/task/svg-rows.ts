import type { Point } from '#scene/scene';

import { element, escapeXml, pathThrough, type Attributes } from '#picture/svg-write';
import { CODE_SCALE } from './letter-widths';
import { BASE, type Piece, type PlacedRow, type Sign } from './set-rows';
import { RING, starsAt } from './signs';

const MONO = 'Roboto Mono, Courier New, Courier, monospace';

/**
 * Writes a row as SVG.
 *
 * @param at upper left corner of the text in the picture
 * @param look font and colour
 * @param picture address of the task's own picture; empty: none is shown
 */
export function rowSvg({ row, topMm }: PlacedRow, at: Point, look: Attributes, picture = ''): string {
  const { sizeMm, pieces, sign } = row;
  const [left, top] = [at[0], at[1] + topMm];
  if (row.picture !== null) {
    const [width, height] = row.picture;
    return picture === '' ? '' : element('image', { x: left, y: top, width, height, href: picture });
  }
  const y = top + BASE * sizeMm;
  const type = { 'font-size': sizeMm, ...look };
  const mark = sign === null ? '' : signSvg(sign, [left, y], sizeMm, type);
  if (pieces.length === 0) return mark;
  // One text for the row: a viewer with other fonts moves its parts along.
  const x = left + (pieces[0]?.xMm ?? 0);
  return mark + element('text', { x, y, ...type }, ...pieces.map((piece) => pieceSvg(piece, sizeMm)));
}

function signSvg(sign: Sign, [left, base]: Point, sizeMm: number, type: Attributes): string {
  if (sign.kind === 'mark') return element('text', { x: left + 0.2 * sizeMm, y: base, ...type }, escapeXml(sign.text));
  const line = { fill: 'none', stroke: type.fill, 'stroke-width': 0.07 * sizeMm };
  if (sign.kind === 'stars')
    return element('path', {
      d: starsAt(sign.count, [left, base], sizeMm)
        .map((star) => pathThrough(star, true))
        .join(''),
      ...line,
    });
  const [cx, cy] = [left + RING.left * sizeMm, base - RING.aboveBase * sizeMm];
  return element('circle', { cx, cy, r: RING.radius * sizeMm, ...line });
}

function pieceSvg({ kind, text }: Piece, sizeMm: number): string {
  const words = escapeXml(text);
  if (kind === 'text') return words;
  if (kind === 'bold') return element('tspan', { 'font-weight': 700 }, words);
  return element('tspan', { 'font-family': MONO, 'font-weight': 600, 'font-size': CODE_SCALE * sizeMm }, words);
}
