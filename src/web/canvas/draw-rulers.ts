import { floorPx, sightPx } from './draw-floor';
import { canvasFont, type Palette } from './palette';
import type { ArenaSize, CanvasSize, View } from './view-transform';

/** One mark of a ruler. */
export interface Tick {
  readonly mm: number;
  /** In cm, or `null` for a short mark without a number. */
  readonly label: string | null;
}

/** Distances numbers may have, in mm. */
const LABEL_STEPS_MM = [10, 50, 100, 200, 500, 1000, 2000, 5000];

/** Room a number needs, in px. */
const LABEL_PX = 42;

/** The marks of a ruler of this length: numbers at least 42 px apart, marks at halves or fifths between them. */
export function rulerTicks(lengthMm: number, pxPerMm: number): readonly Tick[] {
  const labelMm = LABEL_STEPS_MM.find((step) => step * pxPerMm >= LABEL_PX) ?? 5000;
  const markMm = labelMm % 50 === 0 && labelMm !== 200 && (labelMm / 5) * pxPerMm >= 14 ? labelMm / 5 : labelMm / 2;
  const ticks: Tick[] = [];
  for (let i = 0; i * markMm <= lengthMm; i += 1) {
    const mm = i * markMm;
    ticks.push({ mm, label: mm % labelMm === 0 ? String(mm / 10) : null });
  }
  return ticks;
}

/**
 * Draws the rulers in cm below and to the left of the floor. Where the floor's edge is out of sight, they stay at the
 * edge of the canvas.
 */
export function drawRulers(
  context: CanvasRenderingContext2D,
  view: View,
  arena: ArenaSize,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const floor = floorPx(view, arena);
  const sight = sightPx(view, arena, canvas);
  const bottom = Math.min(floor.top + floor.height, sight.height);
  const left = Math.max(floor.left, sight.left);
  context.fillStyle = palette.canvas; // ground for rulers that lie over the floor
  context.fillRect(0, sight.height, canvas.widthPx, canvas.heightPx - sight.height);
  context.fillRect(0, 0, sight.left, canvas.heightPx);
  context.font = `500 12px ${canvasFont}`;
  context.fillStyle = palette.rulerText;
  context.strokeStyle = palette.rulerTick;
  context.lineWidth = 1.25;
  context.beginPath();
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  const across = rulerTicks(arena[0], view.pxPerMm);
  const lastLabel = across.findLast((tick) => tick.label !== null);
  for (const tick of across) {
    const x = floor.left + tick.mm * view.pxPerMm;
    if (x < left - 1 || x > canvas.widthPx) continue;
    context.moveTo(x, bottom + 2);
    context.lineTo(x, bottom + (tick.label === null ? 6 : 9));
    if (tick.label === null) continue;
    const unit = tick === lastLabel ? ' cm' : '';
    const half = context.measureText(tick.label + unit).width / 2;
    context.fillText(tick.label + unit, Math.min(x, canvas.widthPx - half - 3), bottom + 22);
  }
  context.textAlign = 'right';
  for (const tick of rulerTicks(arena[1], view.pxPerMm)) {
    const y = view.bottomPx - tick.mm * view.pxPerMm;
    if (y > bottom + 1 || y < 0) continue;
    context.moveTo(left - 2, y);
    context.lineTo(left - (tick.label === null ? 6 : 9), y);
    if (tick.label !== null && tick.mm > 0) context.fillText(tick.label, left - 12, Math.max(10, y + 4));
  }
  context.stroke();
}
