import type { jsPDF } from 'jspdf';
import { boundsMeet, type Bounds } from '#scene/outline';
import type { Point, Stroke } from '#scene/scene';

import { needsRim } from '../../../pupil/arena/picture/kinds/stroke';
import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { element, pathThrough } from './svg-write';
import type { PrintKind, ToPicture, ToSheet } from './kind';

/** Painted lines. */
export const stroke: PrintKind<Stroke> = { layer: 1, svg: strokeSvg, pdf: printStroke };

function strokeSvg({ points, width, color }: Stroke, to: ToPicture): string {
  const [first = [0, 0]] = points;
  const places = points.length === 1 ? [first, first] : points;
  const common = {
    d: pathThrough(places.map(to)),
    fill: 'none',
    'stroke-linecap': 'round',
    'stroke-linejoin': 'round',
  };
  const rim = needsRim({ color })
    ? element('path', { ...common, stroke: colors.strokeEdge, 'stroke-width': width + 2 })
    : '';
  return rim + element('path', { ...common, stroke: colors.strokes[color], 'stroke-width': width });
}

function printStroke(pdf: jsPDF, { points, width, color }: Stroke, to: ToSheet, shown: Bounds): void {
  const half = width / 2;
  const reach = { minX: shown.minX - half, maxX: shown.maxX + half, minY: shown.minY - half, maxY: shown.maxY + half };
  pdf.setLineWidth(width);
  pdf.setLineCap('round');
  pdf.setLineJoin('round');
  // Printed black must be as dark as it goes: the robot's sensors look at it.
  pdf.setDrawColor(color === 'black' ? '#000000' : colors.strokes[color]);
  for (const run of runsWithin(points, reach)) {
    run.forEach((point, i) => {
      const [x, y] = to(point);
      if (i === 0) pdf.moveTo(x, y);
      else pdf.lineTo(x, y);
    });
    pdf.stroke();
  }
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
