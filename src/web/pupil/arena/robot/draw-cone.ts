import type { Vec } from '#core/geometry';
import type { UltrasonicState } from '#robots/robot';
import { drawPill } from '../picture/draw-pill';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { toPx, type CanvasSize, type View } from '../view/view-transform';

/** Length of the fan when nothing is in range, in mm; it fades out there. */
const OPEN_REACH_MM = 450;

/** Distance over which the fan fades out behind an obstacle, in mm. */
const BEYOND_MM = 130;

/** Arcs follow each other at this distance, in mm. */
const ARC_STEP_MM = 28;

/** One breath of the arcs in µs of simulated time. */
const BREATH_US = 1_600_000;

/** The measured distance in whole cm. */
export function distanceLabel(distanceMm: number): string {
  return `${String(Math.round(distanceMm / 10))} cm`;
}

/** Place of the label: beside the cone's axis at the hit point, on the side that is higher on the screen. */
export function labelPlace(hitPx: Vec, headingRad: number): Vec {
  const side = { x: Math.sin(headingRad), y: Math.cos(headingRad) }; // right of the axis, y down
  const up = side.y <= 0 ? 1 : -1;
  return { x: hitPx.x + side.x * up * 34, y: hitPx.y + side.y * up * 30 };
}

/** The area of the fan, in CSS px. */
export function coneBox(cone: UltrasonicState, view: View): PxBox {
  const from = toPx(view, cone.fromMm);
  const radius = fanMm(cone) * view.pxPerMm;
  const directions = [-0.5, -0.25, 0, 0.25, 0.5].map((share) => cone.headingRad + share * cone.openingRad);
  const rim = directions.map((rad) => ({ x: from.x + radius * Math.cos(rad), y: from.y - radius * Math.sin(rad) }));
  const sag = radius * (1 - Math.cos(cone.openingRad / 8)) + 4; // how far the rim bulges out between these points
  return unionOf([from, ...rim].map((point) => boxAround(point, sag)));
}

/** Length of the fan, in mm. */
function fanMm(cone: UltrasonicState): number {
  return cone.distanceMm === null ? OPEN_REACH_MM : cone.distanceMm + BEYOND_MM;
}

/**
 * Draws the ultrasonic fan with its arcs.
 *
 * @param breathUs simulated time, which moves the arcs, or `null` to freeze them
 */
export function drawCone(
  context: CanvasRenderingContext2D,
  view: View,
  cone: UltrasonicState,
  breathUs: number | null,
  palette: Palette,
): void {
  const from = toPx(view, cone.fromMm);
  const reachMm = cone.distanceMm ?? OPEN_REACH_MM;
  const axis = -cone.headingRad;
  const half = cone.openingRad / 2;
  const fan = (radiusPx: number): void => {
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.arc(from.x, from.y, radiusPx, axis - half, axis + half);
    context.closePath();
    context.fill();
  };
  const beyond = fanMm(cone) * view.pxPerMm;
  // Two colours: with a third one the fan alone would cost more than all the rest of the picture.
  const fade = context.createRadialGradient(from.x, from.y, 0, from.x, from.y, beyond);
  fade.addColorStop(0, withAlpha(palette.cone, 0.3));
  fade.addColorStop(1, withAlpha(palette.cone, 0));
  context.fillStyle = fade;
  fan(beyond);
  if (cone.distanceMm !== null) {
    context.fillStyle = withAlpha(palette.cone, 0.13);
    fan(reachMm * view.pxPerMm);
  }
  drawArcs(context, view, cone, Math.min(reachMm, OPEN_REACH_MM), breathUs, palette);
}

function drawArcs(
  context: CanvasRenderingContext2D,
  view: View,
  cone: UltrasonicState,
  reachMm: number,
  breathUs: number | null,
  palette: Palette,
): void {
  const from = toPx(view, cone.fromMm);
  const step = Math.max(ARC_STEP_MM, 14 / view.pxPerMm);
  context.strokeStyle = palette.cone;
  context.lineCap = 'round';
  context.lineWidth = Math.min(3, Math.max(1.4, 2.2 * view.pxPerMm));
  for (let mm = step; mm < reachMm - step * 0.3; mm += step) {
    const phase = breathUs === null ? 0.5 : (((breathUs / BREATH_US - mm / 170) % 1) + 1) % 1;
    const breath = breathUs === null ? 0.8 : 0.25 + 0.75 * Math.sin(Math.PI * phase);
    context.globalAlpha = breath * (1 - (0.75 * mm) / Math.max(reachMm, 250));
    context.beginPath();
    context.arc(
      from.x,
      from.y,
      mm * view.pxPerMm,
      -cone.headingRad - cone.openingRad * 0.38,
      -cone.headingRad + cone.openingRad * 0.38,
    );
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineCap = 'butt';
}

/** Draws the point of the sensor's nearest echo, and its distance. Nothing when nothing is in range. */
export function drawHit(
  context: CanvasRenderingContext2D,
  view: View,
  cone: UltrasonicState,
  canvas: CanvasSize,
  palette: Palette,
): void {
  if (cone.hitMm === null || cone.distanceMm === null) return;
  const hit = toPx(view, cone.hitMm);
  context.fillStyle = '#ffffff';
  context.strokeStyle = palette.cone;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(hit.x, hit.y, 5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  drawPill(context, distanceLabel(cone.distanceMm), labelPlace(hit, cone.headingRad), canvas, palette);
}

/** A colour `#rrggbb` with an alpha of 0 … 1. */
export function withAlpha(color: string, alpha: number): string {
  return `${color}${Math.round(alpha * 255)
    .toString(16)
    .padStart(2, '0')}`;
}
