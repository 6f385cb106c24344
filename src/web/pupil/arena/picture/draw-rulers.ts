import { floorPx, sightPx } from './draw-floor';
import { canvasFont, type Palette } from '../model/palette';
import type { ArenaSize, CanvasSize, View } from '../view/view-transform';

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

/** A number beside a ruler: `at` is the middle of its place along the ruler, in px. */
export interface RulerLabel {
  readonly text: string;
  readonly at: number;
}

/** Room that stays free between two numbers, in px. */
const GAP_PX = 6;

/**
 * The visible numbers of a ruler between `from` and `to` (px along it), in the order of the ticks. The last one carries
 * the unit. Numbers are pushed in from the ends rather than cut off, and what would then touch is left out.
 */
export function rulerLabels(
  ticks: readonly Tick[],
  place: (mm: number) => number,
  range: { readonly from: number; readonly to: number },
  measure: (text: string) => number,
): readonly RulerLabel[] {
  const inSight = ticks.filter(({ mm, label }) => label !== null && place(mm) >= range.from && place(mm) <= range.to);
  const labels: RulerLabel[] = [];
  let taken = { from: Infinity, to: -Infinity };
  // The last one first: it carries the unit, so it is the one that stays.
  for (const { mm, label } of [...inSight].reverse()) {
    const text = labels.length === 0 ? `${label ?? ''} cm` : (label ?? '');
    const half = measure(text) / 2;
    const at = Math.min(range.to - half, Math.max(range.from + half, place(mm)));
    const isFree = at + half + GAP_PX <= taken.from || at - half - GAP_PX >= taken.to;
    if (labels.length > 0 && !isFree) continue;
    taken = { from: Math.min(taken.from, at - half), to: Math.max(taken.to, at + half) };
    labels.unshift({ text, at });
  }
  return labels;
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
  drawAcross(context, view, arena, canvas, { left, bottom });
  drawUp(context, view, arena, { left, bottom });
  context.stroke();
}

/** Place of the rulers, in px: the one below under `bottom`, the one beside left of `left`. */
interface RulerCorner {
  readonly left: number;
  readonly bottom: number;
}

function drawAcross(
  context: CanvasRenderingContext2D,
  view: View,
  arena: ArenaSize,
  canvas: CanvasSize,
  { left, bottom }: RulerCorner,
): void {
  const ticks = rulerTicks(arena[0], view.pxPerMm);
  const place = (mm: number): number => view.leftPx + mm * view.pxPerMm;
  for (const { mm, label } of ticks) {
    const x = place(mm);
    if (x < left - 1 || x > canvas.widthPx) continue;
    context.moveTo(x, bottom + 2);
    context.lineTo(x, bottom + (label === null ? 6 : 9));
  }
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  // A number may stand out to the left of the floor, as the 0 does.
  const range = { from: Math.max(3, left - 12), to: canvas.widthPx - 3 };
  for (const { text, at } of rulerLabels(ticks, place, range, (text) => context.measureText(text).width))
    context.fillText(text, at, bottom + 22);
}

function drawUp(context: CanvasRenderingContext2D, view: View, arena: ArenaSize, { left, bottom }: RulerCorner): void {
  const ticks = rulerTicks(arena[1], view.pxPerMm).map((tick) => (tick.mm === 0 ? { ...tick, label: null } : tick));
  const texts = ticks.flatMap(({ label }) => label ?? []);
  const longest = Math.max(0, ...texts.map((text) => context.measureText(text).width));
  const isUpright = longest > left - 13; // no room across: the numbers run along the ruler
  context.textAlign = isUpright ? 'center' : 'right';
  for (const { mm, label } of ticks) {
    const y = view.bottomPx - mm * view.pxPerMm;
    if (y > bottom + 1 || y < 0) continue;
    context.moveTo(left - 2, y);
    context.lineTo(left - (label === null ? 6 : 9), y);
    if (label === null) continue;
    if (!isUpright) context.fillText(label, left - 12, Math.max(10, y + 4));
    else {
      context.save();
      context.translate(left - 12, Math.max(context.measureText(label).width / 2 + 2, y));
      context.rotate(-Math.PI / 2);
      context.fillText(label, 0, 0);
      context.restore();
    }
  }
}
