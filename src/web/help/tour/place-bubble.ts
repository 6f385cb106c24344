/** A part of the window, CSS px from its upper left corner. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

const GAP_PX = 14; // chosen: room for the ring around what is pointed at
const EDGE_PX = 8; // chosen: as between panes
const BEGINNING_COUNTS = 2; // chosen: on a phone the bubble stands below the first lines of a program

/**
 * The place of a bubble that points at something: below it, beside it or above it, wherever it has room without
 * covering it; otherwise the corner of the window where it covers least of it, preferring the end to the beginning,
 * which is read first. The bubble is always wholly in the window, if that is large enough. Without anything to point
 * at, it is in the middle.
 */
export function placeBubble(
  target: Box | null,
  bubble: Size,
  view: Size,
): { readonly left: number; readonly top: number } {
  const free = { width: view.width - bubble.width - EDGE_PX, height: view.height - bubble.height - EDGE_PX };
  const inside = (left: number, top: number) => ({
    left: Math.max(EDGE_PX, Math.min(free.width, left)),
    top: Math.max(EDGE_PX, Math.min(free.height, top)),
  });
  if (target === null) return inside((view.width - bubble.width) / 2, (view.height - bubble.height) / 2);
  const middle = {
    left: target.left + (target.width - bubble.width) / 2,
    top: target.top + (target.height - bubble.height) / 2,
  };
  const [right, bottom] = [target.left + target.width, target.top + target.height];
  const around = [
    inside(middle.left, bottom + GAP_PX),
    inside(right + GAP_PX, middle.top),
    inside(target.left - GAP_PX - bubble.width, middle.top),
    inside(middle.left, target.top - GAP_PX - bubble.height),
    inside(free.width, free.height),
    inside(0, free.height),
    inside(free.width, 0),
    inside(0, 0),
  ];
  const beginning = { ...target, height: target.height / 2 };
  const covered = around.map((place) => {
    const box = { ...place, ...bubble };
    return overlap(box, target) + BEGINNING_COUNTS * overlap(box, beginning);
  });
  return around[covered.indexOf(Math.min(...covered))] ?? inside(0, 0);
}

/** Overlap of two boxes, in px². */
function overlap(one: Box, other: Box): number {
  const width = Math.min(one.left + one.width, other.left + other.width) - Math.max(one.left, other.left);
  const height = Math.min(one.top + one.height, other.top + other.height) - Math.max(one.top, other.top);
  return Math.max(0, width) * Math.max(0, height);
}
