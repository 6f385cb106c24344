import type { jsPDF } from 'jspdf';
import { radOf } from '#core/angle';
import { lightColors } from '#picture/colors';
import { paperShapes } from '#picture/course';
import { pairs } from '#picture/form';
import { boundsOf, solidParts } from '#scene/kinds/index';
import { boundsMeet, type Bounds } from '#scene/outline';
import type { Point, Scene } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';

import { MARGIN_MM, type Tile } from './print-plan';
import { printLyingTags } from './pdf-tags';
import { polyline, printShapes, type ToSheet } from './shapes/pdf-shapes';

/** The parts of a course that are printed. */
export interface FloorOptions {
  /** Thin outlines where walls, blocks and obstacles stand and where the robot starts. */
  readonly outlines: boolean;
  /** The background as a PNG or JPEG that the PDF can take, or `null`: none. */
  readonly background: { readonly data: string; readonly format: 'PNG' | 'JPEG' } | null;
}

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
  const near = scene.objects.filter((object) => !('size' in object) || boundsMeet(boundsOf(object), shown));
  printShapes(pdf, paperShapes(near, lightColors), to, shown);
  pdf.setLineDashPattern([], 0);
  printLyingTags(pdf, near, to);
  if (options.outlines) printOutlines(pdf, scene, to, shown);
  pdf.restoreGraphicsState();
}

function printBackground(pdf: jsPDF, { background }: Scene, to: ToSheet, options: FloorOptions): void {
  if (background === null || options.background === null) return;
  const { at, size } = background;
  const [x, y] = to([at[0], at[1] + size[1]]);
  const { data, format } = options.background;
  pdf.addImage(data, format, x, y, size[0], size[1], 'background', 'FAST');
}

/** Prints the outlines of things, for setting the course up, and the robot's start with its heading. */
function printOutlines(pdf: jsPDF, { objects, robot }: Scene, to: ToSheet, shown: Bounds): void {
  pdf.setDrawColor('#5C6671');
  pdf.setLineWidth(0.3);
  pdf.setLineCap('butt');
  for (const object of objects) {
    const parts = solidParts(object);
    if (parts.length === 0 || !boundsMeet(boundsOf(object), shown)) continue;
    for (const outline of 'size' in object ? [shapeOutline(object)] : parts) polyline(pdf, pairs(outline), to, true);
  }
  const heading = radOf(robot.heading);
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
