import { jsPDF } from 'jspdf';

import { printRow, withPrintable } from '../task/pdf-rows';
import { layOutSheet, SHEET_MM, type Box, type Mark, type SheetContent } from './sheet-layout';
import { LINE_COLORS, LINE_MM, squareLines } from './svg-sheet';

/** The properties of a PDF besides its content. */
export interface SheetFile {
  readonly title: string;
  /** The drawing of the course as a PNG; its scale on the sheet is known only now. */
  readonly drawing: (scale: number, longestMm: number) => Promise<Uint8Array>;
  /** The link behind the code: also for reading the sheet on a screen. */
  readonly link: string | null;
  readonly isCompressed?: boolean;
}

/** A worksheet as PDF. */
export async function sheetPdf(content: SheetContent, file: SheetFile): Promise<jsPDF> {
  const { pages, course } = layOutSheet(content, withPrintable);
  const drawing = await file.drawing(course.scale, Math.max(...course.size));
  const pdf = new jsPDF({ unit: 'mm', format: [...SHEET_MM], compress: file.isCompressed ?? true, floatPrecision: 3 });
  pdf.setProperties({ title: file.title, creator: 'Parcours' });
  pdf.viewerPreferences({ PrintScaling: 'None' }); // otherwise the scale below the drawing is not true
  pages.forEach((marks, index) => {
    if (index > 0) pdf.addPage([...SHEET_MM], 'portrait');
    for (const mark of marks) printMark(pdf, mark, content, drawing, file.link);
  });
  return pdf;
}

function printMark(
  pdf: jsPDF,
  mark: Mark,
  { task, qr }: SheetContent,
  drawing: Uint8Array,
  link: SheetFile['link'],
): void {
  switch (mark.kind) {
    case 'row':
      return printRow(pdf, mark.row, mark.at, task.picture);
    case 'line':
      return printLines(pdf, mark.isStrong ? 'strong' : 'write', [[mark.from, mark.to]]);
    case 'squares':
      return printLines(pdf, 'squares', squareLines(mark));
    case 'course':
      pdf.addImage(drawing, 'PNG', ...mark.at, ...mark.size, 'course', 'FAST');
      return;
    case 'qr':
      return printQr(pdf, mark, qr, link);
    default:
      return mark satisfies never;
  }
}

function printLines(pdf: jsPDF, look: keyof typeof LINE_MM, lines: ReturnType<typeof squareLines>): void {
  pdf.setDrawColor(LINE_COLORS[look]);
  pdf.setLineWidth(LINE_MM[look]);
  pdf.setLineCap('butt');
  pdf.setLineDashPattern([], 0);
  for (const [from, to] of lines) pdf.line(from[0], from[1], to[0], to[1]);
}

/** The squares overlap a little: many readers show a gap where they only touch. */
const OVERLAP_MM = 0.02;

function printQr(
  pdf: jsPDF,
  { at: [left, top], size: [side] }: Box,
  qr: SheetContent['qr'],
  link: SheetFile['link'],
): void {
  if (qr === null) return;
  pdf.setFillColor('#000000');
  const { squareMm } = qr;
  for (const { x, y, length } of qr.runs)
    pdf.rect(left + x * squareMm, top + y * squareMm, length * squareMm, squareMm + OVERLAP_MM, 'F');
  if (link !== null) pdf.link(left, top, side, side, { url: link });
}
