import { packLevels } from '#scene/background';
import type { Background, Point } from '#scene/scene';

import { svgProblem, svgSize } from './check-svg';
import { fitBackground } from './fit-background';
import { readImageHeader } from './image-header';
import { pictureOf } from './picture-of';
import { createRaster } from './raster';

/** Why a file cannot be used as the floor. */
export type BackgroundProblem = 'type' | 'file-too-large' | 'too-many-pixels' | 'unsafe' | 'damaged' | 'no-memory';

/** Largest file that is opened, in bytes. */
const MOST_BYTES = 50_000_000;

/** Most pixels of a picture that is decoded: each needs 4 bytes of memory. */
const MOST_PIXELS = 50_000_000;

/** Pixels along the longer side of a drawing, which has none of its own: enough to look sharp on a screen. */
const SVG_PX = 3000;

/** Size of the strips in which a picture is turned into levels, in pixels. */
const STRIP_PIXELS = 1_000_000;

/** A picture that has been opened. */
interface Opened {
  readonly source: CanvasImageSource;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly isPhoto: boolean;
  close(): void;
}

/** A problem found while reading. */
class Refusal extends Error {
  constructor(readonly problem: BackgroundProblem) {
    super(problem);
  }
}

/**
 * Makes a background from a picture file (PNG, JPEG, or an SVG that contains only a picture): in the middle of the
 * arena, as large as fits, with the grid that the line sensors read and the picture that is displayed. That one is
 * repainted, so that nothing else in the file survives.
 *
 * @param arena its size in mm
 * @returns a problem to report (`backgroundProblemTexts`) if the file cannot be read; never rejects
 */
export async function readBackground(
  file: Blob,
  arena: Point,
): Promise<{ readonly background: Background } | { readonly problem: BackgroundProblem }> {
  let opened: Opened | null = null;
  try {
    opened = await open(file);
    const { widthPx, heightPx } = opened;
    const place = fitBackground(widthPx, heightPx, arena);
    const raster = createRaster(widthPx, heightPx, place.cells[0], place.cells[1]);
    for (const strip of stripsOf(opened)) {
      raster.add(strip);
      await breath();
    }
    return { background: { ...place, levels: packLevels(raster.levels()), picture: pictureOf(opened) } };
  } catch (error) {
    if (error instanceof Refusal) return { problem: error.problem };
    return { problem: opened === null ? 'damaged' : 'no-memory' };
  } finally {
    opened?.close();
  }
}

/**
 * Makes the picture of a task from a picture file: small enough, and repainted, so that nothing else in the file
 * survives.
 *
 * @returns a problem if the file cannot be read; never rejects
 */
export async function readPicture(
  file: Blob,
  mostCharacters: number,
): Promise<{ readonly picture: string } | { readonly problem: BackgroundProblem }> {
  let opened: Opened | null = null;
  try {
    opened = await open(file);
    return { picture: pictureOf(opened, mostCharacters) };
  } catch (error) {
    return { problem: error instanceof Refusal ? error.problem : 'damaged' };
  } finally {
    opened?.close();
  }
}

async function open(file: Blob): Promise<Opened> {
  if (file.size > MOST_BYTES) throw new Refusal('file-too-large');
  const bytes = new Uint8Array(await file.arrayBuffer());
  const header = readImageHeader(bytes);
  if (header === null) return openSvg(bytes);
  if (header.widthPx * header.heightPx > MOST_PIXELS) throw new Refusal('too-many-pixels');
  const bitmap = await createImageBitmap(new Blob([bytes], { type: `image/${header.type}` }));
  return {
    source: bitmap,
    widthPx: bitmap.width,
    heightPx: bitmap.height,
    isPhoto: header.type === 'jpeg',
    close: () => bitmap.close(),
  };
}

async function openSvg(bytes: Uint8Array): Promise<Opened> {
  let text: string;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Refusal('type');
  }
  const problem = svgProblem(text);
  if (problem !== null) throw new Refusal(problem === 'unsafe' ? 'unsafe' : 'type');
  const size = svgSize(text);
  if (size === null) throw new Refusal('damaged');
  const scale = SVG_PX / Math.max(size.width, size.height);
  const widthPx = Math.max(1, Math.round(size.width * scale));
  const heightPx = Math.max(1, Math.round(size.height * scale));
  const url = URL.createObjectURL(new Blob([sizedSvg(text, size, widthPx, heightPx)], { type: 'image/svg+xml' }));
  const image = new Image(widthPx, heightPx);
  image.src = url;
  const close = (): void => URL.revokeObjectURL(url);
  try {
    await image.decode();
  } catch (error) {
    close();
    throw error;
  }
  return { source: image, widthPx, heightPx, isPhoto: false, close };
}

/** The drawing with a size in pixels: without one, Firefox draws nothing on a canvas. */
function sizedSvg(
  text: string,
  size: { readonly width: number; readonly height: number },
  widthPx: number,
  heightPx: number,
): string {
  const document = new DOMParser().parseFromString(text, 'image/svg+xml');
  const root = document.documentElement;
  if (root.localName !== 'svg' || document.querySelector('parsererror') !== null) throw new Refusal('damaged');
  if (!root.hasAttribute('viewBox')) root.setAttribute('viewBox', `0 0 ${String(size.width)} ${String(size.height)}`);
  root.setAttribute('width', String(widthPx));
  root.setAttribute('height', String(heightPx));
  return new XMLSerializer().serializeToString(document);
}

/** The pixels, a few rows at a time: a large photograph does not fit into a tablet's memory as a whole. */
function* stripsOf({ source, widthPx, heightPx }: Opened): Generator<Uint8ClampedArray> {
  const rows = Math.min(heightPx, Math.max(1, Math.floor(STRIP_PIXELS / widthPx)));
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = rows;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Refusal('no-memory');
  for (let from = 0; from < heightPx; from += rows) {
    const height = Math.min(rows, heightPx - from);
    context.clearRect(0, 0, widthPx, rows);
    context.drawImage(source, 0, -from, widthPx, heightPx);
    yield context.getImageData(0, 0, widthPx, height).data;
  }
}

/** Lets the page draw and respond in between. */
const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
