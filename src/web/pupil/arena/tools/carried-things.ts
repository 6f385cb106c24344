import { commonStep } from '#editor/moves';
import { boundsOf } from '#scene/kinds/index';
import type { SceneObject } from '#scene/scene';
import { areMany } from '../picture/still-cache';
import { unionOf, type PxBox } from '../view/moving-window';
import { toPx, type View } from '../view/view-transform';
import type { MarkFrame } from './mark-frame';

/** The frame in which carried things are painted. */
export interface CarriedFrame extends MarkFrame {
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
}

/** Paints things, either one by one or, if there are many, as one picture that is cached while they move together. */
export type CarriedThings = (
  context: CanvasRenderingContext2D,
  frame: CarriedFrame,
  things: readonly SceneObject[],
  paint: (context: CanvasRenderingContext2D, thing: SceneObject) => void,
) => void;

/** The picture of some things at the places where they were painted. */
interface Kept {
  readonly frame: CarriedFrame;
  readonly things: readonly SceneObject[];
  readonly bitmap: HTMLCanvasElement;
  /** The part of the arena that it shows, CSS px. */
  readonly box: PxBox;
  /** Distance by which it may be moved before something is missing, in px. */
  readonly reachPx: number;
}

/** This share of the canvas is painted beyond its edges, too, so that things may move into sight. */
const MARGIN = 0.25;

/** Makes an empty cache of carried things. */
export function createCarriedThings(): CarriedThings {
  let kept: Kept | null = null;
  return (context, frame, things, paint) => {
    if (!areMany(things)) {
      for (const thing of things) paint(context, thing);
      return;
    }
    let byPx = kept && stepPx(kept, frame, things);
    if (kept === null || byPx === null) {
      kept = painted(frame, things, paint);
      byPx = { x: 0, y: 0 };
    }
    const { e, f } = context.getTransform();
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0); // on whole pixels it is a mere copy
    const at = (px: number, origin: number): number => Math.round(px * frame.ratio + origin);
    context.drawImage(kept.bitmap, at(kept.box.left + byPx.x, e), at(kept.box.top + byPx.y, f));
    context.restore();
  };
}

/** Shift of a cached picture that shows these things; `null`: it cannot show them. */
function stepPx(kept: Kept, frame: CarriedFrame, things: readonly SceneObject[]): { x: number; y: number } | null {
  if (!isSameFrame(kept.frame, frame)) return null;
  const step = commonStep(kept.things, things);
  if (step === null) return null;
  const { pxPerMm } = frame.view;
  const by = { x: step.x * pxPerMm, y: -step.y * pxPerMm };
  return Math.max(Math.abs(by.x), Math.abs(by.y)) > kept.reachPx ? null : by;
}

const isSameFrame = (one: CarriedFrame, other: CarriedFrame): boolean =>
  one.ratio === other.ratio &&
  one.palette === other.palette &&
  one.canvas.widthPx === other.canvas.widthPx &&
  one.canvas.heightPx === other.canvas.heightPx &&
  one.view.pxPerMm === other.view.pxPerMm &&
  one.view.leftPx === other.view.leftPx &&
  one.view.bottomPx === other.view.bottomPx;

function painted(
  frame: CarriedFrame,
  things: readonly SceneObject[],
  paint: (context: CanvasRenderingContext2D, thing: SceneObject) => void,
): Kept {
  const { canvas, ratio, view } = frame;
  const marginPx = Math.round(MARGIN * Math.max(canvas.widthPx, canvas.heightPx));
  const whole = unionOf(things.map((thing) => thingBox(view, thing)));
  const box = clipped(whole, {
    left: -marginPx,
    top: -marginPx,
    width: canvas.widthPx + 2 * marginPx,
    height: canvas.heightPx + 2 * marginPx,
  });
  const isWhole = box.width >= whole.width && box.height >= whole.height;
  const bitmap = document.createElement('canvas');
  bitmap.width = Math.ceil(box.width * ratio);
  bitmap.height = Math.ceil(box.height * ratio);
  const context = bitmap.getContext('2d');
  if (context !== null) {
    context.setTransform(ratio, 0, 0, ratio, -box.left * ratio, -box.top * ratio);
    for (const thing of things) paint(context, thing);
  }
  return { frame, things, bitmap, box, reachPx: isWhole ? Infinity : marginPx };
}

/** Intersection of two boxes, on whole px. */
function clipped(box: PxBox, to: PxBox): PxBox {
  const left = Math.floor(Math.max(box.left, to.left));
  const top = Math.floor(Math.max(box.top, to.top));
  const right = Math.ceil(Math.min(box.left + box.width, to.left + to.width));
  const bottom = Math.ceil(Math.min(box.top + box.height, to.top + to.height));
  return { left, top, width: Math.max(1, right - left), height: Math.max(1, bottom - top) };
}

/** Shadow, frame and, on a stroke, round ends extend this far beyond a thing, in px. */
const RIM_PX = 14;

/** Area of a thing with everything that is drawn around it, in CSS px. */
export function thingBox(view: View, thing: SceneObject): PxBox {
  const { minX, minY, maxX, maxY } = boundsOf(thing);
  const corner = toPx(view, { x: minX, y: maxY });
  return {
    left: corner.x - RIM_PX,
    top: corner.y - RIM_PX,
    width: (maxX - minX) * view.pxPerMm + 2 * RIM_PX,
    height: (maxY - minY) * view.pxPerMm + 2 * RIM_PX,
  };
}
