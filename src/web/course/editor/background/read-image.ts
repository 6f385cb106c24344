import { svgProblem, svgSize } from './check-svg';
import { readImageHeader, type ImageHeader } from './image-header';
import { pictureOf } from './picture-of';
import type { Pixels } from './pixels';

/** Why a file cannot be used as a picture. */
export type BackgroundProblem = 'type' | 'file-too-large' | 'unsafe' | 'damaged' | 'no-memory';

/**
 * Longest side of an opened picture in pixels; a larger one is scaled down while it is opened. Chosen: twice what the
 * sensors tell apart on 2 m, and 16 MB of memory.
 */
export const LONGEST_PX = 2000;

/** Largest drawing that is read, in bytes: it is text, and all of it is checked. */
const MOST_SVG_BYTES = 50_000_000;

/** Range in which a header is searched, in bytes: cameras write small pictures and much text before it. */
const HEADER_BYTES = 1_000_000;

/** A picture with more pixels than this that cannot be opened is too large for the device, in all likelihood. */
const MANY_PIXELS = 50_000_000;

/** A picture that has been opened. */
export interface OpenedPicture {
  readonly pixels: Pixels;
  /** A photograph: too large as a PNG, and without transparent parts. */
  readonly isPhoto: boolean;
}

/** A problem found while reading. */
class Refusal extends Error {
  constructor(readonly problem: BackgroundProblem) {
    super(problem);
  }
}

/**
 * Opens a picture file (PNG, JPEG, or an SVG that contains only a picture), scaled down to `LONGEST_PX`. Only pixels are
 * kept, so that nothing else in the file survives.
 *
 * @returns a problem to report if the file cannot be read; never rejects
 */
export async function openPicture(
  file: Blob,
): Promise<{ readonly picture: OpenedPicture } | { readonly problem: BackgroundProblem }> {
  let header: ImageHeader | null = null;
  try {
    header = readImageHeader(new Uint8Array(await file.slice(0, HEADER_BYTES).arrayBuffer()));
    const pixels = header === null ? await pixelsOfSvg(file) : await pixelsOfBitmap(file, header);
    return { picture: { pixels, isPhoto: header?.type === 'jpeg' } };
  } catch (error) {
    if (error instanceof Refusal) return { problem: error.problem };
    return { problem: header !== null && header.widthPx * header.heightPx > MANY_PIXELS ? 'no-memory' : 'damaged' };
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
  const opened = await openPicture(file);
  return 'problem' in opened ? opened : { picture: pictureOf(opened.picture, mostCharacters) };
}

/** The browser scales while it opens, so that a large photograph is never in memory as a whole. */
async function pixelsOfBitmap(file: Blob, { type, widthPx, heightPx }: ImageHeader): Promise<Pixels> {
  const isLarge = Math.max(widthPx, heightPx) > LONGEST_PX;
  // One side alone keeps the proportions, also of a photograph that says how it is to be turned.
  const side = widthPx >= heightPx ? 'resizeWidth' : 'resizeHeight';
  const options: ImageBitmapOptions = isLarge ? { [side]: LONGEST_PX, resizeQuality: 'high' } : {};
  const bitmap = await createImageBitmap(new Blob([file], { type: `image/${type}` }), options);
  try {
    return painted(bitmap, bitmap.width, bitmap.height);
  } finally {
    bitmap.close();
  }
}

async function pixelsOfSvg(file: Blob): Promise<Pixels> {
  if (file.size > MOST_SVG_BYTES) throw new Refusal('file-too-large');
  let text: string;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    throw new Refusal('type');
  }
  const problem = svgProblem(text);
  if (problem !== null) throw new Refusal(problem === 'unsafe' ? 'unsafe' : 'type');
  const size = svgSize(text);
  if (size === null) throw new Refusal('damaged');
  const scale = LONGEST_PX / Math.max(size.width, size.height);
  const widthPx = Math.max(1, Math.round(size.width * scale));
  const heightPx = Math.max(1, Math.round(size.height * scale));
  const url = URL.createObjectURL(new Blob([sizedSvg(text, size, widthPx, heightPx)], { type: 'image/svg+xml' }));
  const image = new Image(widthPx, heightPx);
  image.src = url;
  try {
    await image.decode();
    return painted(image, widthPx, heightPx);
  } finally {
    URL.revokeObjectURL(url);
  }
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

/** The pixels of what is painted, scaled down where it is larger than asked for. */
function painted(source: CanvasImageSource, widthPx: number, heightPx: number): Pixels {
  // A browser that does not scale while it opens, and a turned photograph, may bring more.
  const scale = Math.min(1, LONGEST_PX / Math.max(widthPx, heightPx));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(widthPx * scale));
  canvas.height = Math.max(1, Math.round(heightPx * scale));
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Refusal('no-memory');
  context.imageSmoothingQuality = 'high';
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}
