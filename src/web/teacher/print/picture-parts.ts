import type { Vec } from '#core/geometry';
import { unpackLevels } from '#scene/background';
import type { Background, Point, Scene } from '#scene/scene';

import { pixelsOf } from '../../pupil/arena/picture/background-grid';
import { lightPalette } from '../../pupil/arena/model/palette';
import { withPixelSize } from '../../pupil/arena/robot/robot-drawing';
import type { Trail } from '../../session/run/trail';
import { courseSvg, type PictureOptions } from './svg-course';
import { svgAddress } from './svg-address';

/** The pieces of a robot's trail in world mm: one ends where the hand lifted the robot. */
export function piecesOf(trail: Pick<Trail, 'count' | 'xyMm'>): Vec[][] {
  const pieces: Vec[][] = [[]];
  for (let i = 0; i < trail.count; i += 1) {
    const [x = NaN, y = NaN] = trail.xyMm.subarray(2 * i, 2 * i + 2);
    if (Number.isNaN(x)) pieces.push([]);
    else pieces[pieces.length - 1]?.push({ x, y });
  }
  return pieces.filter(({ length }) => length > 1);
}

/** Address of a background's visible picture: its picture, or its grid as a picture; `null` if that is damaged. */
export function pictureAddress(background: Background): string | null {
  if (background.picture !== '') return background.picture;
  const levels = unpackLevels(background);
  if (levels === null) return null;
  const canvas = canvasOf(background.cells);
  const image = new ImageData(background.cells[0], background.cells[1]);
  new Uint32Array(image.data.buffer).set(pixelsOf(levels));
  canvas.getContext('2d')?.putImageData(image, 0, 0);
  return canvas.toDataURL('image/png');
}

/** A picture in a form that a PDF can take. */
export interface PdfPicture {
  readonly data: string;
  readonly format: 'PNG' | 'JPEG';
}

/** The background for PDF, or `null`: none. */
export async function backgroundForPdf(background: Background | null): Promise<PdfPicture | null> {
  const address = background === null ? null : pictureAddress(background);
  return address === null ? null : pdfPicture(address);
}

/** A picture for PDF with its size in pixels; `null` if it is damaged. */
export async function sizedForPdf(address: string): Promise<(PdfPicture & { readonly size: Point }) | null> {
  try {
    const { naturalWidth, naturalHeight } = await imageOf(address);
    const picture = await pdfPicture(address);
    return picture === null ? null : { ...picture, size: [naturalWidth, naturalHeight] };
  } catch {
    return null;
  }
}

/** PNG and JPEG as they are, others repainted as JPEG on white. */
async function pdfPicture(address: string): Promise<PdfPicture | null> {
  if (address.startsWith('data:image/jpeg')) return { data: address, format: 'JPEG' };
  if (address.startsWith('data:image/png')) return { data: address, format: 'PNG' };
  const image = await imageOf(address);
  const canvas = canvasOf([image.naturalWidth, image.naturalHeight]);
  const context = canvas.getContext('2d');
  if (context === null) return null;
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0);
  return { data: canvas.toDataURL('image/jpeg', 0.92), format: 'JPEG' };
}

/** Longest side of a picture with a long task. Chosen: weak tablets have memory for a canvas of 4000 × 4000 pixels. */
const MOST_PX = 4000;

/**
 * A picture of a course as PNG on white.
 *
 * @param longestPx its longer side without the task; with a task it may be longer, up to `MOST_PX`
 */
export async function coursePng(scene: Scene, options: PictureOptions, longestPx: number): Promise<Blob> {
  // The background is painted on its own: WebKit leaves pictures within an SVG out of a canvas.
  const { svg, size, alone, corner } = courseSvg(scene, { ...options, background: null, floor: false });
  const scale = Math.min(longestPx / Math.max(...alone), MOST_PX / Math.max(...size));
  const canvas = canvasOf([Math.round(size[0] * scale), Math.round(size[1] * scale)]);
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('no canvas');
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.save();
  context.scale(scale, scale);
  context.translate(corner[0], corner[1]);
  context.fillStyle = lightPalette.floor;
  context.fillRect(0, 0, scene.size[0], scene.size[1]);
  if (options.background !== null && scene.background !== null) {
    const { at, size: extent } = scene.background;
    context.beginPath();
    context.rect(0, 0, scene.size[0], scene.size[1]);
    context.clip();
    context.globalCompositeOperation = 'multiply';
    const image = await imageOf(options.background);
    context.drawImage(image, at[0], scene.size[1] - at[1] - extent[1], extent[0], extent[1]);
  }
  context.restore();
  const drawing = withPixelSize(svg, canvas.width, canvas.height);
  const image = await imageOf(svgAddress(drawing));
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob === null ? reject(new Error('no PNG')) : resolve(blob)), 'image/png'),
  );
}

async function imageOf(address: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = address;
  await image.decode();
  return image;
}

function canvasOf([width, height]: Point): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  return canvas;
}
