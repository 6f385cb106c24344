import { jsPDF } from 'jspdf';
import type { Scene } from '#scene/scene';

import { printable } from './shapes/pdf-shapes';
import { printFloor, type FloorOptions } from './pdf-floor';
import { MARGIN_MM, OVERLAP_MM, tileName, type PrintPlan, type Tile } from './print-plan';
import { printTags } from './pdf-tags';
import { printTask } from './task/pdf-task';
import type { PaperTask } from './task/task-blocks';

/** The words of a print, in the language of the page. */
export interface PrintWords {
  /** Name of the course. */
  readonly name: string;
  /** Title of the plan of the sheets. */
  readonly planTitle: string;
  /** The steps of printing, checking the scale and gluing, a line each. */
  readonly steps: readonly string[];
}

/** The ruler on each sheet, in mm: to check that the printer has not scaled. */
export const TEST_RULER_MM = 100;

/** Distance of marks from the edge of the sheet, in mm: the reach of most printers. */
const MARK_MM = { from: 4.5, to: 8.5 } as const;

/**
 * Makes a PDF of a course true to scale: a sheet per tile with marks for cutting and gluing, its name, a map and a
 * ruler; before several tiles one more with the plan of them all, after them the tags that stand, and the task.
 */
export function coursePdf(
  scene: Scene,
  plan: PrintPlan,
  options: FloorOptions & { readonly isCompressed?: boolean },
  words: PrintWords,
  task: PaperTask | null = null,
): jsPDF {
  const [width, height] = plan.page;
  const orientation = width > height ? 'landscape' : 'portrait';
  const pdf = new jsPDF({
    unit: 'mm',
    format: [width, height],
    orientation,
    compress: options.isCompressed ?? true,
    floatPrecision: 3, // of a point: 0.4 µm
  });
  pdf.setProperties({ title: words.name, creator: 'Parcours' });
  pdf.viewerPreferences({ PrintScaling: 'None' }); // otherwise many readers offer to shrink it
  const isTiled = plan.tiles.length > 1;
  if (isTiled) printOverview(pdf, scene, plan, words);
  plan.tiles.forEach((tile, i) => {
    if (isTiled || i > 0) pdf.addPage([width, height], orientation);
    printFloor(pdf, scene, tile, options);
    printMarks(pdf, plan, tile);
    printFoot(pdf, plan, tile, words);
  });
  printTags(pdf, scene);
  if (task !== null) printTask(pdf, task);
  return pdf;
}

function thinLines(pdf: jsPDF): void {
  pdf.setDrawColor('#000000');
  pdf.setTextColor('#000000');
  pdf.setLineWidth(0.2);
  pdf.setLineCap('butt');
  pdf.setLineDashPattern([], 0);
  pdf.setFont('helvetica', 'normal');
}

/**
 * Corners to cut at; dashed: where the cut edge of the previous sheet comes to lie on this one; names of the
 * neighbours.
 */
function printMarks(pdf: jsPDF, { page, columns }: PrintPlan, { column, row, size }: Tile): void {
  thinLines(pdf);
  const [left, top] = [MARGIN_MM, MARGIN_MM];
  const [right, bottom] = [left + size[0], top + size[1]];
  const { from, to } = MARK_MM;
  for (const x of [left, right]) {
    pdf.line(x, from, x, to);
    pdf.line(x, bottom + MARGIN_MM - to, x, bottom + MARGIN_MM - from);
  }
  for (const y of [top, bottom]) {
    pdf.line(from, y, to, y);
    pdf.line(right + MARGIN_MM - to, y, right + MARGIN_MM - from, y);
  }
  pdf.setLineDashPattern([0.8, 0.6], 0);
  pdf.setFontSize(7);
  if (column > 0) {
    const x = left + OVERLAP_MM;
    pdf.line(x, from, x, to); // below, the margin is cut off
  }
  if (row > 0) {
    const y = top + OVERLAP_MM;
    pdf.line(from, y, to, y);
  }
  if (column + 1 < columns)
    pdf.text(tileName(column + 1, row), page[0] - 5, page[1] / 2, { angle: 90, align: 'center' });
  if (column > 0) pdf.text(tileName(column - 1, row), 7, page[1] / 2, { angle: 90, align: 'center' });
  if (row > 0) pdf.text(tileName(column, row - 1), page[0] / 2, 7, { align: 'center' });
}

/** Name of the sheet, ruler and map, in the margin below. */
function printFoot(pdf: jsPDF, plan: PrintPlan, tile: Tile, { name }: PrintWords): void {
  const [width, height] = plan.page;
  thinLines(pdf);
  const base = height - 5;
  pdf.setFontSize(9);
  pdf.setFont('helvetica', 'bold');
  const isTiled = plan.tiles.length > 1;
  const title = isTiled ? `${tile.name}  ` : '';
  if (isTiled) pdf.text(tile.name, MARGIN_MM + 2, base);
  const indent = MARGIN_MM + 2 + pdf.getTextWidth(title);
  pdf.setFont('helvetica', 'normal');
  pdf.setFontSize(7);
  pdf.text(shortened(pdf, printable(`${name} · 1:1`), Math.max(10, width * 0.3 - indent)), indent, base);
  printRuler(pdf, width * 0.33, base);
  if (isTiled) printMap(pdf, plan, tile, width - MARGIN_MM - 2, base + 0.5);
}

function shortened(pdf: jsPDF, text: string, roomMm: number): string {
  let short = text;
  while (short.length > 1 && pdf.getTextWidth(short) > roomMm) short = short.slice(0, -1);
  return short === text ? text : `${short.slice(0, -2)}...`;
}

/** A ruler from `x` on, standing on the line `y`. */
function printRuler(pdf: jsPDF, x: number, y: number): void {
  pdf.line(x, y, x + TEST_RULER_MM, y);
  for (let mm = 0; mm <= TEST_RULER_MM; mm += 10) pdf.line(x + mm, y, x + mm, y - (mm % 50 === 0 ? 3 : 1.6));
  pdf.setFontSize(7);
  pdf.text(`${String(TEST_RULER_MM)} mm`, x + TEST_RULER_MM + 1.5, y);
}

/** All sheets as small boxes, this one filled; `right` and `bottom` are its corner. */
function printMap(pdf: jsPDF, { columns, rows, page }: PrintPlan, tile: Tile, right: number, bottom: number): void {
  const scale = Math.min(20 / (columns * page[0]), 4.5 / (rows * page[1]));
  const [width, height] = [page[0] * scale, page[1] * scale];
  const [left, top] = [right - columns * width, bottom - rows * height];
  pdf.setLineWidth(0.1);
  pdf.setFillColor('#000000');
  pdf.rect(left + tile.column * width, top + tile.row * height, width, height, 'F');
  for (let column = 0; column <= columns; column += 1)
    pdf.line(left + column * width, top, left + column * width, bottom);
  for (let row = 0; row <= rows; row += 1) pdf.line(left, top + row * height, right, top + row * height);
}

/** The first sheet of several: which lies where, and how to put them together. */
function printOverview(pdf: jsPDF, scene: Scene, plan: PrintPlan, words: PrintWords): void {
  const [width, height] = plan.page;
  const left = 20;
  thinLines(pdf);
  pdf.setFont('helvetica', 'bold');
  pdf.setFontSize(16);
  pdf.text(shortened(pdf, printable(words.name), width - 2 * left), left, 24);
  pdf.setFont('helvetica', 'normal');
  pdf.setFontSize(11);
  pdf.text(printable(words.planTitle), left, 32);
  const lines = words.steps.flatMap((step) => pdf.splitTextToSize(printable(step), width - 2 * left) as string[]);
  lines.forEach((line, i) => pdf.text(line, left, 40 + 5.4 * i));
  const rulerY = 40 + 5.4 * lines.length + 6;
  printRuler(pdf, left, rulerY);
  const top = rulerY + 10;
  const scale = Math.min((width - 2 * left) / scene.size[0], (height - top - 15) / scene.size[1]);
  printSmallStrokes(pdf, scene, left, top, scale);
  thinLines(pdf);
  for (const tile of plan.tiles) {
    const x = left + tile.upperLeft[0] * scale;
    const y = top + (scene.size[1] - tile.upperLeft[1]) * scale;
    const [w, h] = [tile.size[0] * scale, tile.size[1] * scale];
    pdf.setLineWidth(0.2);
    pdf.rect(x, y, w, h, 'S');
    pdf.setFontSize(Math.min(12, h * 1.2, w));
    pdf.text(tile.name, x + w / 2, y + h / 2, { align: 'center', baseline: 'middle' });
  }
}

/** The lines of the course in small, to tell which sheet shows what. */
function printSmallStrokes(pdf: jsPDF, { objects, size }: Scene, left: number, top: number, scale: number): void {
  pdf.setDrawColor('#C9CFD6');
  pdf.setLineCap('round');
  pdf.setLineJoin('round');
  for (const object of objects) {
    if (object.type !== 'stroke') continue;
    pdf.setLineWidth(Math.max(0.3, object.width * scale));
    object.points.forEach(([x, y], i) => {
      if (i === 0) pdf.moveTo(left + x * scale, top + (size[1] - y) * scale);
      pdf.lineTo(left + x * scale, top + (size[1] - y) * scale);
    });
    pdf.stroke();
  }
}
