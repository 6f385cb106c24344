import type { Point } from '#scene/scene';

import type { LabRun } from './model/lab-model';

/** Dark enough for the floor, which is light in every theme. */
const [PASSED, MISSED, FREE, CHOSEN] = ['#1b7a3a', '#c3262b', '#1459b3', '#1e66d0'] as const;

/** The canvas on which ways are drawn. */
export interface Sheet {
  readonly context: CanvasRenderingContext2D;
  /** Height of the course in mm. */
  readonly highMm: number;
  /** Canvas pixels for a mm, and for a px of the page. */
  readonly scale: number;
  readonly ratio: number;
}

function path({ context, highMm, scale }: Sheet, way: readonly (readonly Point[])[]): void {
  context.beginPath();
  for (const piece of way)
    for (const [place, [x, y]] of piece.entries()) {
      if (place === 0) context.moveTo(x * scale, (highMm - y) * scale);
      else context.lineTo(x * scale, (highMm - y) * scale);
    }
  context.stroke();
}

/** Adds the thin ways of runs to a picture: failed ones lighter than passed ones. */
export function addWays(sheet: Sheet, runs: readonly LabRun[]): void {
  const { context, ratio } = sheet;
  context.lineJoin = 'round';
  context.lineWidth = 1.5 * ratio;
  for (const { drive, passed } of runs) {
    if (drive === null) continue;
    context.strokeStyle = passed === null ? FREE : passed ? PASSED : MISSED;
    context.globalAlpha = passed === false ? 0.35 : 0.6;
    path(sheet, drive.way);
  }
  context.globalAlpha = 1;
}

/** Draws the way that is looked at, on white. */
export function drawChosen(sheet: Sheet, { drive }: LabRun): void {
  const { context, ratio } = sheet;
  if (drive === null) return;
  context.lineJoin = context.lineCap = 'round';
  for (const [color, px] of [
    ['#ffffff', 8],
    [CHOSEN, 4],
  ] as const) {
    // prettier-ignore
    context.strokeStyle = color;
    context.lineWidth = px * ratio;
    path(sheet, drive.way);
  }
}
