import type { jsPDF } from 'jspdf';
import { boundsOf, solidOutline } from '#scene/kinds/index';
import { boxOutline, type Bounds, type Outline } from '#scene/outline';
import type { Label, Point, Scene, Stroke, Zone } from '#scene/scene';

import { CAPITAL } from '../arena/picture/draw-label';
import { lightPalette } from '../arena/picture/palette';
import { MARGIN_MM, type Tile } from './print-plan';

/** What is printed of a course. */
export interface FloorOptions {
  /** Thin outlines where walls, blocks and obstacles stand and where the robot starts. */
  readonly outlines: boolean;
  /** The background as a PNG or JPEG that the PDF can take, or `null`: none. */
  readonly background: { readonly data: string; readonly format: 'PNG' | 'JPEG' } | null;
}

/** From world mm to mm on the sheet, from its upper left corner. */
type ToSheet = (at: Point) => Point;

/** Points of a millimetre, which is what texts are measured in. */
const PT_PER_MM = 72 / 25.4;

/** How far a circle's control points lie off, for four curves (the usual approximation, right to 0.03 %). */
const ROUND = 0.5522847498;

/** Prints the part of the floor that a sheet shows, true to scale: only flat things, no solid ones. */
export function printFloor(pdf: jsPDF, scene: Scene, tile: Tile, options: FloorOptions): void {
  const [left, top] = tile.upperLeft;
  const to: ToSheet = ([x, y]) => [MARGIN_MM + x - left, MARGIN_MM + top - y];
  const [width, height] = tile.size;
  const shown: Bounds = { minX: left, maxX: left + width, minY: top - height, maxY: top };
  pdf.saveGraphicsState();
  pdf.rect(MARGIN_MM, MARGIN_MM, width, height, null);
  pdf.clip();
  pdf.discardPath();
  printBackground(pdf, scene, to, options);
  for (const object of scene.objects)
    if (object.type === 'target' || object.type === 'checkpoint' || object.type === 'forbidden')
      if (isShown(boundsOf(object), shown)) printZone(pdf, object, to);
  for (const object of scene.objects) if (object.type === 'stroke') printStroke(pdf, object, to, shown);
  for (const object of scene.objects) if (object.type === 'label') printLabel(pdf, object, to);
  if (options.outlines) printOutlines(pdf, scene, to, shown);
  pdf.restoreGraphicsState();
}

const isShown = (one: Bounds, shown: Bounds): boolean =>
  one.minX <= shown.maxX && one.maxX >= shown.minX && one.minY <= shown.maxY && one.maxY >= shown.minY;

function printBackground(pdf: jsPDF, { background }: Scene, to: ToSheet, options: FloorOptions): void {
  if (background === null || options.background === null) return;
  const { at, size } = background;
  const [x, y] = to([at[0], at[1] + size[1]]);
  const { data, format } = options.background;
  pdf.addImage(data, format, x, y, size[0], size[1], 'background', 'FAST');
}

function printStroke(pdf: jsPDF, { points, width, color }: Stroke, to: ToSheet, shown: Bounds): void {
  const half = width / 2;
  const reach = { minX: shown.minX - half, maxX: shown.maxX + half, minY: shown.minY - half, maxY: shown.maxY + half };
  pdf.setLineWidth(width);
  pdf.setLineCap('round');
  pdf.setLineJoin('round');
  // Printed black must be as dark as it goes: the robot's sensors look at it.
  pdf.setDrawColor(color === 'black' ? '#000000' : lightPalette.strokes[color]);
  for (const run of runsWithin(points, reach)) {
    run.forEach((point, i) => {
      const [x, y] = to(point);
      if (i === 0) pdf.moveTo(x, y);
      else pdf.lineTo(x, y);
    });
    pdf.stroke();
  }
}

/** The parts of a line that come near a rectangle, each at least two places: a sheet holds no more than it shows. */
export function runsWithin(points: readonly Point[], shown: Bounds): Point[][] {
  const runs: Point[][] = [];
  let run: Point[] = [];
  const ends = points.length === 1 ? [...points, ...points] : points;
  for (let i = 1; i < ends.length; i += 1) {
    const [a, b] = [ends[i - 1], ends[i]];
    if (a === undefined || b === undefined) break;
    const bounds: Bounds = {
      minX: Math.min(a[0], b[0]),
      maxX: Math.max(a[0], b[0]),
      minY: Math.min(a[1], b[1]),
      maxY: Math.max(a[1], b[1]),
    };
    if (!isShown(bounds, shown)) {
      if (run.length > 0) runs.push(run);
      run = [];
    } else if (run.length === 0) run = [a, b];
    else run.push(b);
  }
  if (run.length > 0) runs.push(run);
  return runs;
}

function printZone(pdf: jsPDF, zone: Zone, to: ToSheet): void {
  pdf.setDrawColor(lightPalette[zone.type]);
  pdf.setLineWidth(0.6);
  pdf.setLineCap('butt');
  pdf.setLineDashPattern(zone.type === 'forbidden' ? [] : [5, 3], 0);
  const corners = boxOutline(zone);
  if (zone.round) ellipse(pdf, corners, to);
  else polygon(pdf, corners, to);
  if (zone.type === 'forbidden' && !zone.round) {
    const [a, b, c, d] = corners.map(({ x, y }) => to([x, y]));
    if (a && b && c && d) pdf.line(a[0], a[1], c[0], c[1]).line(b[0], b[1], d[0], d[1]);
  }
  pdf.setLineDashPattern([], 0);
  if (zone.type !== 'checkpoint') return;
  const height = Math.min(15, 0.25 * Math.min(...zone.size));
  pdf.setTextColor(lightPalette.checkpoint);
  write(pdf, String(zone.number), to(zone.at), height, 0);
}

function printLabel(pdf: jsPDF, { text, at, height, turn }: Label, to: ToSheet): void {
  pdf.setTextColor(lightPalette.label);
  write(pdf, text, to(at), height, turn * 45);
}

/** Words around a place, turned counter-clockwise. */
function write(pdf: jsPDF, text: string, [x, y]: Point, capitalMm: number, turnDeg: number): void {
  const words = printable(text);
  pdf.setFont('helvetica', 'bold');
  pdf.setFontSize((capitalMm / CAPITAL) * PT_PER_MM);
  const turn = (turnDeg * Math.PI) / 180;
  // jsPDF turns about the start of the base line: half the width back and half a capital down, in the text's own frame.
  const [back, down] = [pdf.getTextWidth(words) / 2, capitalMm / 2];
  pdf.text(
    words,
    x - back * Math.cos(turn) + down * Math.sin(turn),
    y + back * Math.sin(turn) + down * Math.cos(turn),
    { angle: turnDeg },
  );
}

/** Typographic signs in plain ones, for the fonts that every PDF reader brings along. */
const PLAIN: Readonly<Record<string, string>> = {
  '“': '"',
  '”': '"',
  '„': '"',
  '‘': "'",
  '’': "'",
  '…': '...',
  '–': '-',
  '−': '-',
  œ: 'oe',
  Œ: 'OE',
  '\u202f': '\u00a0', // the narrow space of French
};

/** A text in the signs that every PDF reader has a font for (Latin-1); others become question marks. */
export const printable = (text: string): string =>
  text.replace(/[^\u0020-\u007e\u00a0-\u00ff]/gu, (sign) => PLAIN[sign] ?? '?');

/** Where things stand, for setting the course up; and where the robot starts, with its heading. */
function printOutlines(pdf: jsPDF, { objects, robot }: Scene, to: ToSheet, shown: Bounds): void {
  pdf.setDrawColor('#5C6671');
  pdf.setLineWidth(0.3);
  pdf.setLineCap('butt');
  for (const object of objects) {
    const outline = solidOutline(object);
    if (outline !== null && isShown(boundsOf(object), shown)) polygon(pdf, outline, to);
  }
  const heading = (robot.heading * Math.PI) / 180;
  const ahead = (mm: number, aside: number): Point =>
    to([
      robot.at[0] + mm * Math.cos(heading) - aside * Math.sin(heading),
      robot.at[1] + mm * Math.sin(heading) + aside * Math.cos(heading),
    ]);
  const arrow: readonly (readonly [Point, Point])[] = [
    [ahead(-20, 0), ahead(40, 0)],
    [ahead(0, -20), ahead(0, 20)],
    [ahead(40, 0), ahead(30, 6)],
    [ahead(40, 0), ahead(30, -6)],
  ];
  for (const [from, end] of arrow) pdf.line(from[0], from[1], end[0], end[1]);
}

function polygon(pdf: jsPDF, outline: Outline, to: ToSheet): void {
  outline.forEach(({ x, y }, i) => {
    const at = to([x, y]);
    if (i === 0) pdf.moveTo(at[0], at[1]);
    else pdf.lineTo(at[0], at[1]);
  });
  pdf.close();
  pdf.stroke();
}

/** The ellipse within a turned rectangle, from four curves. */
function ellipse(pdf: jsPDF, corners: Outline, to: ToSheet): void {
  const [a, b, , d] = corners;
  if (a === undefined || b === undefined || d === undefined) return;
  const half = { x: (b.x - a.x) / 2, y: (b.y - a.y) / 2 };
  const other = { x: (d.x - a.x) / 2, y: (d.y - a.y) / 2 };
  const centre = { x: a.x + half.x + other.x, y: a.y + half.y + other.y };
  const at = (u: number, v: number): Point =>
    to([centre.x + u * half.x + v * other.x, centre.y + u * half.y + v * other.y]);
  const quarters = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]] as const; // prettier-ignore
  const start = at(1, 0);
  pdf.moveTo(start[0], start[1]);
  for (let i = 0; i < 4; i += 1) {
    const [[u, v], [nextU, nextV]] = [quarters[i] ?? [1, 0], quarters[i + 1] ?? [1, 0]];
    const [one, two, end] = [
      at(u + ROUND * nextU, v + ROUND * nextV),
      at(nextU + ROUND * u, nextV + ROUND * v),
      at(nextU, nextV),
    ];
    pdf.curveTo(one[0], one[1], two[0], two[1], end[0], end[1]);
  }
  pdf.stroke();
}
