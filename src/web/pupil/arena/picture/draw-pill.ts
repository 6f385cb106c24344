import type { Vec } from '#core/geometry';
import { createCache } from '../../../kit/drawing/shelf';
import { once } from '#core/memo';
import { canvasFont, type Palette } from '../model/palette';
import type { CanvasSize } from '../view/view-transform';

/** How a pill looks; lengths in px. */
export interface PillLook {
  readonly ground: string;
  readonly height: number;
  readonly fontPx: number;
  /** Colour of the text; left out: that of texts on dark pills. */
  readonly ink?: string;
  /** Colour of a thin line around it; left out: none. */
  readonly edge?: string;
}

/** Draws a short text on a pill, dark unless its look is given, centred at a place in CSS px and kept on the canvas. */
export function drawPill(
  context: CanvasRenderingContext2D,
  text: string,
  at: Vec,
  canvas: CanvasSize,
  palette: Palette,
  look: PillLook = { ground: palette.pill, height: 24, fontPx: 13 },
): void {
  const { height } = look;
  const { bitmap, width } = pillOf(text, look, look.ink ?? palette.pillText, context.getTransform().a);
  const x = Math.min(Math.max(at.x, width / 2 + 4), canvas.widthPx - width / 2 - 4);
  const y = Math.min(Math.max(at.y, height / 2 + 4), canvas.heightPx - height / 2 - 4);
  context.drawImage(bitmap, x - width / 2, y - height / 2, width, height);
}

/** Width of the line around a pill that has one, in px. */
const EDGE_PX = 1.4;

interface Pill {
  readonly bitmap: HTMLCanvasElement;
  /** CSS px. */
  readonly width: number;
}

/**
 * Number of cached pills. Chosen: a robot on its rounds shows that many distances, eight of them at once with a lidar, each
 * repeatedly; 1 MB at most, or 4 MB on a fine screen.
 */
const MOST = 300;

const made = createCache<Pill>(MOST);

/**
 * A pill, painted once: words on a canvas of the page make the browser lay out styles in the middle of a frame, and
 * this one is not on the page (measured: a sixth of the script's time while driving).
 */
function pillOf(text: string, look: PillLook, ink: string, ratio: number): Pill {
  return made([ratio, look.ground, look.height, ink, look.edge ?? '', text], () => painted(text, look, ink, ratio));
}

const fontOf = ({ fontPx }: PillLook): string => `600 ${String(fontPx)}px ${canvasFont}`;

/** Only measures. */
const rulerOnce = once(() => document.createElement('canvas').getContext('2d'));

/** Width of a pill in px, with room for its round ends. */
function widthOf(text: string, look: PillLook): number {
  const ruler = rulerOnce();
  if (ruler === null) return 0;
  ruler.font = fontOf(look);
  return Math.ceil(ruler.measureText(text).width) + look.height - 2;
}

function painted(text: string, look: PillLook, ink: string, ratio: number): Pill {
  const width = widthOf(text, look);
  const { height, ground, edge } = look;
  const bitmap = document.createElement('canvas');
  bitmap.width = Math.ceil(width * ratio); // before there is a context: a canvas that changes its size is made twice
  bitmap.height = Math.ceil(height * ratio);
  const context = bitmap.getContext('2d');
  if (context === null) return { bitmap, width };
  context.scale(bitmap.width / width, bitmap.height / height);
  context.fillStyle = ground;
  context.beginPath();
  const rim = edge === undefined ? 0 : EDGE_PX / 2;
  context.roundRect(rim, rim, width - 2 * rim, height - 2 * rim, height / 2 - rim);
  context.fill();
  if (edge !== undefined) {
    context.strokeStyle = edge;
    context.lineWidth = EDGE_PX;
    context.stroke();
  }
  context.font = fontOf(look);
  context.fillStyle = ink;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, width / 2, height / 2 + 1);
  return { bitmap, width };
}
