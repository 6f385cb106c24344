import type { Pose, Vec } from '#core/geometry';
import { canvasFont, type Palette } from './palette';
import { boxAround, type PxBox } from './moving-window';
import { toPx, type View } from './view-transform';

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

/** Smallest radii on the screen, in px: else nothing is to be seen of them in a large arena. */
const LEAST_WINDOW_PX = 5;
const LEAST_SPOT_PX = 3;

/** Size of a reading's label, and its distance from the front of the robot, in px. */
const LABEL = { perDigit: 7, rim: 8, height: 19, gap: 3, ahead: 20 };

/** A reading beside its sensor, px. */
export interface SpotLabel {
  readonly from: Vec;
  readonly at: Vec;
  readonly width: number;
  readonly text: string;
  readonly bright: boolean;
}

/**
 * Places the readings in a row ahead of the robot, in the order of the sensors from left to right and far enough from
 * each other to be read.
 *
 * @param frontMm how far ahead of the axle the robot ends, at its size
 * @param scale size of the robot compared with the real one
 */
export function spotLabels(
  view: View,
  pose: Pose,
  scale: number,
  frontMm: number,
  spots: readonly SensorSpot[],
): SpotLabel[] {
  const shown = spots.filter(({ reading }) => reading !== undefined).sort((a, b) => b.atMm.y - a.atMm.y);
  const ahead = { x: Math.cos(pose.headingRad), y: -Math.sin(pose.headingRad) }; // px: y down
  const right = { x: -ahead.y, y: ahead.x };
  const texts = shown.map(({ reading = 0 }) => String(Math.round(reading)));
  const width = LABEL.rim + LABEL.perDigit * Math.max(3, ...texts.map((text) => text.length));
  const step = Math.min(
    (width + LABEL.gap) / Math.max(1e-6, Math.abs(right.x)),
    (LABEL.height + LABEL.gap) / Math.max(1e-6, Math.abs(right.y)),
  );
  const origin = toPx(view, { x: pose.xMm, y: pose.yMm });
  const away = frontMm * view.pxPerMm + LABEL.ahead;
  return shown.map((spot, i) => {
    const aside = (i - (shown.length - 1) / 2) * step;
    return {
      from: spotPx(view, pose, scale, spot.atMm),
      at: { x: origin.x + ahead.x * away + right.x * aside, y: origin.y + ahead.y * away + right.y * aside },
      width,
      text: texts[i] ?? '',
      bright: spot.bright,
    };
  });
}

/** Where the labels and spots are drawn, in px. */
export function spotsBoxes(view: View, pose: Pose, scale: number, spots: readonly SensorSpot[], frontMm: number) {
  const boxes: PxBox[] = spotLabels(view, pose, scale, frontMm, spots).map(({ at, width }) => boxAround(at, width));
  for (const { atMm } of spots)
    boxes.push(boxAround(spotPx(view, pose, scale, atMm), WINDOW_MM * scale * view.pxPerMm + LEAST_WINDOW_PX));
  return boxes;
}

/**
 * Shows the floor under each line sensor through the robot, on it the spot that the sensor sees: light with a dark rim
 * or dark with a light one. Readings stand ahead of the robot.
 *
 * @param context of a canvas above the floor with nothing on it but what moves: holes are cut into that
 */
export function drawSpots(
  context: CanvasRenderingContext2D,
  view: View,
  pose: Pose,
  scale: number,
  spots: readonly SensorSpot[],
  frontMm: number,
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
  for (const label of spotLabels(view, pose, scale, frontMm, spots)) drawLabel(context, label, palette);
}

function drawLabel(
  context: CanvasRenderingContext2D,
  { from, at, width, text, bright }: SpotLabel,
  palette: Palette,
): void {
  context.strokeStyle = palette.pill;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(at.x, at.y);
  context.stroke();
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
