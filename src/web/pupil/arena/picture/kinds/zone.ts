import { mdiCheckBold, mdiFlagCheckered } from '@mdi/js';
import { rotationRad } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { SceneObject, Zone } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import { once } from '../../../../kit/state/memo';
import { canvasFont, type Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';
import { formOf, formPath, roomIn } from './shape-path';

/** How far a zone has been dealt with in this run. */
export type ZoneState = 'open' | 'reached';

/** A checkpoint is reached when it is among the first that were passed; a target, when all of its kind are. */
export function zoneState(zone: Zone, objects: readonly SceneObject[], verdict: Verdict | null): ZoneState {
  if (verdict === null) return 'open';
  const isReached =
    zone.type === 'checkpoint'
      ? objects.filter((other) => other.type === 'checkpoint' && other.number < zone.number).length <
        verdict.checkpoints.passed
      : zone.type === 'target' &&
        isAll(zone.blocks > 0 ? verdict.blocks.delivered : verdict.targets.reached, zone, verdict);
  return isReached ? 'reached' : 'open';
}

const isAll = (count: number, { blocks }: Zone, verdict: Verdict): boolean =>
  count >= (blocks > 0 ? verdict.blocks.of : verdict.targets.of);

/** Side of a square of the chequered edge in mm, and how many rows of them there are. */
const SQUARE_MM = 11;
const ROWS = 2;

/** Draws the ground of a zone: dashes around a pale colour. Lines lie over it. */
export function drawZoneGround(context: CanvasRenderingContext2D, view: View, zone: Zone, palette: Palette): void {
  const at = toPx(view, { x: zone.at[0], y: zone.at[1] });
  const [width, height] = zone.size;
  const px = 1 / view.pxPerMm;
  const line = Math.max(1.5 * px, Math.min(3, Math.min(width, height) / 12));
  context.save();
  context.translate(at.x, at.y);
  context.scale(view.pxPerMm, view.pxPerMm);
  context.rotate(-rotationRad(zone.angle));
  context.fillStyle = palette[`${zone.type}Fill`];
  outline(context, zone, 0);
  context.fill();
  context.save();
  context.clip();
  if (zone.type === 'forbidden') drawHatch(context, zone, Math.max(16, 9 * px), palette);
  if (zone.type === 'target') drawChequers(context, zone, palette);
  context.restore();
  context.strokeStyle = palette[zone.type];
  context.lineWidth = line;
  if (zone.type !== 'forbidden') context.setLineDash(zone.type === 'target' ? [10, 7] : [4, 5]);
  context.lineCap = zone.type === 'checkpoint' ? 'round' : 'butt';
  outline(context, zone, line / 2);
  context.stroke();
  context.restore();
}

/** Draws the sign in the middle of a zone, upright however the zone is turned; over lines, which run through many a zone. */
export function drawZoneSign(
  context: CanvasRenderingContext2D,
  view: View,
  zone: Zone,
  state: ZoneState,
  palette: Palette,
): void {
  const radius = signRadius(zone, view);
  if (radius * view.pxPerMm < 3.5) return;
  const at = toPx(view, signPlace(zone));
  context.save();
  context.translate(at.x, at.y);
  context.scale(view.pxPerMm, view.pxPerMm);
  if (state === 'reached') drawReached(context, radius, palette);
  else if (zone.type === 'checkpoint') drawNumber(context, zone.number, radius, palette);
  else if (zone.type === 'forbidden') drawNoEntry(context, radius, palette);
  else if (zone.blocks > 0) drawBlocksWanted(context, zone.blocks, radius, palette);
  else drawGlyph(context, 'flag', radius * 1.1, palette.target, palette.signGround);
  context.restore();
}

function outline(context: CanvasRenderingContext2D, zone: Zone, insetMm: number): void {
  const short = Math.min(...zone.size) - 2 * insetMm;
  formPath(context, formOf(zone), insetMm, Math.min(4, Math.max(1, short) / 6));
}

/** Two rows of squares along the lower edge; around a target that is no rectangle, along all of its edge. */
function drawChequers(context: CanvasRenderingContext2D, zone: Zone, palette: Palette): void {
  const [width, height] = zone.size;
  const square = Math.min(SQUARE_MM, width / 8, height / 8);
  context.save();
  context.globalAlpha *= 0.8;
  if (zone.corners) {
    context.strokeStyle = palette.target;
    context.lineWidth = square;
    context.setLineDash([square, square]);
    for (let row = 0; row < ROWS; row += 1) {
      context.lineDashOffset = row * square;
      outline(context, zone, (row + 0.5) * square);
      context.stroke();
    }
  } else if (zone.round) {
    context.strokeStyle = palette.target;
    context.lineWidth = square;
    for (let row = 0; row < ROWS; row += 1) {
      const inset = (row + 0.5) * square;
      const [a, b] = [width / 2 - inset, height / 2 - inset];
      // The circumference (Ramanujan), so that the last square meets the first.
      const round = Math.PI * (3 * (a + b) - Math.sqrt((3 * a + b) * (a + 3 * b)));
      const dash = round / (2 * Math.max(4, Math.round(round / square / 2)));
      context.setLineDash([dash, dash]);
      context.lineDashOffset = row * dash;
      context.beginPath();
      context.ellipse(0, 0, a, b, 0, 0, 2 * Math.PI);
      context.stroke();
    }
  } else {
    context.fillStyle = palette.target;
    context.beginPath();
    for (let row = 0; row < ROWS; row += 1)
      for (let x = row * square; x < width; x += 2 * square)
        context.rect(-width / 2 + x, height / 2 - (row + 1) * square, square, square);
    context.fill();
  }
  context.restore();
}

function drawHatch(context: CanvasRenderingContext2D, zone: Zone, pitch: number, palette: Palette): void {
  const reach = (zone.size[0] + zone.size[1]) / 2;
  const half = zone.size[1] / 2;
  context.save();
  context.globalAlpha *= 0.42;
  context.strokeStyle = palette.forbidden;
  context.lineWidth = pitch * 0.16;
  context.beginPath();
  for (let x = -reach - pitch; x <= reach + pitch; x += pitch) {
    context.moveTo(x - half, half);
    context.lineTo(x + half, -half);
  }
  context.stroke();
  context.restore();
}

/** Where a zone has its sign: in its middle, or where a hollow one has the most room. World mm. */
export function signPlace({ at, angle, ...zone }: Zone): Vec {
  const { x, y } = roomIn(formOf(zone)).at;
  const [cos, sin] = [Math.cos(rotationRad(angle)), Math.sin(rotationRad(angle))];
  return { x: at[0] + x * cos + y * sin, y: at[1] + x * sin - y * cos };
}

/** Radius of a zone's sign in mm: no larger than fits, no smaller than can be read where there is room. */
function signRadius(zone: Zone, view: View): number {
  const room = 0.3 * roomIn(formOf(zone)).acrossMm;
  return Math.min(room, Math.max(20, 11 / view.pxPerMm));
}

function drawReached(context: CanvasRenderingContext2D, radius: number, palette: Palette): void {
  disc(context, radius);
  context.fillStyle = palette.reached;
  context.fill();
  drawGlyph(context, 'check', radius * 0.72, palette.signGround);
}

function drawNumber(context: CanvasRenderingContext2D, number: number, radius: number, palette: Palette): void {
  disc(context, radius);
  context.fillStyle = palette.signGround;
  context.fill();
  context.strokeStyle = palette.checkpoint;
  context.lineWidth = radius * 0.16;
  context.stroke();
  write(context, String(number), radius * (number > 9 ? 0.95 : 1.2), palette.checkpoint);
}

function drawNoEntry(context: CanvasRenderingContext2D, radius: number, palette: Palette): void {
  disc(context, radius * 0.9);
  context.fillStyle = palette.signGround;
  context.fill();
  context.strokeStyle = palette.forbidden;
  context.lineWidth = radius * 0.26;
  context.stroke();
  const end = radius * 0.62;
  context.beginPath();
  context.moveTo(-end, -end);
  context.lineTo(end, end);
  context.stroke();
}

/** "3 ×" and a small block as those that can be pushed, on a ground of their own. */
function drawBlocksWanted(context: CanvasRenderingContext2D, count: number, radius: number, palette: Palette): void {
  const side = radius * 1.15;
  context.save();
  context.beginPath();
  context.roundRect(-radius * 1.35, -radius * 0.85, radius * 2.85, radius * 1.7, radius * 0.3);
  context.fillStyle = palette.signGround;
  context.fill();
  context.translate(-radius * 0.62, 0);
  write(context, `${String(count)}×`, radius * 0.95, palette.target);
  context.translate(radius * 1.35, 0);
  context.beginPath();
  context.roundRect(-side / 2, -side / 2, side, side, side * 0.16);
  context.fillStyle = palette.movable;
  context.fill();
  context.strokeStyle = palette.movableInk;
  context.lineWidth = side * 0.13;
  context.stroke();
  context.restore();
}

function disc(context: CanvasRenderingContext2D, radius: number): void {
  context.beginPath();
  context.arc(0, 0, radius, 0, 2 * Math.PI);
}

function write(context: CanvasRenderingContext2D, text: string, size: number, color: string): void {
  context.font = `700 ${size.toFixed(2)}px ${canvasFont}`;
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  context.fillStyle = color;
  context.fillText(text, 0, size * 0.355); // half the height of a figure
}

const glyphs = once(() => ({ flag: new Path2D(mdiFlagCheckered), check: new Path2D(mdiCheckBold) }));

/** Width of the rim around a glyph, in parts of 24 of its size: it fills the white squares of a flag as well. */
const RIM = 4;

/** An icon in the middle, this many mm from there to its edge; with a rim it can be read on a line. */
function drawGlyph(
  context: CanvasRenderingContext2D,
  name: 'flag' | 'check',
  half: number,
  color: string,
  rim: string | null = null,
): void {
  const glyph = glyphs()[name];
  context.save();
  context.scale(half / 12, half / 12);
  context.translate(-12, -12);
  if (rim !== null) {
    context.strokeStyle = rim;
    context.lineWidth = RIM;
    context.lineJoin = 'round';
    context.stroke(glyph);
  }
  context.fillStyle = color;
  context.fill(glyph);
  context.restore();
}
