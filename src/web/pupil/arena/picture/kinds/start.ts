import { robotColors, type Start } from '#scene/scene';
import { START_SIDE_MM } from '#scene/kinds/start';
import { canvasFont, type Palette } from '../../model/palette';
import { deviceColor } from '../../model/device-colors';
import { toPx, type View } from '../../view/view-transform';

/** Draws a start: a dashed box with an arrow ahead and the robot's name behind. */
export function drawStart(context: CanvasRenderingContext2D, view: View, start: Start, palette: Palette): void {
  const at = toPx(view, { x: start.at[0], y: start.at[1] });
  const side = START_SIDE_MM * view.pxPerMm;
  const color = start.color === null ? palette.label : deviceColor(robotColors.indexOf(start.color));
  context.save();
  context.translate(at.x, at.y);
  context.rotate((-start.heading * Math.PI) / 180);
  context.strokeStyle = color;
  context.fillStyle = color;
  context.lineWidth = Math.max(1.5, side / 50);
  context.setLineDash([side / 12, side / 20]);
  context.strokeRect(-side / 2, -side / 2, side, side);
  context.beginPath();
  context.moveTo(side * 0.42, 0);
  context.lineTo(side * 0.24, side * 0.14);
  context.lineTo(side * 0.24, -side * 0.14);
  context.closePath();
  context.fill();
  drawName(context, start.name, side);
  context.restore();
}

function drawName(context: CanvasRenderingContext2D, name: string, side: number): void {
  const size = side * 0.16;
  if (name === '' || size < 6) return;
  context.rotate(Math.PI / 2);
  context.font = `600 ${size.toFixed(1)}px ${canvasFont}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(name, 0, side * 0.38, side * 0.9);
}
