import type { PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { marginsPx, toPx, type ArenaSize, type CanvasSize, type View } from '../view/view-transform';

/** The box of the floor on the canvas. */
export function floorPx(view: View, arena: ArenaSize): PxBox {
  const corner = toPx(view, { x: 0, y: arena[1] });
  return { left: corner.x, top: corner.y, width: arena[0] * view.pxPerMm, height: arena[1] * view.pxPerMm };
}

/** The visible part of the canvas: all of it, except where rulers cover floor that is out of sight. */
export function sightPx(view: View, arena: ArenaSize, canvas: CanvasSize): PxBox {
  const floor = floorPx(view, arena);
  const margin = marginsPx(canvas);
  const ruler = { left: margin.left - 4, bottom: canvas.heightPx - margin.bottom + 4 };
  const left = floor.left < ruler.left - 1 ? ruler.left : 0;
  const bottom = floor.top + floor.height > ruler.bottom + 1 ? ruler.bottom : canvas.heightPx;
  return { left, top: 0, width: canvas.widthPx - left, height: bottom };
}

/** Draws the floor with its shade, and what surrounds it. */
export function drawFloor(
  context: CanvasRenderingContext2D,
  view: View,
  arena: ArenaSize,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const floor = floorPx(view, arena);
  context.fillStyle = palette.canvas;
  context.fillRect(0, 0, canvas.widthPx, canvas.heightPx);
  drawShade(context, floor, palette);
  context.fillStyle = palette.floor;
  fillRoundRect(context, floor, 3);
}

/** How far the floor's shade reaches, in px. */
const SHADE_PX = 13;

/**
 * The soft shade around the floor, as thin lines that fade outward: a canvas shadow of something so large takes a
 * browser without a graphics card as long as all the rest of the arena (measured: 9 of 14 ms a frame while the picture
 * moves).
 */
function drawShade(context: CanvasRenderingContext2D, floor: PxBox, palette: Palette): void {
  const step = 2;
  context.save();
  context.strokeStyle = palette.floorShade;
  context.lineWidth = step;
  for (let far = step / 2; far < SHADE_PX; far += step) {
    context.globalAlpha = (1 - far / SHADE_PX) ** 2;
    context.beginPath();
    context.roundRect(floor.left - far, floor.top - far + 3, floor.width + 2 * far, floor.height + 2 * far, 3 + far);
    context.stroke();
  }
  context.restore();
}

/** The rim of the floor, drawn last so that nothing covers it: the arena ends with a wall. */
export function drawRim(context: CanvasRenderingContext2D, view: View, arena: ArenaSize, palette: Palette): void {
  const floor = floorPx(view, arena);
  context.strokeStyle = palette.floorEdge;
  context.lineWidth = 2;
  context.lineJoin = 'round';
  context.strokeRect(floor.left - 1, floor.top - 1, floor.width + 2, floor.height + 2);
}

/** Distances a grid line may have, in mm: each a round number of cm, or 5 mm under the magnifying glass. */
const GRID_STEPS_MM = [5, 10, 50, 100, 500, 1000, 5000];

/** Distances in mm of the faint, the ordinary and the strong grid lines at this many px per mm. */
export function gridSteps(pxPerMm: number): { fineMm: number; mm: number; strongMm: number } {
  const first = GRID_STEPS_MM.findIndex((step) => step * pxPerMm >= 18); // chosen: closer lines look grey
  const index = first < 0 ? GRID_STEPS_MM.length - 1 : first;
  const step = (i: number): number => GRID_STEPS_MM[Math.min(GRID_STEPS_MM.length - 1, Math.max(0, i))] ?? 1000;
  return { fineMm: step(index - 1), mm: step(index), strongMm: step(index + 2) };
}

/** Draws the grid over the floor and what is printed on it. */
export function drawFloorGrid(
  context: CanvasRenderingContext2D,
  view: View,
  arena: ArenaSize,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const steps = gridSteps(view.pxPerMm);
  const levels: readonly (readonly [number, string])[] = [
    ...(steps.fineMm * view.pxPerMm >= 11 ? [[steps.fineMm, palette.gridFine] as const] : []),
    [steps.mm, palette.grid],
    [steps.strongMm, palette.gridStrong],
  ];
  const floor = floorPx(view, arena);
  context.lineWidth = 1;
  for (const [stepMm, color] of levels) {
    context.strokeStyle = color;
    context.beginPath();
    for (let mm = stepMm; mm < arena[0]; mm += stepMm) {
      const x = Math.round(floor.left + mm * view.pxPerMm) + 0.5;
      if (x < 0 || x > canvas.widthPx) continue;
      context.moveTo(x, floor.top);
      context.lineTo(x, floor.top + floor.height);
    }
    for (let mm = stepMm; mm < arena[1]; mm += stepMm) {
      const y = Math.round(view.bottomPx - mm * view.pxPerMm) + 0.5;
      if (y < 0 || y > canvas.heightPx) continue;
      context.moveTo(floor.left, y);
      context.lineTo(floor.left + floor.width, y);
    }
    context.stroke();
  }
}

function fillRoundRect(context: CanvasRenderingContext2D, box: PxBox, radius: number): void {
  context.beginPath();
  context.roundRect(box.left, box.top, box.width, box.height, radius);
  context.fill();
}
