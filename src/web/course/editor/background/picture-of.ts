import { sceneLimits } from '#scene/scene';

import type { Pixels } from './pixels';

/** Its limit in characters: well below that of a course, as all copies of the work share the browser's 5 million. */
const MOST_CHARACTERS = Math.min(600_000, sceneLimits.pictureCharacters);

/** The picture to paint. */
interface Source {
  readonly pixels: Pixels;
  /** A photograph: too large as a PNG, and without transparent parts. */
  readonly isPhoto: boolean;
}

/**
 * Repaints a picture as a `data:image/…` URL of limited length: PNG if that is short (drawings), otherwise WebP or JPEG
 * (photographs), scaled down until it fits. Everything else in the file (location, camera, name) is dropped.
 */
export function pictureOf({ pixels, isPhoto }: Source, mostCharacters: number = MOST_CHARACTERS): string {
  const whole = canvasOf(pixels);
  for (let scale = 1; Math.max(whole.width, whole.height) * scale >= 1; scale /= 1.5) {
    const found = encoded(scaled(whole, scale), isPhoto, mostCharacters);
    if (found.length <= mostCharacters) return found;
  }
  return ''; // the grey levels are shown instead
}

function encoded(canvas: HTMLCanvasElement, isPhoto: boolean, mostCharacters: number): string {
  if (!isPhoto) {
    const png = canvas.toDataURL('image/png');
    if (png.length <= mostCharacters) return png;
  }
  // A browser that cannot write WebP returns a PNG. JPEG has no transparency: transparent parts would turn black.
  const webp = canvas.toDataURL('image/webp', 0.85);
  if (webp.startsWith('data:image/webp')) return webp;
  return isPhoto || isOpaque(canvas) ? canvas.toDataURL('image/jpeg', 0.85) : webp;
}

/** A canvas that shows a picture. */
export function canvasOf({ data, width, height }: Pixels): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  canvas.getContext('2d', { willReadFrequently: true })?.putImageData(new ImageData(data, width, height), 0, 0);
  return canvas;
}

/** A canvas scaled down by this factor; from 1 on the canvas itself. */
export function scaled(source: HTMLCanvasElement, scale: number): HTMLCanvasElement {
  if (scale >= 1) return source;
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(source.width * scale));
  canvas.height = Math.max(1, Math.round(source.height * scale));
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) return canvas;
  context.imageSmoothingQuality = 'high';
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}

function isOpaque(canvas: HTMLCanvasElement): boolean {
  const data = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
  for (let i = 3; i < data.length; i += 4) if (data[i] !== 255) return false;
  return true;
}
