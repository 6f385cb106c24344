import type { jsPDF } from 'jspdf';
import { TAG_CELLS, tagSheetMm } from '#scene/kinds/tag-thing';
import type { Scene, Tag } from '#scene/scene';
import { TAG_INSIDE, tagPattern } from '#picture/tag-pattern';
import { MARGIN_MM } from './print-plan';

/** An upright A4 sheet. */
const PAGE_MM = [210, 297] as const;
/** Room below a tag for its number. */
const FOOT_MM = 8;

/** A tag on its page: the upper left corner of its sheet. */
export interface TagPlace {
  readonly tag: Tag;
  readonly x: number;
  readonly y: number;
}

/** Lays the standing tags of a course out on pages, in their order; a tag larger than a page has one of its own. */
export function tagPages({ objects }: Scene): readonly (readonly TagPlace[])[] {
  const pages: TagPlace[][] = [];
  let [x, y, down] = [Infinity, Infinity, 0];
  for (const tag of objects) {
    if (tag.type !== 'tag' || tag.flat) continue;
    const sheet = tagSheetMm(tag.side);
    if (x + sheet > PAGE_MM[0] - MARGIN_MM) [x, y, down] = [MARGIN_MM, y + down, 0];
    if (y + sheet + FOOT_MM > PAGE_MM[1] - MARGIN_MM) {
      [x, y, down] = [MARGIN_MM, MARGIN_MM, 0];
      pages.push([]);
    }
    pages[pages.length - 1]?.push({ tag, x, y });
    x += sheet + MARGIN_MM;
    down = Math.max(down, sheet + FOOT_MM);
  }
  return pages;
}

/** Prints the standing tags of a course true to scale, to be cut out and put up: a thin line around each, its number below. */
export function printTags(pdf: jsPDF, scene: Scene): void {
  for (const places of tagPages(scene)) {
    const most = Math.max(...places.map(({ tag }) => tagSheetMm(tag.side)));
    const isLarge = most > PAGE_MM[0] - 2 * MARGIN_MM;
    pdf.addPage(isLarge ? [most + 2 * MARGIN_MM, most + 2 * MARGIN_MM + FOOT_MM] : [...PAGE_MM], 'portrait');
    pdf.setFont('helvetica', 'normal');
    pdf.setFontSize(9);
    for (const place of places) printTag(pdf, place);
  }
}

function printTag(pdf: jsPDF, { tag: { number, side }, x, y }: TagPlace): void {
  const cell = side / TAG_CELLS;
  const sheet = tagSheetMm(side);
  pdf.setDrawColor('#9AA3AE');
  pdf.setLineWidth(0.2);
  pdf.rect(x, y, sheet, sheet, 'S');
  pdf.setFillColor('#000000');
  pdf.rect(x + cell, y + cell, side, side, 'F');
  pdf.setFillColor('#FFFFFF');
  const first = (TAG_CELLS - TAG_INSIDE) / 2 + 1;
  for (const [row, cells] of tagPattern(number).entries()) {
    for (const [column, isWhite] of cells.entries()) {
      if (isWhite) pdf.rect(x + (first + column) * cell, y + (first + row) * cell, cell, cell, 'F');
    }
  }
  pdf.setTextColor('#000000');
  pdf.text(`AprilTag ${String(number)}`, x, y + sheet + 4);
}
