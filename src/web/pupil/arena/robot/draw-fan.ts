import type { Vec } from '#core/geometry';
import { alongRay, fanOf } from '#robots/lidar-fan';
import type { LidarState } from '#robots/robot';
import type { Palette } from '../model/palette';
import { drawPill, type PillLook } from '../picture/draw-pill';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type CanvasSize, type View } from '../view/view-transform';
import { withAlpha } from './draw-cone';
import { fanLabels, LABEL_PX, type FanEnd, type FanLabel } from './fan-labels';

/** Length of a ray that meets nothing, in mm of depth. */
const OPEN_REACH_MM = 450;

/** Radius of the point at the end of a ray, in px. */
const POINT_PX = 4;

/** The fan of a lidar as it lies on the canvas, in CSS px. */
export interface PlacedFan {
  readonly from: Vec;
  /** From left to right. */
  readonly rays: readonly { readonly to: Vec; readonly isHit: boolean }[];
  readonly labels: readonly FanLabel[];
  /** The point of the label with the unit; `null`: nothing in range. */
  readonly nearest: Vec | null;
}

/** Places the rays at eye level, and their numbers within `sight`. */
export function placeFan(lidar: LidarState, view: View, sight: PxBox): PlacedFan {
  const from = toPx(view, lidar.fromMm);
  const ends: FanEnd[] = [];
  const rays = fanOf(lidar).map((ray) => {
    const to = toPx(view, alongRay(lidar, ray, ray.depthMm ?? OPEN_REACH_MM));
    if (ray.depthMm !== null) {
      const length = Math.hypot(ray.perMm.x, ray.perMm.y);
      ends.push({ at: to, along: { x: ray.perMm.x / length, y: -ray.perMm.y / length }, depthMm: ray.depthMm });
    }
    return { to, isHit: ray.depthMm !== null };
  });
  const labels = fanLabels(ends, sight);
  const nearest = ends.reduce<FanEnd | null>((best, end) => (best !== null && best.depthMm <= end.depthMm ? best : end), null); // prettier-ignore
  return { from, rays, labels, nearest: nearest?.at ?? null };
}

/** The areas of a fan and its numbers, in CSS px. */
export const fanBoxes = ({ from, rays, labels }: PlacedFan): readonly PxBox[] => [
  unionOf([boxAround(from, POINT_PX + 2), ...rays.map(({ to }) => boxAround(to, POINT_PX + 2))]),
  ...labels.map(({ at, box }) => boxAround(at, Math.max(box.width, box.height) / 2 + 4)),
];

/** Draws the field of a fan and its rays, those that meet something stronger; under the robot. */
export function drawFan(context: CanvasRenderingContext2D, { from, rays }: PlacedFan, palette: Palette): void {
  context.fillStyle = withAlpha(palette.cone, 0.13);
  context.beginPath();
  context.moveTo(from.x, from.y);
  for (const { to } of rays) context.lineTo(to.x, to.y);
  context.fill();
  context.strokeStyle = palette.cone;
  context.lineWidth = 1.8;
  for (const strong of [false, true]) {
    context.globalAlpha = strong ? 0.85 : 0.3;
    context.beginPath();
    for (const { to, isHit } of rays) {
      if (isHit !== strong) continue;
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** Draws the points that the rays meet, and their numbers; over the robot. */
export function drawFanHits(
  context: CanvasRenderingContext2D,
  { rays, labels }: PlacedFan,
  canvas: CanvasSize,
  palette: Palette,
): void {
  context.fillStyle = '#ffffff';
  context.strokeStyle = palette.cone;
  context.lineWidth = 2.4;
  context.beginPath();
  for (const { to, isHit } of rays) {
    if (!isHit) continue;
    context.moveTo(to.x + POINT_PX, to.y);
    context.arc(to.x, to.y, POINT_PX, 0, 2 * Math.PI);
  }
  context.fill();
  context.stroke();
  const other: PillLook = { ground: '#ffffff', ink: palette.pill, edge: palette.cone, height: LABEL_PX.other, fontPx: 12.5 }; // prettier-ignore
  const nearest: PillLook = { ground: palette.pill, height: LABEL_PX.nearest, fontPx: 13 };
  for (const { text, at, isNearest } of labels)
    drawPill(context, text, at, canvas, palette, isNearest ? nearest : other);
}
