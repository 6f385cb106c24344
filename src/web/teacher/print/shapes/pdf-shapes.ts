import type { jsPDF } from 'jspdf';
import { radOf } from '#core/angle';
import type { Group, Paint, Shape, Words } from '#picture/shapes';
import { boundsMeet, type Bounds } from '#scene/outline';
import type { Point } from '#scene/scene';

/** From a place to mm on the sheet, from its upper left corner. */
export type ToSheet = (at: Point) => Point;

/** Points per millimetre: the type sizes of a PDF are in points. */
export const PT_PER_MM = 72 / 25.4;

/**
 * Distance of the control points from the ends of a quarter of a circle, in radii (the usual approximation, right to
 * 0.03 %).
 */
const ROUND = 0.5522847498;

/** Draws the lines and the words of shapes on a sheet; nothing is filled. `shown`: what of the world the sheet shows. */
export function printShapes(pdf: jsPDF, shapes: readonly Shape[], to: ToSheet, shown: Bounds): void {
  for (const shape of shapes)
    if (shape.form === 'group') printGroup(pdf, shape, to, { up: 1, turn: 0 });
    else if (shape.form === 'lines' && !shape.isClosed) {
      const half = (shape.width ?? 0) / 2;
      const reach = { minX: shown.minX - half, maxX: shown.maxX + half, minY: shown.minY - half, maxY: shown.maxY + half }; // prettier-ignore
      printShape(pdf, { ...shape, lines: shape.lines.flatMap((line) => runsWithin(line, reach)) }, to, 0);
    } else printShape(pdf, shape, to, 0);
}

/**
 * Draws a group. `up`: 1 if y points up around the group, as in the world, -1 if down, as within a group. `turn`: that
 * of its surroundings, in degrees.
 */
function printGroup(
  pdf: jsPDF,
  group: Group,
  to: ToSheet,
  around: { readonly up: 1 | -1; readonly turn: number },
): void {
  const [cos, sin] = [Math.cos(radOf(group.turn)), Math.sin(radOf(group.turn))];
  const { at } = group;
  const within: ToSheet = ([x, y]) => to([at[0] + x * cos + y * sin, at[1] + around.up * (x * sin - y * cos)]);
  const turn = around.turn + group.turn;
  for (const shape of group.inside)
    if (shape.form === 'group') printGroup(pdf, shape, within, { up: -1, turn });
    else printShape(pdf, shape, within, turn);
}

function printShape(pdf: jsPDF, shape: Exclude<Shape, Group>, to: ToSheet, turn: number): void {
  if (shape.form === 'words') return write(pdf, shape, to(shape.at), turn);
  if (shape.stroke === undefined || shape.form === 'icon') return;
  setLine(pdf, shape);
  if (shape.form === 'ellipse') return ellipse(pdf, shape.at, shape.radii, to);
  if (shape.form === 'lines') for (const line of shape.lines) polyline(pdf, line, to, shape.isClosed);
  else {
    const [[left, top], [width, height]] = [shape.at, shape.size];
    const [right, bottom] = [left + width, top + height];
    polyline(pdf, [[left, top], [right, top], [right, bottom], [left, bottom]], to, true); // prettier-ignore
  }
}

function setLine(pdf: jsPDF, { stroke, width, dash, cap, join }: Paint): void {
  pdf.setDrawColor(stroke ?? '#000000');
  pdf.setLineWidth(width ?? 0);
  pdf.setLineCap(cap ?? 'butt');
  pdf.setLineJoin(join ?? 'miter');
  pdf.setLineDashPattern(dash ? [...dash] : [], 0);
}

function write(pdf: jsPDF, { text, size, from, fill }: Words, [x, y]: Point, turnDeg: number): void {
  const words = printable(text);
  pdf.setFont('helvetica', 'bold');
  pdf.setFontSize(size * PT_PER_MM);
  pdf.setTextColor(fill);
  // jsPDF turns about the start of the base line.
  const back = from === 'middle' ? pdf.getTextWidth(words) / 2 : 0;
  const turn = radOf(turnDeg);
  pdf.text(words, x - back * Math.cos(turn), y + back * Math.sin(turn), { angle: turnDeg });
}

/** Replacements of signs that the fonts of a PDF lack. */
const PLAIN: Readonly<Record<string, string>> = {
  '−': '–',
  '→': '->',
  '←': '<-',
  '⇒': '=>',
  '≤': '<=',
  '≥': '>=',
  '≠': '!=',
  '≈': '~',
  '\u202f': '\u00a0', // the narrow space of French
};

/** Western letters and signs (Windows-1252): for these every PDF reader has a font. */
const FOREIGN = /[^\u0020-\u007e\u00a0-\u00ff€‚ƒ„…†‡ˆ‰Š‹ŒŽ‘’“”•–—˜™š›œžŸ]/gu;

/** Pictures within a text, with the signs that change or join them, and places where a word may be parted. */
const PICTURES = /(?![\u0020-\u00ff‰™])[\p{Extended_Pictographic}\p{Emoji_Modifier}\ufe0e\ufe0f\u200b-\u200d]|\u00ad/gu;

/** A text in the signs of a PDF's fonts: emojis are left out, and what has no likeness becomes a question mark. */
export const printable = (text: string): string =>
  text
    .normalize('NFC')
    .replace(/[✓✔]/g, '•')
    .replace(PICTURES, '')
    .replace(FOREIGN, (sign) => PLAIN[sign] ?? '?');

/** Draws a line through places. */
export function polyline(pdf: jsPDF, line: readonly Point[], to: ToSheet, isClosed = false): void {
  line.forEach((place, i) => {
    const [x, y] = to(place);
    if (i === 0) pdf.moveTo(x, y);
    else pdf.lineTo(x, y);
  });
  if (isClosed) pdf.close();
  pdf.stroke();
}

/** Draws an ellipse, from four curves. */
function ellipse(pdf: jsPDF, [x, y]: Point, [a, b]: Point, to: ToSheet): void {
  const at = (u: number, v: number): Point => to([x + u * a, y + v * b]);
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

/** The parts of a line near a rectangle, at least two points each, so that a sheet holds no more than it shows. */
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
    if (!boundsMeet(bounds, shown)) {
      if (run.length > 0) runs.push(run);
      run = [];
    } else if (run.length === 0) run = [a, b];
    else run.push(b);
  }
  if (run.length > 0) runs.push(run);
  return runs;
}
