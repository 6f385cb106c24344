import type { Pose, Vec } from '#core/geometry';
import { canvasFont, type Palette } from '../model/palette';
import { boxAround, type PxBox } from '../view/moving-window';
import { toPx, type View } from '../view/view-transform';

/** A line sensor as the arena shows it. */
export interface SensorSpot {
  readonly name: string;
  /** Robot frame, as on the real robot. */
  readonly atMm: Vec;
  readonly bright: boolean;
  /** Left out where the robot knows only light and dark. */
  readonly reading?: number;
}

/** Radius of the floor that is laid bare around a sensor, and of the spot that it sees, in mm of the real robot. */
const WINDOW_MM = 7;
const SPOT_MM = 2.5; // as the robots' line sensors see it

/** Smallest radii on the screen, in px: in a large arena they would otherwise be invisible. */
const LEAST_WINDOW_PX = 5;
const LEAST_SPOT_PX = 3;

/** Size of a reading's label, and its distance from the end of the robot, in px. */
const LABEL = { perDigit: 7, rim: 8, height: 19, gap: 3, away: 10.5 };

/**
 * A row of readings may be as wide as this on the floor, in mm of the real robot: else it would bury the robot. Chosen:
 * three robots.
 */
const WIDEST_ROW_MM = 330;

/** The edge of the picture may push readings this much nearer to the robot, in px. */
const NEARER_PX = 6;

/** Least distance of readings ahead from the hit of the distance sensor, in px: its label is there. */
const HIT_PX = 66;

/** A reading beside its sensor, px. */
export interface SpotLabel {
  readonly from: Vec;
  readonly at: Vec;
  readonly width: number;
  readonly text: string;
  readonly bright: boolean;
}

/** The surroundings that a row of readings must fit into. */
export interface LabelRow {
  /** Distances from its axle to the robot's front and back, at its size. */
  readonly frontMm: number;
  readonly backMm: number;
  /** The visible area, px: readings outside it would be lost. */
  readonly sight: PxBox;
  /** The hit of the distance sensor, px: its label must not cover readings ahead. `null`: there is none. */
  readonly hit: Vec | null;
}

/**
 * Places the readings in a row ahead of the robot, in the order of the sensors from left to right and far enough from
 * each other to be read; behind it if there is no room ahead, and nowhere at a zoom at which they would bury the robot.
 *
 * @param scale size of the robot compared with the real one
 */
export function spotLabels(
  view: View,
  pose: Pose,
  scale: number,
  row: LabelRow,
  spots: readonly SensorSpot[],
): SpotLabel[] {
  const shown = spots.filter(({ reading }) => reading !== undefined).sort((a, b) => b.atMm.y - a.atMm.y);
  const texts = shown.map(({ reading = 0 }) => String(Math.round(reading)));
  const width = LABEL.rim + LABEL.perDigit * Math.max(3, ...texts.map((text) => text.length));
  if (shown.length * (width + LABEL.gap) > WIDEST_ROW_MM * scale * view.pxPerMm) return [];
  const places = rowPlaces(view, pose, row, { count: shown.length, width });
  return shown.map((spot, i) => ({
    from: spotPx(view, pose, scale, spot.atMm),
    at: places[i] ?? { x: 0, y: 0 },
    width,
    text: texts[i] ?? '',
    bright: spot.bright,
  }));
}

/** The middles of the labels: ahead, else behind, moved into sight. */
function rowPlaces(
  view: View,
  pose: Pose,
  { frontMm, backMm, sight, hit }: LabelRow,
  { count, width }: { readonly count: number; readonly width: number },
): readonly Vec[] {
  const ahead = { x: Math.cos(pose.headingRad), y: -Math.sin(pose.headingRad) }; // px: y down
  const right = { x: -ahead.y, y: ahead.x };
  const step = Math.min(
    (width + LABEL.gap) / Math.max(1e-6, Math.abs(right.x)),
    (LABEL.height + LABEL.gap) / Math.max(1e-6, Math.abs(right.y)),
  );
  const origin = toPx(view, { x: pose.xMm, y: pose.yMm });
  const halfLabel = (Math.abs(ahead.x) * width + Math.abs(ahead.y) * LABEL.height) / 2;
  const rowAt = (side: 1 | -1) => {
    const away = side * ((side === 1 ? frontMm : backMm) * view.pxPerMm + LABEL.away + halfLabel);
    const middles = Array.from({ length: count }, (_, i) => {
      const aside = (i - (count - 1) / 2) * step;
      return { x: origin.x + ahead.x * away + right.x * aside, y: origin.y + ahead.y * away + right.y * aside };
    });
    const by = intoSight(middles, width, sight);
    return {
      nearer: -side * (by.x * ahead.x + by.y * ahead.y),
      places: middles.map(({ x, y }) => ({ x: x + by.x, y: y + by.y })),
    };
  };
  const front = rowAt(1);
  const isFree = hit === null || front.places.every(({ x, y }) => Math.hypot(x - hit.x, y - hit.y) > HIT_PX);
  if (front.nearer <= NEARER_PX && isFree) return front.places;
  const back = rowAt(-1);
  return back.nearer <= NEARER_PX || back.nearer < front.nearer ? back.places : front.places;
}

/** Shift of a row of labels that brings all of them into sight. */
function intoSight(middles: readonly Vec[], width: number, sight: PxBox): Vec {
  const shift = (values: readonly number[], half: number, from: number, size: number): number => {
    const least = from + half + LABEL.gap - Math.min(...values);
    const most = from + size - half - LABEL.gap - Math.max(...values);
    return least > 0 ? least : Math.min(0, most);
  };
  return {
    x: shift(middles.map(({ x }) => x), width / 2, sight.left, sight.width),
    y: shift(middles.map(({ y }) => y), LABEL.height / 2, sight.top, sight.height),
  }; // prettier-ignore
}

/** The areas of the labels and spots, in px. */
export function spotsBoxes(
  view: View,
  pose: Pose,
  scale: number,
  spots: readonly SensorSpot[],
  labels: readonly SpotLabel[],
): PxBox[] {
  const boxes = labels.map(({ at, width }) => boxAround(at, width));
  for (const { atMm } of spots)
    boxes.push(boxAround(spotPx(view, pose, scale, atMm), WINDOW_MM * scale * view.pxPerMm + LEAST_WINDOW_PX));
  return boxes;
}

/**
 * Shows the floor under each line sensor through the robot, with the spot that the sensor sees: light with a dark rim
 * or dark with a light one. Each reading is at the end of a thin line.
 *
 * @param context of a canvas above the floor with only moving things on it: holes are cut into it
 */
export function drawSpots(
  context: CanvasRenderingContext2D,
  view: View,
  pose: Pose,
  scale: number,
  spots: readonly SensorSpot[],
  labels: readonly SpotLabel[],
  palette: Palette,
): void {
  const windowPx = Math.max(LEAST_WINDOW_PX, WINDOW_MM * scale * view.pxPerMm);
  const spotRadius = Math.max(LEAST_SPOT_PX, SPOT_MM * scale * view.pxPerMm);
  const places = spots.map((spot) => ({ ...spot, at: spotPx(view, pose, scale, spot.atMm) }));
  context.save();
  context.globalCompositeOperation = 'destination-out';
  for (const { at } of places) disc(context, at, windowPx, '#000');
  context.restore();
  context.lineWidth = 1.5;
  context.strokeStyle = palette.pill;
  for (const { at } of places) ring(context, at, windowPx);
  for (const { at, bright } of places) {
    disc(context, at, spotRadius + 2.2, bright ? palette.pill : '#ffffff');
    disc(context, at, spotRadius, bright ? '#8fd0ff' : '#17191c');
  }
  for (const label of labels) drawLeader(context, label, spotRadius + 2.2, palette);
  for (const label of labels) drawLabel(context, label, palette);
}

/** The thin line from a spot to its reading, light-edged so that it is seen on the robot and on a black line. */
function drawLeader(
  context: CanvasRenderingContext2D,
  { from, at }: SpotLabel,
  radiusPx: number,
  palette: Palette,
): void {
  const length = Math.hypot(at.x - from.x, at.y - from.y);
  if (length <= radiusPx) return;
  const part = radiusPx / length;
  for (const [width, color] of [
    [3.5, '#ffffff'],
    [1.25, palette.pill],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = color;
    context.beginPath();
    context.moveTo(from.x + (at.x - from.x) * part, from.y + (at.y - from.y) * part);
    context.lineTo(at.x, at.y);
    context.stroke();
  }
}

function drawLabel(context: CanvasRenderingContext2D, { at, width, text, bright }: SpotLabel, palette: Palette): void {
  context.strokeStyle = palette.pill;
  context.fillStyle = bright ? '#ffffff' : palette.pill;
  context.lineWidth = 1.5;
  context.beginPath();
  context.roundRect(at.x - width / 2, at.y - LABEL.height / 2, width, LABEL.height, 5);
  context.fill();
  context.stroke();
  context.font = `600 12px ${canvasFont}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillStyle = bright ? palette.pill : palette.pillText;
  context.fillText(text, at.x, at.y + 1);
}

function spotPx(view: View, pose: Pose, scale: number, atMm: Vec): Vec {
  const [sin, cos] = [Math.sin(pose.headingRad) * scale, Math.cos(pose.headingRad) * scale];
  return toPx(view, { x: pose.xMm + cos * atMm.x - sin * atMm.y, y: pose.yMm + sin * atMm.x + cos * atMm.y });
}

function disc(context: CanvasRenderingContext2D, at: Vec, radius: number, color: string): void {
  context.fillStyle = color;
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.fill();
}

function ring(context: CanvasRenderingContext2D, at: Vec, radius: number): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.stroke();
}
