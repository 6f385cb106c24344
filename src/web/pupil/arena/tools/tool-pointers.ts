import type { Vec } from '#core/geometry';
import type { SurfacePress } from './gesture';
import type { ToolSurface } from './tool-surface';
import type { ArenaView } from '../view/use-arena-view';
import { toPx } from '../view/view-transform';

/** The relevant part of a pointer's event. */
export type PointerNews = Pick<
  PointerEvent,
  | 'pointerId'
  | 'pointerType'
  | 'button'
  | 'altKey'
  | 'shiftKey'
  | 'ctrlKey'
  | 'metaKey'
  | 'timeStamp'
  | 'offsetX'
  | 'offsetY'
  | 'clientX'
  | 'clientY'
  | 'currentTarget'
> &
  Partial<Pick<PointerEvent, 'getCoalescedEvents'>>;

/** Handlers that pass the browser's events over the arena to a tool. */
export interface ToolPointers {
  pointerdown(event: PointerNews): void;
  pointermove(event: PointerNews): void;
  pointerup(event: PointerNews): void;
  pointercancel(event: PointerNews): void;
  pointerleave(): void;
  /** The space bar is pressed: until its release a pressed pointer moves the picture. */
  holdSpace(): void;
  /** The space bar is released. Returns true if it was pressed on its own. */
  letGoSpace(): boolean;
  /** Moves the picture when the crosshair would leave it. */
  keepInSight(picture: ArenaView, atMm: Vec): void;
}

/** Shortest distance of the crosshair from the edge of the picture, in px. */
const RIM_PX = 40;

/** Place for which a menu is requested: on the canvas and in the window, CSS px. */
export interface MenuWish {
  readonly at: Vec;
  readonly inWindow: Vec;
}

/**
 * Makes the handlers of pointers.
 *
 * @param menu called for the right button, or for a resting finger (`rests`), which then has no other effect; returns
 * whether the menu opens
 */
export function toolPointers(surface: ToolSurface, menu: (wish: MenuWish, rests: boolean) => boolean): ToolPointers {
  let space: 'up' | 'held' | 'used' = 'up';
  const rest = new MenuPress((wish, id) => {
    if (!menu(wish, true)) return false;
    surface.pointerLost(id);
    return true;
  });
  return {
    pointerdown(event) {
      rest.down(event);
      const host = event.currentTarget;
      if (host instanceof Element) host.setPointerCapture(event.pointerId);
      const isPanning = event.button > 0 || space !== 'up';
      if (space === 'held') space = 'used';
      const { pointerId: id, pointerType } = event;
      const kind = pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse';
      surface.pointerDown({ id, at: placeOf(event), kind, pans: isPanning, ...keysOf(event) }, event.timeStamp);
    },
    pointermove(event) {
      if (!rest.move(event)) return;
      surface.pointerMove(event.pointerId, placesOf(event), keysOf(event));
    },
    pointerup(event) {
      const wish = rest.up(event);
      surface.pointerUp(event.pointerId, event.timeStamp);
      if (wish !== null) menu(wish, false);
    },
    pointercancel(event) {
      rest.cancel();
      surface.pointerLost(event.pointerId);
    },
    pointerleave: () => surface.pointerLeave(),
    holdSpace() {
      if (space === 'up') space = 'held';
    },
    letGoSpace() {
      const isOwn = space === 'held';
      space = 'up';
      return isOwn;
    },
    keepInSight(picture, atMm) {
      const { widthPx, heightPx } = picture.canvas.value;
      const at = toPx(picture.view.value, atMm);
      const by = { x: pushed(at.x, widthPx), y: pushed(at.y, heightPx) };
      if (by.x !== 0 || by.y !== 0) picture.panBy(by);
    },
  };
}

/**
 * Time for which a finger must rest to open the menu, in ms, and the distance by which it or the right button may slip,
 * in px. As for hints.
 */
const REST_MS = 500;
const SLIP_PX = 10;

/** Recognises a press that opens the menu: one finger that rests, or the right button released where it was pressed. */
class MenuPress {
  private press: { readonly id: number; readonly wish: MenuWish; readonly isRight: boolean } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The finger that has opened the menu: it has no further effect until it is lifted. */
  private spent: number | null = null;

  constructor(private readonly rests: (wish: MenuWish, id: number) => boolean) {}

  down(event: PointerNews): void {
    const isSecond = this.press !== null;
    this.cancel();
    const isTouch = event.pointerType === 'touch';
    if (isSecond || (!isTouch && event.button !== 2)) return;
    const { pointerId: id, clientX: x, clientY: y } = event;
    const press = { id, wish: { at: placeOf(event), inWindow: { x, y } }, isRight: !isTouch };
    this.press = press;
    if (isTouch) this.timer = setTimeout(() => (this.spent = this.rests(press.wish, id) ? id : null), REST_MS);
  }

  /** Returns whether the movement means anything. */
  move({ pointerId, clientX, clientY }: PointerNews): boolean {
    const from = this.press?.id === pointerId ? this.press.wish.inWindow : null;
    if (from !== null && Math.hypot(clientX - from.x, clientY - from.y) > SLIP_PX) this.cancel();
    return this.spent !== pointerId;
  }

  /** Place at which the right button requests the menu, or `null`. */
  up({ pointerId }: PointerNews): MenuWish | null {
    const press = this.press;
    this.cancel();
    return press?.isRight === true && press.id === pointerId ? press.wish : null;
  }

  cancel(): void {
    clearTimeout(this.timer);
    this.press = null;
    this.spent = null;
  }
}

/** Movement of the picture along one axis, in px, after which a place is at least `RIM_PX` from both of its edges. */
export function pushed(at: number, side: number): number {
  if (at < RIM_PX) return Math.round(RIM_PX - at);
  if (at > side - RIM_PX) return Math.round(side - RIM_PX - at);
  return 0;
}

/** As in tldraw: Shift and Ctrl add at the press; Ctrl held during a drag turns snapping off. */
const keysOf = (event: PointerNews): Pick<SurfacePress, 'free' | 'adds' | 'keeps' | 'alt'> => ({
  free: event.ctrlKey || event.metaKey,
  keeps: event.shiftKey,
  alt: event.altKey,
  adds: event.shiftKey || event.ctrlKey || event.metaKey,
});

const placeOf = (event: PointerNews): Vec => ({ x: event.offsetX, y: event.offsetY });

/** All places of an event: browsers put those since the last frame into one. */
function placesOf(event: PointerNews): readonly Vec[] {
  const last = placeOf(event);
  const merged = event.getCoalescedEvents?.() ?? [];
  if (merged.length < 2) return [last];
  // Browsers do not all report their offset, but all report their place in the window.
  return merged.map(({ clientX, clientY }) => ({
    x: last.x + clientX - event.clientX,
    y: last.y + clientY - event.clientY,
  }));
}
