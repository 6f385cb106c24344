import type { PxBox } from './moving-window';

/** Lets nothing be drawn outside of a box until the next `restore`. */
export function clipTo(context: CanvasRenderingContext2D, box: PxBox): void {
  context.beginPath();
  context.rect(box.left, box.top, box.width, box.height);
  context.clip();
}
