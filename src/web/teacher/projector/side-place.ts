/** Place of task and timer: left of the arena or above it, never over the course, and their size in CSS px. */
export interface SidePlace {
  readonly kind: 'beside' | 'above';
  readonly px: number;
}

/** Height of the arena's foot, in CSS px: what its styles give it. */
const FOOT_PX = 64;
/** Least width and height for reading, and the shares of the window between which it may grow. Chosen by eye. */
const LEAST = { width: 340, height: 200 } as const;
const SHARES = { beside: [0.36, 0.5], above: [0.38, 0.6] } as const;
/** A course above which the task stands must be so much larger than beside it. */
const WORTH = 1.1;

/**
 * The place that leaves the course most; what the course leaves goes to the task.
 *
 * @param width of the window, in CSS px
 * @param height of the window, in CSS px
 * @param ratio width of the course by its height
 */
export function sidePlace(width: number, height: number, ratio: number): SidePlace {
  const free = Math.max(1, height - FOOT_PX);
  const beside = between(width - ratio * free, LEAST.width, SHARES.beside, width);
  const above = between(free - width / ratio, LEAST.height, SHARES.above, height);
  const besideScale = Math.min((width - beside) / ratio, free);
  const aboveScale = Math.min(width / ratio, free - above);
  return aboveScale > WORTH * besideScale ? { kind: 'above', px: above } : { kind: 'beside', px: beside };
}

function between(wishPx: number, leastPx: number, [low, high]: readonly [number, number], ofPx: number): number {
  return Math.round(Math.min(Math.max(wishPx, leastPx, low * ofPx), Math.max(leastPx, high * ofPx)));
}
