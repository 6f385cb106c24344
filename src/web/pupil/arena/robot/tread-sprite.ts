import { createCache } from '../../../kit/drawing/shelf';
import type { Box } from './robot-drawing';
import { emptyCanvas, resolutionStep } from './robot-sprite';

/** Marks of the tread, about as far apart as on the real tyre. */
const MARKS = 24;
const PITCH_RAD = (2 * Math.PI) / MARKS;
/** Number of positions in which the tyre is drawn from one mark to the next: a tenth of a mm apart. */
const POSITIONS = 16;
/** Marks reach this far beyond the tyre, in mm. */
const RIM_MM = 1;
/** Two tyres in all positions at a few zooms. */
const MOST = 120;

/**
 * Turning tyres as pictures: their marks are many short lines, which cost more than all the rest of a robot when they
 * are drawn for every frame.
 */
export class TreadShelf {
  private readonly made = createCache<HTMLCanvasElement>(MOST);

  /**
   * Draws the upper half of a tyre, seen from above, in mm of the drawing.
   *
   * @param turnRad how far the wheel has turned: rolling forward, its top moves to the front (up in the drawing)
   * @param pixelsPerMm pixels of the canvas per mm of the drawing
   */
  draw(context: CanvasRenderingContext2D, tyre: Box, turnRad: number, pixelsPerMm: number): void {
    const share = turnRad / PITCH_RAD;
    const position = Math.floor((share - Math.floor(share)) * POSITIONS);
    const [width, height] = [tyre.width + 2 * RIM_MM, tyre.height + 2 * RIM_MM];
    context.drawImage(this.at(tyre, position, pixelsPerMm), tyre.x - RIM_MM, tyre.y - RIM_MM, width, height);
  }

  private at(tyre: Box, position: number, pixelsPerMm: number): HTMLCanvasElement {
    const step = resolutionStep(pixelsPerMm);
    return this.made([tyre.width, tyre.height, position, step], () =>
      painted(tyre, (position / POSITIONS) * PITCH_RAD, Math.SQRT2 ** step),
    );
  }
}

function painted({ width, height }: Box, firstRad: number, pixelsPerMm: number): HTMLCanvasElement {
  const pixels = (mm: number): number => Math.ceil(mm * pixelsPerMm);
  const canvas = emptyCanvas(pixels(width + 2 * RIM_MM), pixels(height + 2 * RIM_MM));
  const context = canvas.getContext('2d');
  if (context === null) return canvas;
  context.scale(canvas.width / (width + 2 * RIM_MM), canvas.height / (height + 2 * RIM_MM));
  drawTread(context, { x: RIM_MM, y: RIM_MM, width, height }, firstRad);
  return canvas;
}

/** Marks crowd and fade where the tyre bends down. */
function drawTread(context: CanvasRenderingContext2D, tyre: Box, firstRad: number): void {
  const radius = tyre.height / 2;
  const middle = { x: tyre.x + tyre.width / 2, y: tyre.y + radius };
  const half = tyre.width * 0.4;
  context.strokeStyle = '#68727c';
  context.lineJoin = 'round';
  for (let mark = 0; mark < MARKS / 2; mark += 1) {
    const angle = -Math.PI / 2 + firstRad + mark * PITCH_RAD;
    const facing = Math.cos(angle);
    if (facing < 0.12) continue;
    const y = middle.y - radius * 0.985 * Math.sin(angle);
    context.globalAlpha = 0.25 + 0.65 * facing;
    context.lineWidth = 0.35 + 0.85 * facing;
    context.beginPath();
    context.moveTo(middle.x - half, y + 0.8 * facing);
    context.lineTo(middle.x, y - 0.9 * facing);
    context.lineTo(middle.x + half, y + 0.8 * facing);
    context.stroke();
  }
}
