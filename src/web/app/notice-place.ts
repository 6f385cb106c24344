/** Place of a message in the window, in CSS px: it is centred between `left` and `left` + `width`. */
export interface NoticePlace {
  readonly left: number;
  readonly width: number;
  /** Its upper edge, or its lower one. */
  readonly at: { readonly top: number } | { readonly bottom: number };
}

/** A part of the page that has room for messages along an edge. */
export interface NoticeRoom {
  /** Its name in `data-notices`. */
  readonly name: string;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/**
 * The best first. Nobody waits for the last lines of a program or a console, and targets lie anywhere in the arena: there, a message
 * has only the upper edge, which is the farthest from the next step.
 */
const ORDER = ['code', 'console', 'board', 'arena'];
const GAP_PX = 4;

/** Least room for two lines and their button, without covering most of what is below. Chosen by eye. */
const LEAST = { width: 260, height: 140 } as const;

/** A place where a message covers nothing that is used; `null`: at the foot of the page. */
export function noticePlace(rooms: readonly NoticeRoom[]): NoticePlace | null {
  const roomy = rooms.filter(({ width, height }) => width >= LEAST.width && height >= LEAST.height);
  const [best] = [...roomy].sort((one, other) => ORDER.indexOf(one.name) - ORDER.indexOf(other.name));
  if (best === undefined) return null;
  const { name, left, top, width, height } = best;
  return { left, width, at: name === 'code' ? { bottom: top + height - GAP_PX } : { top: top + GAP_PX } };
}
