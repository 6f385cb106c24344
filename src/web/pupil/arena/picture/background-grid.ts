import { BRIGHTEST_LEVEL, unpackLevels } from '#scene/background';
import type { Background } from '#scene/scene';

/** The grid that the sensors read, one pixel a cell. */
export function gridPicture(background: Background): HTMLCanvasElement | null {
  const levels = unpackLevels(background);
  if (levels === null) return null;
  const [columns, rows] = background.cells;
  const canvas = document.createElement('canvas');
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext('2d');
  if (context === null) return null;
  const image = context.createImageData(columns, rows);
  new Uint32Array(image.data.buffer).set(pixelsOf(levels));
  context.putImageData(image, 0, 0);
  return canvas;
}

/** Opaque greys, one pixel per number, in the order of little-endian machines (all that browsers run on). */
export function pixelsOf(levels: Uint8Array): Uint32Array {
  const greys = Uint32Array.from({ length: BRIGHTEST_LEVEL + 1 }, (_, level) => {
    const grey = Math.round((level * 255) / BRIGHTEST_LEVEL);
    return ((255 << 24) | (grey << 16) | (grey << 8) | grey) >>> 0;
  });
  return Uint32Array.from(levels, (level) => greys[level] ?? 0);
}
