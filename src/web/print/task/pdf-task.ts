import type { jsPDF } from 'jspdf';

import { printable, PT_PER_MM } from '../kinds/pdf-parts';
import { CODE_RIM, CODE_SCALE } from './letter-widths';
import { breakPages, LEADING, setRows, type PaperBlock, type Piece, type PlacedRow, type Sign } from './set-rows';
import { taskBlocks, TEXT_MM, type PaperTask } from './task-blocks';

/** Sheets of A4, whatever the course is printed on: the task is read, not laid on the floor. */
const PAGE = { width: 210, height: 297, margin: 20, foot: 10 } as const;
const WIDTH = PAGE.width - 2 * PAGE.margin;

/** Where the base line of a row is, in type sizes from its top. */
const BASE = (LEADING - 1) / 2 + 0.8;

/** Prints the task on sheets of its own, after all others. */
export function printTask(pdf: jsPDF, task: PaperTask): void {
  const pages = breakPages(setRows(taskBlocks(task, WIDTH).map(withPrintable), WIDTH), PAGE.height - 2 * PAGE.margin);
  pages.forEach((rows, index) => {
    pdf.addPage([PAGE.width, PAGE.height], 'portrait');
    for (const row of rows) printRow(pdf, row, task);
    if (pages.length > 1) printFoot(pdf, task.title, index + 1, pages.length);
  });
}

/** Only signs that the fonts of a PDF have. */
function withPrintable(block: PaperBlock): PaperBlock {
  if (block.kind === 'picture') return block;
  return {
    ...block,
    lines: block.lines.map((line) => line.map((span) => ({ ...span, text: printable(span.text) }))),
  };
}

function printRow(pdf: jsPDF, { row, topMm }: PlacedRow, { picture }: PaperTask): void {
  const top = PAGE.margin + topMm;
  if (row.picture !== null) {
    if (picture !== null)
      pdf.addImage(picture.data, picture.format, PAGE.margin, top, ...row.picture, 'task', 'FAST'); // prettier-ignore
    return;
  }
  const base = top + BASE * row.sizeMm;
  pdf.setTextColor('#000000');
  for (const piece of row.pieces) printPiece(pdf, piece, base, row.sizeMm);
  if (row.sign !== null) printSign(pdf, row.sign, base, row.sizeMm);
}

function printPiece(pdf: jsPDF, { kind, text, xMm, widthMm }: Piece, base: number, sizeMm: number): void {
  if (text.trim() === '') return;
  const isCode = kind === 'code';
  const x = PAGE.margin + xMm;
  if (isCode) {
    pdf.setFillColor('#ECEFF2');
    pdf.roundedRect(x, base - 0.85 * sizeMm, widthMm, 1.15 * sizeMm, 0.6, 0.6, 'F');
  }
  pdf.setFont(isCode ? 'courier' : 'helvetica', kind === 'text' ? 'normal' : 'bold');
  pdf.setFontSize((isCode ? CODE_SCALE : 1) * sizeMm * PT_PER_MM);
  pdf.text(text, isCode ? x + CODE_RIM * sizeMm : x, base);
}

function printSign(pdf: jsPDF, sign: Sign, base: number, sizeMm: number): void {
  const left = PAGE.margin;
  if (sign.kind === 'mark') {
    pdf.setFont('helvetica', 'normal');
    pdf.setFontSize(sizeMm * PT_PER_MM);
    pdf.text(sign.text, left + 0.2 * sizeMm, base);
    return;
  }
  const middle = base - 0.35 * sizeMm;
  pdf.setDrawColor('#000000');
  pdf.setLineWidth(0.3);
  pdf.setLineDashPattern([], 0);
  if (sign.kind === 'ring') pdf.circle(left + 0.6 * sizeMm, middle, 0.48 * sizeMm, 'S');
  else
    for (let star = 0; star < sign.count; star += 1)
      printStar(pdf, left + (0.6 + 1.25 * star) * sizeMm, middle, sizeMm);
}

/** A star of five points to colour in. */
function printStar(pdf: jsPDF, x: number, y: number, sizeMm: number): void {
  for (let corner = 0; corner < 10; corner += 1) {
    const radius = (corner % 2 === 0 ? 0.58 : 0.26) * sizeMm;
    const angle = (corner * Math.PI) / 5;
    const [toX, toY] = [x + radius * Math.sin(angle), y - radius * Math.cos(angle)];
    if (corner === 0) pdf.moveTo(toX, toY);
    else pdf.lineTo(toX, toY);
  }
  pdf.close();
  pdf.stroke();
}

/** Which of several sheets this is. */
function printFoot(pdf: jsPDF, title: string, page: number, of: number): void {
  pdf.setFont('helvetica', 'normal');
  pdf.setFontSize(0.7 * TEXT_MM * PT_PER_MM);
  pdf.setTextColor('#000000');
  const number = `${String(page)}/${String(of)}`;
  const y = PAGE.height - PAGE.foot;
  pdf.text(number, PAGE.width - PAGE.margin, y, { align: 'right' });
  const [line = ''] = pdf.splitTextToSize(printable(title), WIDTH - 20) as string[];
  pdf.text(line, PAGE.margin, y);
}
