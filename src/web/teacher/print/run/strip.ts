import { canvasFont, lightPalette } from '../../../pupil/arena/model/palette';
import { emptyCanvas } from '../../../pupil/arena/robot/robot-sprite';
import type { RunPainter } from './run-painter';
import { stripForm } from './stretch';

/** The text below a picture of a strip. */
export interface Caption {
  readonly time: string;
  /** The number of the line that the program is at, and the line; `null`: no program runs. */
  readonly line: { readonly number: number; readonly text: string } | null;
}

/** Lengths in parts of a picture's width. */
const GAP = 0.03;
const TIME = 0.052;
const LINE = 0.046;
const CAPTION = 0.15;
const RIM = 0.004;

const MONO = '"Roboto Mono", "DejaVu Sans Mono", "Liberation Mono", Consolas, monospace';

/** A canvas with room for all pictures of a strip, white. */
export function emptyStrip({ widthPx, heightPx }: RunPainter, count: number): HTMLCanvasElement {
  const { columns, rows } = stripForm(count);
  const gap = GAP * widthPx;
  const canvas = emptyCanvas(
    Math.round(columns * widthPx + (columns + 1) * gap),
    Math.round(rows * (heightPx + CAPTION * widthPx) + (rows + 1) * gap),
  );
  const context = canvas.getContext('2d');
  if (context !== null) context.fillStyle = '#ffffff';
  context?.fillRect(0, 0, canvas.width, canvas.height);
  return canvas;
}

/** Puts a picture into the strip, at its place, with its time and its line below. */
export function putPicture(
  strip: HTMLCanvasElement,
  picture: HTMLCanvasElement,
  at: { readonly place: number; readonly count: number },
  { time, line }: Caption,
): void {
  const context = strip.getContext('2d');
  if (context === null) return;
  const { columns } = stripForm(at.count);
  const [width, height] = [picture.width, picture.height];
  const gap = GAP * width;
  const left = gap + (at.place % columns) * (width + gap);
  const top = gap + Math.floor(at.place / columns) * (height + CAPTION * width + gap);
  context.clearRect(left, top, width, height + CAPTION * width);
  context.fillStyle = '#ffffff';
  context.fillRect(left, top, width, height + CAPTION * width);
  context.drawImage(picture, left, top);
  context.strokeStyle = lightPalette.floorEdge;
  context.lineWidth = Math.max(1, RIM * width);
  context.strokeRect(left, top, width, height);
  context.textBaseline = 'alphabetic';
  context.fillStyle = '#000000';
  context.font = `700 ${String(TIME * width)}px ${canvasFont}`;
  context.fillText(time, left, top + height + 0.06 * width);
  if (line === null) return;
  const base = top + height + 0.125 * width;
  context.font = `400 ${String(LINE * width)}px ${MONO}`;
  const number = `${String(line.number)}  `;
  context.fillStyle = '#b24700';
  context.fillText(number, left, base);
  const indent = context.measureText(number).width;
  context.fillStyle = '#000000';
  context.fillText(shortened(context, line.text, width - indent), left + indent, base);
}

/** As much of a text as there is room for. */
function shortened(context: CanvasRenderingContext2D, text: string, roomPx: number): string {
  if (context.measureText(text).width <= roomPx) return text;
  const signs = Array.from(text);
  while (signs.length > 0 && context.measureText(`${signs.join('')}…`).width > roomPx) signs.pop();
  return `${signs.join('')}…`;
}
