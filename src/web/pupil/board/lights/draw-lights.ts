import type { Rgb } from '#core/rgb';
import { drawGlow, floorLight } from '../../../kit/drawing/draw-glow';
import type { LightLayout } from './light-form';

/** Distances that follow from the size of the parts; 1 is the distance between two lights. Look: WS2812B, 5 × 5 mm. */
const PACKAGE = 0.66;
const LENS = 0.25;
const BOARD_WIDTH = 1.16;

/** From this many lights on, the soft glow is drawn as two discs: gradients by the hundred take too long. */
const MANY = 64;

/** How far the light of a lamp reaches, in distances between lamps. */
const GLOW = 1.15;

/** The picture of a chain with all lights off, to be drawn under those that are on. */
export interface LightBoard {
  readonly layout: LightLayout;
  /** Canvas pixels per distance between lights. */
  readonly unit: number;
  readonly image: HTMLCanvasElement;
}

/** Room around the outermost lights for their glow, in distances. */
export const RIM = 0.75;

/** Draws a chain's board and its lamps, all off, once. */
export function drawLightBoard(layout: LightLayout, unit: number): LightBoard {
  const image = document.createElement('canvas');
  image.width = Math.ceil((layout.halfWidth + RIM) * 2 * unit);
  image.height = Math.ceil((layout.halfHeight + RIM) * 2 * unit);
  const context = image.getContext('2d');
  if (context === null) return { layout, unit, image };
  context.setTransform(unit, 0, 0, unit, image.width / 2, image.height / 2);
  context.lineJoin = 'round';
  for (const [color, width] of [
    ['#59636d', BOARD_WIDTH + 0.1],
    ['#1d2328', BOARD_WIDTH],
  ] as const) {
    context.strokeStyle = context.fillStyle = color;
    context.lineWidth = width;
    drawBoardShape(context, layout, width);
  }
  for (const { x, y } of layout.places) {
    context.fillStyle = '#d5dade';
    context.fillRect(x - PACKAGE / 2, y - PACKAGE / 2, PACKAGE, PACKAGE);
    context.fillStyle = '#b9bfb6';
    context.beginPath();
    context.arc(x, y, LENS, 0, 2 * Math.PI);
    context.fill();
  }
  return { layout, unit, image };
}

function drawBoardShape(context: CanvasRenderingContext2D, layout: LightLayout, width: number): void {
  context.beginPath();
  if (layout.form === 'ring') {
    context.arc(0, 0, layout.radius, 0, 2 * Math.PI);
    context.stroke();
    return;
  }
  const grown = (width - 1) / 2;
  const [x, y] = [layout.halfWidth + grown, layout.halfHeight + grown];
  context.roundRect(-x, -y, 2 * x, 2 * y, 0.2);
  context.fill();
}

/**
 * Draws a chain: its board, and the lamps that are on.
 *
 * @param context with the chain's middle as origin and canvas pixels per unit set by the caller: 1 unit is the distance
 *   between two lights
 */
export function drawLights(context: CanvasRenderingContext2D, board: LightBoard, colors: readonly Rgb[]): void {
  const { image, unit, layout } = board;
  const [width, height] = [image.width / unit, image.height / unit];
  context.drawImage(image, -width / 2, -height / 2, width, height);
  const lit = colors.flatMap((color, i) => {
    const at = layout.places[i];
    const light = floorLight(color);
    return at === undefined || light.alpha === 0 ? [] : [{ at, ...light, css: cssOf(light.color) }];
  });
  for (const { at, color, alpha, css } of lit) {
    if (lit.length <= MANY) {
      drawGlow(context, at, GLOW, color, 0.8 * alpha);
      continue;
    }
    context.fillStyle = css;
    for (const [radius, share] of [
      [GLOW * 0.8, 0.2],
      [GLOW * 0.5, 0.4],
    ] as const) {
      context.globalAlpha = share * alpha;
      context.beginPath();
      context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
      context.fill();
    }
  }
  for (const { at, alpha, css } of lit) {
    context.globalAlpha = alpha;
    context.fillStyle = css;
    context.fillRect(at.x - PACKAGE / 2, at.y - PACKAGE / 2, PACKAGE, PACKAGE);
    context.globalAlpha = 0.4 * alpha;
    context.fillStyle = '#ffffff';
    context.beginPath();
    context.arc(at.x, at.y, LENS * 0.8, 0, 2 * Math.PI);
    context.fill();
  }
  context.globalAlpha = 1;
}

const cssOf = ([red, green, blue]: Rgb): string => `rgb(${String(red)}, ${String(green)}, ${String(blue)})`;
