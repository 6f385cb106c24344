import type { Vec } from '#core/geometry';
import type { SurfacePress, ToolSurface } from './tool-surface';
import type { ArenaView } from '../view/use-arena-view';
import { toPx } from '../view/view-transform';

/** What a tool wants to know of a pointer's event. */
export type PointerNews = Pick<
  PointerEvent,
  | 'pointerId'
  | 'pointerType'
  | 'button'
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

/** The browser's events over the arena, led to a tool. */
export interface ToolPointers {
  pointerdown(event: PointerNews): void;
  pointermove(event: PointerNews): void;
  pointerup(event: PointerNews): void;
  pointercancel(event: PointerNews): void;
  pointerleave(): void;
  /** The space bar goes down: a pointer that is pressed meanwhile moves the picture. */
  holdSpace(): void;
  /** The space bar goes up. Returns whether it was pressed for itself. */
  letGoSpace(): boolean;
  /** Moves the picture when the crosshair would leave it. */
  keepInSight(picture: ArenaView, atMm: Vec): void;
}

/** How near to the edge of the picture the crosshair comes, in px. */
const RIM_PX = 40;

/** Makes the handlers of pointers. */
export function toolPointers(surface: ToolSurface): ToolPointers {
  let space: 'up' | 'held' | 'used' = 'up';
  return {
    pointerdown(event) {
      const host = event.currentTarget;
      if (host instanceof Element) host.setPointerCapture(event.pointerId);
      const isPanning = event.button > 0 || space !== 'up';
      if (space === 'held') space = 'used';
      const { pointerId: id, pointerType } = event;
      const kind = pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse';
      surface.pointerDown({ id, at: placeOf(event), kind, pans: isPanning, ...keysOf(event) }, event.timeStamp);
    },
    pointermove(event) {
      surface.pointerMove(event.pointerId, placesOf(event), keysOf(event));
    },
    pointerup: (event) => surface.pointerUp(event.pointerId, event.timeStamp),
    pointercancel: (event) => surface.pointerLost(event.pointerId),
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

/** Movement of the picture that keeps a place at least this far from both of its edges. */
export function pushed(at: number, side: number): number {
  if (at < RIM_PX) return Math.round(RIM_PX - at);
  if (at > side - RIM_PX) return Math.round(side - RIM_PX - at);
  return 0;
}

/** As in tldraw: Shift and Ctrl add at the press; Ctrl held while something is dragged keeps it from snapping. */
const keysOf = (event: PointerNews): Pick<SurfacePress, 'free' | 'adds'> => ({
  free: event.ctrlKey || event.metaKey,
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
