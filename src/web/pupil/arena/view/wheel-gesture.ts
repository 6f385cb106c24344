import type { Vec } from '#core/geometry';

/** The relevant part of a wheel's event. */
export type WheelTurn = Pick<WheelEvent, 'deltaX' | 'deltaY' | 'deltaMode' | 'shiftKey' | 'ctrlKey' | 'metaKey'>;

/** Effect of a turn of the wheel on the picture. */
export type WheelGesture =
  { readonly type: 'zoom'; readonly factor: number } | { readonly type: 'pan'; readonly byPx: Vec };

/** Px of the wheel per doubling of the zoom; a notch of 100 px then zooms by 1.26. */
const DOUBLING_PX = 300;

/** Smaller steps, in px, are from two fingers pinching a trackpad, not from a wheel. */
const PINCH_PX = 40;

/** Most that one event may zoom: a wheel that runs freely must not lose the place. */
const MOST_FACTOR = 2;

/** Converts a wheel's delta to px: Firefox may count lines and pages. */
export const wheelPx = (delta: number, mode: number): number => delta * (mode === 0 ? 1 : mode === 1 ? 33 : 600);

/**
 * The wheel zooms. With Shift, or when it turns sideways (two fingers across a trackpad), it moves the picture.
 * Pinching a trackpad arrives as a wheel with Ctrl and small steps, and zooms more per step.
 */
export function wheelGesture(turn: WheelTurn): WheelGesture {
  const x = wheelPx(turn.deltaX, turn.deltaMode);
  const y = wheelPx(turn.deltaY, turn.deltaMode);
  const isPinch = turn.ctrlKey || turn.metaKey;
  if (turn.shiftKey && !isPinch) return { type: 'pan', byPx: { x: -(x === 0 ? y : x), y: 0 } };
  if (Math.abs(x) > Math.abs(y) && !isPinch) return { type: 'pan', byPx: { x: -x, y: -y } };
  const strength = isPinch && Math.abs(y) < PINCH_PX ? 3 : 1;
  const factor = 2 ** ((-y * strength) / DOUBLING_PX);
  return { type: 'zoom', factor: Math.min(MOST_FACTOR, Math.max(1 / MOST_FACTOR, factor)) };
}
