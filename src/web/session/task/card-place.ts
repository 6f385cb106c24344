/** A rectangle of the window, in CSS px. */
export interface Area {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * Place of the card. `over`: over the panes beside or above the arena; `beside` and `sheet`: the arena makes room, left
 * of it or below it, because nothing else is on the screen.
 */
export type CardPlace =
  | { readonly kind: 'over'; readonly area: Area }
  | { readonly kind: 'beside'; readonly area: Area }
  | { readonly kind: 'sheet'; readonly area: Area };

/** The surroundings that the place depends on. */
export interface AroundCard {
  /** The room of all panes, or the whole window when the arena fills it. */
  readonly panes: Area;
  /** The arena; `null`: it is not shown. */
  readonly arena: Area | null;
  /** The console; `null`: it is not shown. */
  readonly console: Area | null;
  /** A part beside or above the arena that stays in sight below the card, if there is room for both; `null`: none. */
  readonly kept: Area | null;
  /** The arena has the whole room to itself. */
  readonly isAlone: boolean;
}

const GAP_PX = 8;
/** Least room for reading. Chosen by eye. */
const LEAST = { width: 280, height: 200 } as const;
/**
 * Largest width of the card beside the arena, its largest share of the width there, and its share of the height below
 * the arena. Chosen by eye.
 */
const BESIDE_PX = 420;
const BESIDE_SHARE = 0.46;
const SHEET_SHARE = 0.6;

/** The place of the card: never over the course. */
export function cardPlace({ panes, arena, console, kept, isAlone }: AroundCard): CardPlace {
  if (!isAlone && arena !== null) {
    const reaches = console !== null && console.right > arena.left && console.top >= arena.bottom;
    const beside = { ...panes, right: arena.left - GAP_PX, bottom: reaches ? arena.bottom : panes.bottom };
    const above = { ...panes, bottom: arena.top - GAP_PX };
    for (const area of [beside, above].flatMap((whole) => [endingAt(kept, whole), whole]))
      if (isRoomy(area)) return { kind: 'over', area };
  }
  const [width, height] = [panes.right - panes.left, panes.bottom - panes.top];
  if (width > height) {
    const right = panes.left + Math.min(BESIDE_PX, Math.round(BESIDE_SHARE * width));
    return { kind: 'beside', area: { ...panes, right } };
  }
  return { kind: 'sheet', area: { ...panes, top: panes.bottom - Math.round(SHEET_SHARE * height) } };
}

/** The part of an area above something that lies in it. */
const endingAt = (kept: Area | null, area: Area): Area =>
  kept === null ? area : { ...area, bottom: Math.min(area.bottom, kept.top - GAP_PX) };

const isRoomy = ({ left, top, right, bottom }: Area): boolean =>
  right - left >= LEAST.width && bottom - top >= LEAST.height;
