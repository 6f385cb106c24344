import type { Vec } from '#core/geometry';

/**
 * Shifts all further drawing, by half a pixel of the canvas at most, so that `at` is on whole ones. Without a graphics
 * card a browser draws a picture ten times faster there than between pixels.
 *
 * @param context not turned
 */
export function shiftToWholePixels(context: CanvasRenderingContext2D, at: Vec): void {
  const { a, d, e, f } = context.getTransform();
  const [x, y] = [a * at.x + e, d * at.y + f];
  context.translate((Math.round(x) - x) / a, (Math.round(y) - y) / d);
}

/**
 * Draws a picture on whole pixels.
 *
 * @param context not turned
 * @param picture made for the pixels of this canvas
 * @param at place of its middle
 */
export function putPicture(context: CanvasRenderingContext2D, picture: HTMLCanvasElement, at: Vec): void {
  const before = context.getTransform();
  const { a, d, e, f } = before;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(
    picture,
    Math.round(a * at.x + e - picture.width / 2),
    Math.round(d * at.y + f - picture.height / 2),
  );
  context.setTransform(before);
}
