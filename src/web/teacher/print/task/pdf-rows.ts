import type { jsPDF } from 'jspdf';

import type { Point } from '#scene/scene';

import { polyline, printable, PT_PER_MM } from '../shapes/pdf-shapes';
import { CODE_RIM, CODE_SCALE } from './letter-widths';
import { BASE, type PaperBlock, type Piece, type PlacedRow, type Sign } from './set-rows';
import { RING, starsAt } from './signs';
import type { PaperTask } from './task-blocks';

/** A block in only those signs that the fonts of a PDF have. */
export function withPrintable(block: PaperBlock): PaperBlock {
  if (block.kind === 'picture') return block;
  return {
    ...block,
    lines: block.lines.map((line) => line.map((span) => ({ ...span, text: printable(span.text) }))),
  };
}

/**
 * Prints a row.
 *
 * @param at upper left corner of the text on the page, in mm
 * @param picture the task's own
 */
export function printRow(pdf: jsPDF, { row, topMm }: PlacedRow, at: Point, picture: PaperTask['picture'] = null): void {
  const [left, top] = [at[0], at[1] + topMm];
  if (row.picture !== null) {
    if (picture !== null) pdf.addImage(picture.data, picture.format, left, top, ...row.picture, 'task', 'FAST');
    return;
  }
  const base: Point = [left, top + BASE * row.sizeMm];
  pdf.setTextColor('#000000');
  for (const piece of row.pieces) printPiece(pdf, piece, base, row.sizeMm);
  if (row.sign !== null) printSign(pdf, row.sign, base, row.sizeMm);
}

function printPiece(pdf: jsPDF, { kind, text, xMm, widthMm }: Piece, [left, base]: Point, sizeMm: number): void {
  if (text.trim() === '') return;
  const isCode = kind === 'code';
  const x = left + xMm;
  if (isCode) {
    pdf.setFillColor('#ECEFF2');
    pdf.roundedRect(x, base - 0.85 * sizeMm, widthMm, 1.15 * sizeMm, 0.6, 0.6, 'F');
  }
  pdf.setFont(isCode ? 'courier' : 'helvetica', kind === 'text' ? 'normal' : 'bold');
  pdf.setFontSize((isCode ? CODE_SCALE : 1) * sizeMm * PT_PER_MM);
  pdf.text(text, isCode ? x + CODE_RIM * sizeMm : x, base);
}

function printSign(pdf: jsPDF, sign: Sign, [left, base]: Point, sizeMm: number): void {
  if (sign.kind === 'mark') {
    pdf.setFont('helvetica', 'normal');
    pdf.setFontSize(sizeMm * PT_PER_MM);
    pdf.text(sign.text, left + 0.2 * sizeMm, base);
    return;
  }
  pdf.setDrawColor('#000000');
  pdf.setLineWidth(0.3);
  pdf.setLineDashPattern([], 0);
  if (sign.kind === 'ring')
    pdf.circle(left + RING.left * sizeMm, base - RING.aboveBase * sizeMm, RING.radius * sizeMm, 'S');
  else for (const star of starsAt(sign.count, [left, base], sizeMm)) polyline(pdf, star, (corner) => corner, true);
}
