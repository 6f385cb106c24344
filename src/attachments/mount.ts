import type { Vec } from '#core/geometry';
import type { AttachmentContext } from './attachment';

/** A shape given in the frame of the attachment, in the robot's frame and at this robot's size. */
export function onRobot({ mountMm, scale }: AttachmentContext, shape: readonly Vec[]): Vec[] {
  return shape.map(({ x, y }) => ({ x: (mountMm.x + x) * scale, y: (mountMm.y + y) * scale }));
}

/** An upright rectangle between two corners, counter-clockwise. */
export function box(fromX: number, toX: number, fromY: number, toY: number): Vec[] {
  return [
    { x: fromX, y: fromY },
    { x: toX, y: fromY },
    { x: toX, y: toY },
    { x: fromX, y: toY },
  ];
}

/** The share of the way from `from` to `to` at which a value lies, clamped to 0 … 1. */
export function shareOfWay(value: number, from: number, to: number): number {
  return Math.min(Math.max((value - from) / (to - from), 0), 1);
}
