import type { Vec } from '#core/geometry';
import { canvasFont, type Palette } from './palette';
import type { CanvasSize } from './view-transform';

/** Draws a short text on a dark pill, centred at a place in CSS px and kept on the canvas. */
export function drawPill(
  context: CanvasRenderingContext2D,
  text: string,
  at: Vec,
  canvas: CanvasSize,
  palette: Palette,
): void {
  context.font = `600 13px ${canvasFont}`;
  const width = Math.ceil(context.measureText(text).width) + 22;
  const height = 24;
  const x = Math.min(Math.max(at.x, width / 2 + 4), canvas.widthPx - width / 2 - 4);
  const y = Math.min(Math.max(at.y, height / 2 + 4), canvas.heightPx - height / 2 - 4);
  context.fillStyle = palette.pill;
  context.beginPath();
  context.roundRect(x - width / 2, y - height / 2, width, height, height / 2);
  context.fill();
  context.fillStyle = palette.pillText;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, x, y + 1);
}
