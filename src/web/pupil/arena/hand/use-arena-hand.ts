import { onBeforeUnmount, shallowRef, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import type { PlacedBlock } from '../model/arena-model';
import type { PlacedPose } from '#simulation/input';
import { createLateHand, type LateHand } from './late-hand';
import type { HeldThing } from './held-thing';
import type { RobotShape } from './hit-test';
import type { ArenaView } from '../view/use-arena-view';
import type { ArenaSize } from '../view/view-transform';
import { wheelGesture, wheelPx } from '../view/wheel-gesture';

/** The surroundings of the hand. */
export interface HandPlace {
  readonly picture: ArenaView;
  readonly arena: () => ArenaSize;
  /** Shows the whole arena and everything outside of it. */
  readonly showAll: () => void;
  readonly robot: () => RobotShape | null;
  readonly blocks: () => readonly PlacedBlock[];
  readonly place: (thing: HeldThing, pose: PlacedPose) => void;
  /** True if nothing may be taken. */
  readonly refuses?: (() => boolean) | undefined;
  readonly redraw: () => void;
}

/** The hand, and the handlers that pass the browser's events to it. */
export interface ArenaHand {
  readonly hand: LateHand;
  readonly cursor: Readonly<ShallowRef<string>>;
  /** Zooms by keyboard. Returns whether the key was one of its keys. */
  readonly zoomKey: (event: ZoomKey) => boolean;
  readonly on: {
    pointerdown(event: PointerEvent): void;
    pointermove(event: PointerEvent): void;
    pointerup(event: PointerEvent): void;
    pointercancel(event: PointerEvent): void;
    lostpointercapture(event: PointerEvent): void;
    pointerleave(): void;
    wheel(event: WheelEvent): void;
    keydown(event: KeyboardEvent): void;
    keyup(event: KeyboardEvent): void;
    focus(event: FocusEvent): void;
    blur(): void;
  };
}

/** Connects pointers, wheel and keys to the arena. */
export function useArenaHand(where: HandPlace): ArenaHand {
  const cursor = shallowRef('default');
  const { picture } = where;
  let frame: number | null = null;
  const follow = (): void => {
    frame = null;
    hand.tick();
    if (hand.held !== null) frame = requestAnimationFrame(follow);
  };
  const hand = createLateHand({
    view: () => picture.view.value,
    arena: where.arena,
    robot: where.robot,
    blocks: where.blocks,
    place: where.place,
    refuses: () => where.refuses?.() === true,
    pan: (byPx) => picture.panBy(byPx),
    zoom: (factor, aroundPx) => picture.zoomBy(factor, aroundPx),
    changed: () => {
      cursor.value = hand.cursor;
      if (hand.held !== null) frame ??= requestAnimationFrame(follow);
      where.redraw();
    },
    nowMs: () => performance.now(),
  });
  onBeforeUnmount(() => {
    if (frame !== null) cancelAnimationFrame(frame);
  });
  return {
    hand,
    cursor,
    zoomKey: (event) => zoomKey(event, where),
    on: {
      ...pointerHandlers(hand),
      wheel: (event) => onWheel(event, hand, picture),
      keydown: (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (zoomKey(event, where) || hand.keyDown(event.key, event.shiftKey)) event.preventDefault();
      },
      keyup: () => hand.keyUp(),
      focus(event) {
        if (event.target instanceof Element && event.target.matches(':focus-visible')) hand.focus(true);
      },
      blur: () => hand.focus(false),
    },
  };
}

function pointerHandlers(
  hand: LateHand,
): Pick<
  ArenaHand['on'],
  'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel' | 'lostpointercapture' | 'pointerleave'
> {
  const up = (event: PointerEvent): void => hand.pointerUp(event.pointerId);
  return {
    pointerdown(event) {
      if (event.button > 1) return;
      if (event.currentTarget instanceof Element) event.currentTarget.setPointerCapture(event.pointerId);
      const touch = event.pointerType === 'touch';
      hand.pointerDown({ id: event.pointerId, at: placeOf(event), touch, pansOnly: event.button === 1 });
    },
    pointermove: (event) => hand.pointerMove(event.pointerId, placeOf(event), event.shiftKey),
    pointerup: up,
    pointercancel: up,
    lostpointercapture: up,
    pointerleave: () => hand.pointerLeave(),
  };
}

/** The wheel turns the thing in the hand; otherwise it zooms and moves the picture. */
function onWheel(event: WheelEvent, hand: LateHand, picture: ArenaView): void {
  event.preventDefault();
  if (hand.held !== null) {
    hand.wheel(wheelPx(event.deltaY, event.deltaMode));
    return;
  }
  const gesture = wheelGesture(event);
  if (gesture.type === 'zoom') picture.zoomBy(gesture.factor, placeOf(event));
  else picture.panBy(gesture.byPx);
}

/**
 * The relevant part of a key's event. Shift+1 is another character on each keyboard, and a plus on some, which zooms
 * in.
 */
export type ZoomKey = Pick<KeyboardEvent, 'key' | 'code' | 'shiftKey'>;

function zoomKey(
  { key, code, shiftKey }: ZoomKey,
  { picture, showAll }: Pick<HandPlace, 'picture' | 'showAll'>,
): boolean {
  if (key === '+' || key === '=') picture.zoomBy(ZOOM_STEP);
  else if (key === '-') picture.zoomBy(1 / ZOOM_STEP);
  else if (key === '0' || (shiftKey && code === 'Digit1')) showAll();
  else return false;
  return true;
}

/** Factor of the zoom for one press of a button or key. */
export const ZOOM_STEP = 1.25;

function placeOf(event: MouseEvent): Vec {
  return { x: event.offsetX, y: event.offsetY };
}
