import type { Vec } from '#core/geometry';
import { canvasFont, type Palette } from '../model/palette';
import type { CanvasSize } from '../view/view-transform';

const HEIGHT = 24;

/** Room for letters beside the middle of the text, in px. */
const SIDE = 11;

/** Draws a short text on a dark pill, centred at a place in CSS px and kept on the canvas. */
export function drawPill(
  context: CanvasRenderingContext2D,
  text: string,
  at: Vec,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const { bitmap, width } = pillOf(text, palette, context.getTransform().a);
  const x = Math.min(Math.max(at.x, width / 2 + 4), canvas.widthPx - width / 2 - 4);
  const y = Math.min(Math.max(at.y, HEIGHT / 2 + 4), canvas.heightPx - HEIGHT / 2 - 4);
  context.drawImage(bitmap, x - width / 2, y - HEIGHT / 2, width, HEIGHT);
}

interface Pill {
  readonly bitmap: HTMLCanvasElement;
  /** CSS px. */
  readonly width: number;
}

/** So many are kept. Chosen: a robot on its rounds shows that many distances, each of them again and again; 1 MB at most. */
const MOST = 120;

const made = new Map<string, Pill>();

/**
 * A pill, painted once: words on a canvas of the page make the browser lay out styles in the middle of a frame, and this
 * one is not on the page (measured: a sixth of the script's time while driving).
 */
function pillOf(text: string, palette: Palette, ratio: number): Pill {
  const key = [ratio, palette.pill, palette.pillText, text].join();
  const known = made.get(key);
  if (known !== undefined) return known;
  if (made.size >= MOST) made.clear();
  const pill = painted(text, palette, ratio);
  made.set(key, pill);
  return pill;
}

const FONT = `600 13px ${canvasFont}`;

/** Only measures. */
let ruler: CanvasRenderingContext2D | null = null;

function widthOf(text: string): number {
  ruler ??= document.createElement('canvas').getContext('2d');
  if (ruler === null) return 0;
  ruler.font = FONT;
  return Math.ceil(ruler.measureText(text).width) + 2 * SIDE;
}

function painted(text: string, palette: Palette, ratio: number): Pill {
  const width = widthOf(text);
  const bitmap = document.createElement('canvas');
  bitmap.width = Math.ceil(width * ratio); // before there is a context: a canvas that changes its size is made twice
  bitmap.height = Math.ceil(HEIGHT * ratio);
  const context = bitmap.getContext('2d');
  if (context === null) return { bitmap, width };
  context.scale(bitmap.width / width, bitmap.height / HEIGHT);
  context.fillStyle = palette.pill;
  context.beginPath();
  context.roundRect(0, 0, width, HEIGHT, HEIGHT / 2);
  context.fill();
  context.font = FONT;
  context.fillStyle = palette.pillText;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, width / 2, HEIGHT / 2 + 1);
  return { bitmap, width };
}
