import type { Vec } from '#core/geometry';
import type { Mark } from '#editor/tools/tool';
import type { MarkFrame } from './mark-frame';
import { drawPill } from '../picture/draw-pill';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type CanvasSize, type View } from '../view/view-transform';
import { cmText } from './reading-text';

type Guide = Extract<Mark, { type: 'guide' }>;
type Distance = Extract<Mark, { type: 'distance' }>;

/** Draws a guide line dashed, with its ends a little beyond the things. */
export function drawGuide(context: CanvasRenderingContext2D, { view, palette }: MarkFrame, guide: Guide): void {
  const [from, to] = [toPx(view, guide.from), toPx(view, guide.to)];
  const beyond = BEYOND_PX / Math.max(1, Math.hypot(to.x - from.x, to.y - from.y));
  const [dx, dy] = [(to.x - from.x) * beyond, (to.y - from.y) * beyond];
  context.lineCap = 'butt';
  line(context, { x: from.x - dx, y: from.y - dy }, { x: to.x + dx, y: to.y + dy });
  stroked(context, CASING, 3.5);
  context.setLineDash([6, 4]);
  stroked(context, palette.guide, 1.5);
}

const BEYOND_PX = 10;

/** Makes lines visible on any ground. */
const CASING = 'rgba(255, 255, 255, 0.85)';

/** Draws how far two things are apart: a line with bars at its ends, and the figure. */
export function drawDistance(context: CanvasRenderingContext2D, frame: MarkFrame, distance: Distance): void {
  const { view, canvas, palette } = frame;
  const [from, to] = [toPx(view, distance.from), toPx(view, distance.to)];
  const isLevel = from.y === to.y;
  const bar = isLevel ? { x: 0, y: BAR_PX } : { x: BAR_PX, y: 0 };
  context.lineCap = 'round';
  line(context, from, to);
  for (const end of [from, to]) {
    context.moveTo(end.x - bar.x, end.y - bar.y);
    context.lineTo(end.x + bar.x, end.y + bar.y);
  }
  stroked(context, CASING, 4);
  stroked(context, palette.guide, distance.equal ? 2.25 : 1.25);
  const mm = Math.abs(distance.to.x - distance.from.x) + Math.abs(distance.to.y - distance.from.y);
  drawPill(context, cmText(mm), figurePlace(from, to), canvas, palette, {
    ground: palette.guide,
    height: 18,
    fontPx: 11,
  });
}

/** Half of the bar at the end of a distance. */
const BAR_PX = 5;

/** Room for a figure on its line: in a narrower gap it is placed beside it. */
const FIGURE_PX = 48;

/** The middle of a gap, or beside it where the figure would hide it. */
function figurePlace(from: Vec, to: Vec): Vec {
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  if (Math.abs(to.x - from.x) + Math.abs(to.y - from.y) >= FIGURE_PX) return middle;
  return from.y === to.y ? { x: middle.x, y: middle.y + 18 } : { x: middle.x + 26, y: middle.y };
}

/** Area of a guide or a distance, in CSS px. */
export function guideBox(view: View, { type, from, to }: Guide | Distance): PxBox {
  const ends = [toPx(view, from), toPx(view, to)] as const;
  const rim = type === 'guide' ? BEYOND_PX + 4 : BAR_PX + 4;
  const boxes = ends.map((at) => boxAround(at, rim));
  return unionOf(type === 'guide' ? boxes : [...boxes, boxAround(figurePlace(...ends), FIGURE_PX / 2 + 4)]);
}

/** Half of the longest reading, in px. */
const READING_PX = 110;

/** A finger hides this much above and beside it, in px. */
const FINGER = { abovePx: 66, besidePx: 150 };

/**
 * Place of a gesture's figures: above the pointer, clear of a finger; if there is no room above, below a mouse, and
 * beside a finger.
 */
export function readingPlace(pointer: Vec, isFinger: boolean, { widthPx }: CanvasSize): Vec {
  if (!isFinger) return { x: pointer.x, y: pointer.y + (pointer.y > 56 ? -34 : 34) };
  if (pointer.y > FINGER.abovePx + 16) return { x: pointer.x, y: pointer.y - FINGER.abovePx };
  const isRoomLeft = pointer.x > FINGER.besidePx + READING_PX || pointer.x > widthPx / 2;
  return { x: pointer.x + (isRoomLeft ? -FINGER.besidePx : FINGER.besidePx), y: pointer.y };
}

/** Place of a hint: beside the crosshair of the keyboard, below it and below a reading there; CSS px. */
export const hintPlace = (crosshair: Vec): Vec => ({ x: crosshair.x, y: crosshair.y + (crosshair.y > 56 ? 38 : 66) });

/** Area of a reading, in CSS px. */
export const readingBox = (at: Vec): PxBox => boxAround(at, 2 * READING_PX);

function line(context: CanvasRenderingContext2D, from: Vec, to: Vec): void {
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(to.x, to.y);
}

function stroked(context: CanvasRenderingContext2D, color: string, width: number): void {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}
