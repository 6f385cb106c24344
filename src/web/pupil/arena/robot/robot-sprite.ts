import { type Box, type RobotDrawing, withPixelSize } from './robot-drawing';

/** A robot drawing turned into pixels for one zoom. */
export interface RobotSprite {
  readonly body: HTMLCanvasElement;
  /** Its soft shadow; covers `shadowBox`. */
  readonly shadow: HTMLCanvasElement;
  /** The area of `shadow`, in drawing units (mm): the drawing and a rim for the blur. */
  readonly shadowBox: Box;
}

/** Sprites of one drawing at the zooms requested so far. */
export interface SpriteShelf {
  /**
   * The sprite for this many canvas pixels per mm, or the nearest one while it is being made, or `null` if there is
   * none yet (or the drawing cannot be read).
   */
  at(pixelsPerMm: number): RobotSprite | null;
}

/** Soft rim of the shadow in mm. */
const SHADOW_BLUR_MM = 4;

/** Steps between resolutions; a sprite is drawn at most this much smaller than it is, never larger. */
const STEP = Math.SQRT2;

/** Finest sprite made: beyond 24 pixels per mm (a robot of 2000 pixels) a sprite is stretched. */
const FINEST_STEP = Math.round(Math.log(24) / Math.log(STEP));

/** The resolution step for this many canvas pixels per mm; step n has √2ⁿ pixels per mm. */
export function resolutionStep(pixelsPerMm: number): number {
  const exact = Math.log(Math.max(pixelsPerMm, 0.25)) / Math.log(STEP);
  return Math.min(FINEST_STEP, Math.ceil(exact - 1e-6));
}

/**
 * Makes sprites of a drawing when they are first needed. The browser reads the SVG as an image from a data URL (allowed
 * by `img-src data:`), which takes a moment.
 *
 * @param ready called when a sprite has been made, so that the picture can be drawn again
 * @param tint a colour over everything; its alpha is the strength
 */
export function createSpriteShelf(
  drawing: Pick<RobotDrawing, 'svg' | 'viewBox'>,
  ready: () => void,
  tint: string | null = null,
): SpriteShelf {
  const made = new Map<number, RobotSprite>();
  const asked = new Set<number>();
  const ask = (step: number): void => {
    asked.add(step);
    const pixelsPerMm = STEP ** step;
    const image = new Image();
    const { width, height } = pixelSize(drawing.viewBox, pixelsPerMm);
    image.onload = () => {
      const body = canvasOf(width, height, (context) => {
        context.drawImage(image, 0, 0, width, height);
        if (tint === null) return;
        context.globalCompositeOperation = 'source-atop';
        context.fillStyle = tint;
        context.fillRect(0, 0, width, height);
      });
      made.set(step, { body, ...shadowOf(body, drawing.viewBox, pixelsPerMm) });
      ready();
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(withPixelSize(drawing.svg, width, height))}`;
  };
  return {
    at(pixelsPerMm) {
      const step = resolutionStep(pixelsPerMm);
      const exact = made.get(step);
      if (exact !== undefined) return exact;
      if (!asked.has(step)) ask(step);
      let nearest: number | null = null;
      for (const other of made.keys())
        if (nearest === null || Math.abs(other - step) < Math.abs(nearest - step)) nearest = other;
      return nearest === null ? null : (made.get(nearest) ?? null);
    },
  };
}

/** The drawing as one dark blurred spot. Canvas shadows are the one blur that all browsers have. */
function shadowOf(body: HTMLCanvasElement, box: Box, pixelsPerMm: number): Pick<RobotSprite, 'shadow' | 'shadowBox'> {
  const rim = SHADOW_BLUR_MM * 1.5;
  const shadowBox = { x: box.x - rim, y: box.y - rim, width: box.width + 2 * rim, height: box.height + 2 * rim };
  const { width, height } = pixelSize(shadowBox, pixelsPerMm);
  const shadow = canvasOf(width, height, (context) => {
    context.shadowColor = '#000';
    context.shadowBlur = SHADOW_BLUR_MM * pixelsPerMm;
    context.shadowOffsetX = width * 2; // the body itself is beyond the edge, only its shadow falls in
    context.drawImage(body, rim * pixelsPerMm - width * 2, rim * pixelsPerMm);
  });
  return { shadow, shadowBox };
}

function pixelSize(box: Box, pixelsPerMm: number): { width: number; height: number } {
  return { width: Math.ceil(box.width * pixelsPerMm), height: Math.ceil(box.height * pixelsPerMm) };
}

function canvasOf(
  width: number,
  height: number,
  paint: (context: CanvasRenderingContext2D) => void,
): HTMLCanvasElement {
  const canvas = emptyCanvas(width, height);
  const context = canvas.getContext('2d');
  if (context !== null) paint(context);
  return canvas;
}

/** A canvas of this many pixels that is not attached to the page. */
export function emptyCanvas(width: number, height: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  return canvas;
}
