/** Place of a message in the window, in CSS px: it is centred between `left` and `left` + `width`. */
export interface NoticePlace {
  readonly left: number;
  readonly top: number;
  readonly width: number;
}

/** A part of the page that has room for messages along its upper edge. */
export interface NoticeRoom {
  /** Its name in `data-notices`. */
  readonly name: string;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The best first: the arena is what all look at, and nothing is pressed along its upper edge. */
const ORDER = ['arena', 'console', 'code', 'board'];
const GAP_PX = 4;

/** Least room for two lines and their button, without covering most of what is below. Chosen by eye. */
const LEAST = { width: 260, height: 140 } as const;

/** A place where a message covers nothing that is used; `null`: at the foot of the page. */
export function noticePlace(rooms: readonly NoticeRoom[]): NoticePlace | null {
  const roomy = rooms.filter(({ width, height }) => width >= LEAST.width && height >= LEAST.height);
  const [best] = [...roomy].sort((one, other) => ORDER.indexOf(one.name) - ORDER.indexOf(other.name));
  return best === undefined ? null : { left: best.left, top: best.top + GAP_PX, width: best.width };
}
