import { jsPDF } from 'jspdf';

import { printable } from '../shapes/pdf-shapes';

/** Sides of a sheet of A4 across, and its margin, in mm. */
const [WIDTH_MM, HEIGHT_MM, MARGIN_MM] = [297, 210, 12];
/** Height of the title, in mm. */
const TITLE_MM = 9;

/** A strip of pictures on one sheet of A4 across, with a title over it, as large as it goes. */
export function stripPdf(strip: HTMLCanvasElement, title: string): jsPDF {
  const pdf = new jsPDF({ unit: 'mm', format: 'a4', orientation: 'landscape', compress: true });
  pdf.setProperties({ title, creator: 'Parcours' });
  pdf.setFont('helvetica', 'bold');
  pdf.setFontSize(13);
  pdf.text(printable(title), MARGIN_MM, MARGIN_MM + 5);
  const room = [WIDTH_MM - 2 * MARGIN_MM, HEIGHT_MM - 2 * MARGIN_MM - TITLE_MM] as const;
  const scale = Math.min(room[0] / strip.width, room[1] / strip.height);
  const size = [strip.width * scale, strip.height * scale] as const;
  pdf.addImage(strip.toDataURL('image/png'), 'PNG', MARGIN_MM, MARGIN_MM + TITLE_MM, ...size);
  return pdf;
}
