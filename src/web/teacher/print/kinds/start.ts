import type { jsPDF } from 'jspdf';
import { START_SIDE_MM } from '#scene/kinds/start';
import { robotColors, type Point, type Start } from '#scene/scene';

import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { deviceColor } from '../../../pupil/arena/model/device-colors';
import { polygon, write } from './pdf-parts';
import { element, escapeXml, figure, pathThrough } from './svg-write';
import type { PrintKind, ToPicture, ToSheet } from './kind';
import { rect, SVG_FONT, turned } from './svg-parts';

/** Starts of further robots. */
export const start: PrintKind<Start> = { layer: 2, svg: startSvg, pdf: printStart };

const LINE_MM = 3;
/** Height of the name, and how far behind the axle it stands, in mm. */
const NAME_MM = 18;
const BEHIND_MM = 0.38 * START_SIDE_MM;
/** The box around it, in the robot's frame. */
const HALF_MM = START_SIDE_MM / 2;
const BOX: readonly Point[] = [
  [-HALF_MM, -HALF_MM],
  [HALF_MM, -HALF_MM],
  [HALF_MM, HALF_MM],
  [-HALF_MM, HALF_MM],
];
/** The arrow ahead: its tip and its wings, in the robot's frame. */
const ARROW: readonly Point[] = [
  [0.42 * START_SIDE_MM, 0],
  [0.24 * START_SIDE_MM, 0.14 * START_SIDE_MM],
  [0.24 * START_SIDE_MM, -0.14 * START_SIDE_MM],
];

const colorOf = ({ color }: Start): string => (color === null ? colors.label : deviceColor(robotColors.indexOf(color)));

function startSvg(start: Start, to: ToPicture, leastMm: number): string {
  const size = Math.max(1.2 * NAME_MM, leastMm);
  // Larger than it is, the name has no room in the box.
  const behind = leastMm > 1.2 * NAME_MM ? HALF_MM + 0.85 * size : BEHIND_MM + NAME_MM / 3;
  const color = colorOf(start);
  const side = START_SIDE_MM - LINE_MM;
  const box = rect([side, side], 0, {
    fill: 'none',
    stroke: color,
    'stroke-width': LINE_MM,
    'stroke-dasharray': '12 7',
  });
  const arrow = element('path', { d: pathThrough([...ARROW], true), fill: color });
  const name =
    start.name === ''
      ? ''
      : element(
          'text',
          {
            transform: `rotate(90) translate(0 ${figure(behind)})`,
            'font-family': SVG_FONT,
            'font-size': size,
            'font-weight': 600,
            'text-anchor': 'middle',
            fill: color,
          },
          escapeXml(start.name),
        );
  return element('g', { transform: turned(to(start.at), -start.heading) }, box + arrow + name);
}

function printStart(pdf: jsPDF, start: Start, to: ToSheet): void {
  const color = colorOf(start);
  pdf.setDrawColor(color);
  pdf.setLineWidth(LINE_MM);
  pdf.setLineDashPattern([12, 7], 0);
  outline(pdf, BOX, start, to);
  pdf.setLineDashPattern([], 0);
  outline(pdf, ARROW, start, to);
  if (start.name === '') return;
  pdf.setTextColor(color);
  write(pdf, start.name, to(placed(start, [-BEHIND_MM, 0])), NAME_MM, start.heading - 90);
}

/** An outline in the robot's frame. */
function outline(pdf: jsPDF, corners: readonly Point[], start: Start, to: ToSheet): void {
  polygon(
    pdf,
    corners.map(([x, y]) => ({ x, y })),
    (corner) => to(placed(start, corner)),
  );
}

/** A place in the robot's frame on the floor. */
function placed({ at, heading }: Start, [x, y]: Point): Point {
  const angle = (heading * Math.PI) / 180;
  return [at[0] + x * Math.cos(angle) - y * Math.sin(angle), at[1] + x * Math.sin(angle) + y * Math.cos(angle)];
}
