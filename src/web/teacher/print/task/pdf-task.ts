import type { jsPDF } from 'jspdf';

import { printable, PT_PER_MM } from '../shapes/pdf-shapes';
import { printRow, withPrintable } from './pdf-rows';
import { breakPages, setRows } from './set-rows';
import { taskBlocks, TEXT_MM, type PaperTask } from './task-blocks';

/** Sheets of A4, whatever the course is printed on: the task is read, not laid on the floor. */
const PAGE = { width: 210, height: 297, margin: 20, foot: 10 } as const;
const WIDTH = PAGE.width - 2 * PAGE.margin;

/** Prints the task on sheets of its own, after all others. */
export function printTask(pdf: jsPDF, task: PaperTask): void {
  const pages = breakPages(setRows(taskBlocks(task, WIDTH).map(withPrintable), WIDTH), PAGE.height - 2 * PAGE.margin);
  pages.forEach((rows, index) => {
    pdf.addPage([PAGE.width, PAGE.height], 'portrait');
    for (const row of rows) printRow(pdf, row, [PAGE.margin, PAGE.margin], task.picture);
    if (pages.length > 1) printFoot(pdf, task.title, index + 1, pages.length);
  });
}

/** Prints the title, and which of several sheets this is. */
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
