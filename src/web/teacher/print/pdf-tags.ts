import type { jsPDF } from 'jspdf';
import { radOf } from '#core/angle';
import { tagShapes } from '#picture/kinds/tag';
import { tagSheetMm } from '#scene/kinds/tag-thing';
import type { Point, Scene, SceneObject, Tag } from '#scene/scene';
import { MARGIN_MM } from './print-plan';
import type { ToSheet } from './shapes/pdf-shapes';

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

/** True of a tag that is wider than a page. */
const isLarge = ({ side }: Tag): boolean => tagSheetMm(side) > PAGE_MM[0] - 2 * MARGIN_MM;

/** Lays the standing tags of a course out on pages, in their order; a tag larger than a page has one of its own. */
export function tagPages({ objects }: Scene): readonly (readonly TagPlace[])[] {
  const pages: TagPlace[][] = [];
  let [x, y, down] = [Infinity, Infinity, 0];
  for (const tag of objects) {
    if (tag.type !== 'tag' || tag.flat) continue;
    const sheet = tagSheetMm(tag.side);
    if (isLarge(tag)) {
      pages.push([{ tag, x: MARGIN_MM, y: MARGIN_MM }]);
      [x, y, down] = [Infinity, Infinity, 0];
      continue;
    }
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
    const large = places.find(({ tag }) => isLarge(tag))?.tag;
    const side = large === undefined ? 0 : tagSheetMm(large.side) + 2 * MARGIN_MM;
    pdf.addPage(large === undefined ? [...PAGE_MM] : [side, side + FOOT_MM], 'portrait');
    pdf.setFont('helvetica', 'normal');
    pdf.setFontSize(9);
    for (const place of places) printTag(pdf, place);
  }
}

function printTag(pdf: jsPDF, { tag: { number, side }, x, y }: TagPlace): void {
  const sheet = tagSheetMm(side);
  pdf.setDrawColor('#9AA3AE');
  pdf.setLineWidth(0.2);
  pdf.rect(x, y, sheet, sheet, 'S');
  printPattern(pdf, number, side, ([right, down]) => [x + sheet / 2 + right, y + sheet / 2 + down]);
  pdf.setTextColor('#000000');
  pdf.text(`AprilTag ${String(number)}`, x, y + sheet + 4);
}

/** Prints the patterns of the tags that lie on the floor. Its other things are lines and words, for a pen. */
export function printLyingTags(pdf: jsPDF, objects: readonly SceneObject[], to: ToSheet): void {
  for (const tag of objects) {
    if (tag.type !== 'tag' || tag.flat !== true) continue;
    const { at, number, side, angle } = tag;
    const [cos, sin] = [Math.cos(radOf(angle)), Math.sin(radOf(angle))];
    printPattern(pdf, number, side, ([x, y]) => to([at[0] + x * cos + y * sin, at[1] + x * sin - y * cos]));
  }
}

/** @param to from a place on the tag, from its middle in mm, y down, to one on the sheet */
function printPattern(pdf: jsPDF, number: number, side: number, to: ToSheet): void {
  for (const shape of tagShapes(number, side)) {
    if (shape.form !== 'rect') continue;
    const [[left, top], [width, height]] = [shape.at, shape.size];
    const [right, bottom] = [left + width, top + height];
    pdf.setFillColor(shape.fill ?? '#000000');
    const corners: readonly Point[] = [[left, top], [right, top], [right, bottom], [left, bottom]]; // prettier-ignore
    for (const [place, corner] of corners.entries()) {
      const [x, y] = to(corner);
      if (place === 0) pdf.moveTo(x, y);
      else pdf.lineTo(x, y);
    }
    pdf.close();
    pdf.fill();
  }
}
