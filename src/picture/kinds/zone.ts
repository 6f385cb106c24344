import { mdiCheckBold, mdiFlagCheckered } from '@mdi/js';
import { directionOf } from '#scene/outline';
import type { Point, Zone } from '#scene/scene';

import { formOf, signRoomIn, geometryOf, stripes } from '../form';
import type { Look } from '../look';
import { paints } from '../paints';
import { circle, group, rect, written, type Geometry, type Shape } from '../shapes';
import { boxFrame, type PictureKind } from './kind';
import { CAPITAL } from './label';

/** Zones of all kinds. */
export const zone: PictureKind<Zone> = {
  ground: (zone, look) => [group(zone.at, groundShapes(zone, look), zone.angle)],
  sign: zoneSign,
  paper: paperShapes,
  frame: boxFrame,
};

/** Side of a square of the chequered edge in mm, and how many rows of them there are. */
const SQUARE_MM = 11;
const ROWS = 2;

/** The ground of a zone: a pale colour with an edge, which is dashed except for forbidden zones. */
function groundShapes(zone: Zone, look: Look): readonly Shape[] {
  const [width, height] = zone.size;
  const line = Math.max(1.5 * look.px, Math.min(3, Math.min(width, height) / 12));
  const paint = zone.color && paints[zone.color];
  const color = paint?.ink ?? look.colors[zone.type];
  return [
    paint
      ? { ...outline(zone, 0), fill: paint.fill, opacity: 0.85 }
      : { ...outline(zone, 0), fill: look.colors[`${zone.type}Fill`] },
    ...(zone.type === 'forbidden' ? [hatch(zone, look)] : []),
    ...(zone.type === 'target' ? chequers(zone, color) : []),
    {
      ...outline(zone, line / 2),
      ...{ stroke: color, width: line, cap: zone.type === 'checkpoint' ? 'round' : undefined },
      dash: { target: [10, 7], checkpoint: [4, 5], forbidden: undefined }[zone.type],
    },
  ];
}

function outline(zone: Zone, insetMm: number): Geometry {
  const short = Math.min(...zone.size) - 2 * insetMm;
  return geometryOf(formOf(zone), insetMm, Math.min(4, Math.max(1, short) / 6));
}

function hatch(zone: Zone, { colors, px }: Look): Shape {
  const pitch = Math.max(16, 9 * px);
  const first = -(zone.size[0] + zone.size[1]) / 2 - pitch;
  return { ...stripes(formOf(zone), { first, pitch, width: pitch * 0.16 }), fill: colors.forbidden, opacity: 0.42 };
}

/** Two rows of squares along the lower edge; around a target that is no rectangle, along all of its edge. */
function chequers(zone: Zone, color: string): readonly Shape[] {
  const [width, height] = zone.size;
  const square = Math.min(SQUARE_MM, width / 8, height / 8);
  const rows = Array.from({ length: ROWS }, (_, row) => row);
  if (zone.corners || zone.round)
    return rows.map((row) => {
      const inset = (row + 0.5) * square;
      const dash = zone.corners ? square : roundDash(width / 2 - inset, height / 2 - inset, square);
      const paint = { stroke: color, opacity: 0.8, width: square, dash: [dash, dash], dashFrom: row * dash };
      return { ...outline(zone, inset), ...paint };
    });
  const squares = rows.flatMap((row) => {
    const [top, bottom] = [height / 2 - (row + 1) * square, height / 2 - row * square];
    return Array.from({ length: Math.ceil(width / square / 2) }, (_, i): readonly Point[] => {
      const left = (row + 2 * i) * square - width / 2;
      const right = Math.min(left + square, width / 2);
      return [[left, top], [right, top], [right, bottom], [left, bottom]]; // prettier-ignore
    });
  });
  const within = squares.filter(([upperLeft = [0, 0]]) => upperLeft[0] < width / 2 - 0.01);
  return [{ form: 'lines', lines: within, isClosed: true, fill: color, opacity: 0.8 }];
}

/** About so long that the last dash around an ellipse meets the first: its circumference is Ramanujan's. */
function roundDash(a: number, b: number, about: number): number {
  const around = Math.PI * (3 * (a + b) - Math.sqrt((3 * a + b) * (a + 3 * b)));
  return around / (2 * Math.max(4, Math.round(around / about / 2)));
}

/** Place of a zone's sign: its middle, or the most roomy place of a hollow one. World mm. */
function signPlace({ at, angle, ...zone }: Zone): Point {
  const { x, y } = signRoomIn(formOf(zone)).at;
  const { x: cos, y: sin } = directionOf(angle);
  return [at[0] + x * cos + y * sin, at[1] + x * sin - y * cos];
}

/** The sign in the middle of a zone, upright however the zone is turned: no larger than fits, where there is room none too small to read. */
function zoneSign(zone: Zone, look: Look, isReached = false): readonly Shape[] {
  const room = 0.3 * signRoomIn(formOf(zone)).acrossMm;
  const radius = Math.max(look.leastTypeMm ?? 0, Math.min(room, Math.max(20, 11 * look.px)));
  if (radius < 3.5 * look.px) return [];
  return [group(signPlace(zone), isReached ? reached(radius, look) : signShapes(zone, radius, look))];
}

function signShapes({ type, number, blocks, blockColor }: Zone, radius: number, look: Look): readonly Shape[] {
  const { signGround, [type]: color } = look.colors;
  if (type === 'checkpoint')
    return [
      circle(radius, { fill: signGround, stroke: color, width: radius * 0.16 }),
      written(String(number), radius * (number > 9 ? 0.95 : 1.2), color),
    ];
  if (type === 'forbidden') {
    const [end, line] = [radius * 0.62, { stroke: color, width: radius * 0.26 }];
    return [
      circle(radius * 0.9, { fill: signGround, ...line }),
      { form: 'lines', lines: [[[-end, -end], [end, end]]], ...line }, // prettier-ignore
    ];
  }
  if (blocks > 0) return wanted(blocks, radius, look, blockColor);
  const flag = { form: 'icon', path: mdiFlagCheckered, across: radius * 2.2 } as const;
  // The rim fills the white squares of the flag as well.
  return [
    { ...flag, stroke: signGround, width: 4, join: 'round' },
    { ...flag, fill: color },
  ];
}

/** "3 ×" and a small block as those that can be pushed, on a ground of their own. */
function wanted(count: number, radius: number, { colors }: Look, color: Zone['blockColor']): readonly Shape[] {
  const { fill, ink } = color === undefined ? { fill: colors.movable, ink: colors.movableInk } : paints[color];
  const side = radius * 1.15;
  const block = rect([side, side], side * 0.16, {
    ...{ fill, stroke: ink, width: side * 0.13 },
  });
  return [
    {
      ...{ form: 'rect', at: [-radius * 1.35, -radius * 0.85], size: [radius * 2.85, radius * 1.7] },
      ...{ round: radius * 0.3, fill: colors.signGround },
    },
    written(`${String(count)}×`, radius * 0.95, colors.target, -radius * 0.62),
    group([radius * 0.73, 0], [block]),
  ];
}

function reached(radius: number, { colors }: Look): readonly Shape[] {
  return [
    circle(radius, { fill: colors.reached }),
    { form: 'icon', path: mdiCheckBold, across: radius * 1.44, fill: colors.signGround },
  ];
}

function paperShapes(zone: Zone, { colors }: Look): readonly Shape[] {
  const line = { stroke: colors[zone.type], width: 0.6 };
  const dash = zone.type === 'forbidden' ? undefined : [5, 3];
  const [x, y] = [zone.size[0] / 2, zone.size[1] / 2];
  const cross = { form: 'lines', lines: [[[-x, -y], [x, y]], [[-x, y], [x, -y]]] } as const; // prettier-ignore
  const isCrossed = zone.type === 'forbidden' && !zone.round && !zone.corners;
  const size = Math.min(15, 0.25 * signRoomIn(formOf(zone)).acrossMm) / CAPITAL;
  return [
    group(
      zone.at,
      [{ ...geometryOf(formOf(zone), 0, 0), ...line, dash }, ...(isCrossed ? [{ ...cross, ...line }] : [])],
      zone.angle,
    ),
    ...(zone.type === 'checkpoint'
      ? [group(signPlace(zone), [written(String(zone.number), size, colors.checkpoint)])]
      : []),
  ];
}
