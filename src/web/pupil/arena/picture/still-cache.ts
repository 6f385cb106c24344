import type { SceneObject } from '#scene/scene';
import type { Palette } from '../model/palette';
import type { PxBox } from '../view/moving-window';
import type { CanvasSize, View } from '../view/view-transform';

/** The properties that a cached picture depends on. */
export interface StillFrame {
  readonly view: View;
  readonly canvas: CanvasSize;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly palette: Palette;
  /** Everything else: if it changes, everything is repainted. */
  readonly look: unknown;
}

/** Paints objects in CSS px; `all`: these and those that are painted already. */
export type PaintList<T> = (context: CanvasRenderingContext2D, objects: readonly T[], all: readonly T[]) => void;

/** A picture of many objects, kept so that the same objects need not be painted again. */
export interface StillCache<T> {
  /**
   * Puts the picture of these objects on a canvas. New objects at the end of the list are added to it; after a change
   * of the view it is moved and stretched until `settled` is true.
   *
   * @param settled whether the view stands still: then the picture is as sharp as can be
   * @returns whether the picture is the one of this view
   */
  draw(
    context: CanvasRenderingContext2D,
    frame: StillFrame,
    objects: readonly T[],
    paint: PaintList<T>,
    settled: boolean,
  ): boolean;
}

/** Courses of less than this many points and objects are painted at once: that is as quick, and always sharp. */
const MANY = 1500; // chosen: 4 ms on the reference tablet

/** Amount of painting, in points; an object counts as this many. */
const OBJECT_POINTS = 20;

/** True if a picture of these objects should be kept. */
export function areMany(objects: readonly SceneObject[]): boolean {
  let count = 0;
  for (const object of objects) {
    count += object.type === 'stroke' ? object.points.length + OBJECT_POINTS : OBJECT_POINTS;
    if (count >= MANY) return true;
  }
  return false;
}

/** True if two objects look the same. */
export type IsSame<T> = (one: T, other: T) => boolean;

/** How many objects more there are than before at the end of the list, or `null` where anything else has changed. */
export function addedTo<T>(
  before: readonly T[],
  now: readonly T[],
  isSameObject: IsSame<T> = Object.is,
): number | null {
  if (now.length < before.length) return null;
  for (let i = 0; i < before.length; i += 1) {
    const [one, other] = [before[i], now[i]];
    if (one === undefined || other === undefined || !isSameObject(one, other)) return null;
  }
  return now.length - before.length;
}

/** The place of a picture made for one view in another one, in CSS px. */
export function placeInView(made: View, now: View, canvas: CanvasSize): PxBox {
  const factor = now.pxPerMm / made.pxPerMm;
  return {
    left: now.leftPx - made.leftPx * factor,
    top: now.bottomPx - made.bottomPx * factor,
    width: canvas.widthPx * factor,
    height: canvas.heightPx * factor,
  };
}

/** Makes an empty cache. Its canvas is made with the first picture. */
export function createStillCache<T>(isSameObject: IsSame<T> = Object.is): StillCache<T> {
  let bitmap: HTMLCanvasElement | null = null;
  let made: StillFrame | null = null;
  let shown: readonly T[] = [];
  const fill = (frame: StillFrame, objects: readonly T[], paint: PaintList<T>, from: number): void => {
    bitmap ??= document.createElement('canvas');
    const context = bitmap.getContext('2d');
    if (context === null) return;
    const { canvas, ratio } = frame;
    if (from === 0) {
      bitmap.width = Math.round(canvas.widthPx * ratio); // this empties it
      bitmap.height = Math.round(canvas.heightPx * ratio);
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint(context, from === 0 ? objects : objects.slice(from), objects);
    made = frame;
    shown = objects;
  };
  return {
    draw(context, frame, objects, paint, settled) {
      const added = made !== null && isSameBut(made, frame) ? addedTo(shown, objects, isSameObject) : null;
      const isSameView = made !== null && isSame(made.view, frame.view);
      if (added === null || (settled && !isSameView)) fill(frame, objects, paint, 0);
      else if (added > 0 && isSameView) fill(frame, objects, paint, shown.length);
      if (bitmap === null || made === null) return true;
      put(context, bitmap, placeInView(made.view, frame.view, made.canvas), frame);
      return isSame(made.view, frame.view) && shown.length === objects.length;
    },
  };
}

/** Puts a picture at a place. On whole canvas pixels that is a mere copy, many times as quick as a stretched one. */
function put(
  context: CanvasRenderingContext2D,
  bitmap: HTMLCanvasElement,
  box: PxBox,
  { canvas, ratio }: StillFrame,
): void {
  const isMoved = Math.abs(box.width - canvas.widthPx) < 0.01;
  context.save();
  if (isMoved) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(bitmap, Math.round(box.left * ratio), Math.round(box.top * ratio));
  } else {
    context.imageSmoothingEnabled = false; // it lasts a moment
    context.drawImage(bitmap, box.left, box.top, box.width, box.height);
  }
  context.restore();
}

const isSame = (one: View, other: View): boolean =>
  one.pxPerMm === other.pxPerMm && one.leftPx === other.leftPx && one.bottomPx === other.bottomPx;

/** True if two frames differ in nothing but the view. */
const isSameBut = (one: StillFrame, other: StillFrame): boolean =>
  one.ratio === other.ratio &&
  one.palette === other.palette &&
  one.look === other.look &&
  one.canvas.widthPx === other.canvas.widthPx &&
  one.canvas.heightPx === other.canvas.heightPx;
