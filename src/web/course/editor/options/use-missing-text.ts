import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import type { Vec } from '#core/geometry';

/** How far a finger may move during a tap, in px. */
const SLIP_PX = 10;
/** Within this time after a tap, mouse events are those that the browser derives from it, in ms. */
const TAP_MS = 500;
/** How long the hint stays, in ms. */
const SHOW_MS = 5000;

/** Asking for the text. */
interface MissingText {
  /** Place of the hint, in px; `null` for no hint. */
  readonly place: Readonly<ShallowRef<{ xPx: number; yPx: number } | null>>;
  readonly forget: () => void;
  /** The pointer's place in the course when it asked, world mm; `null`: it was no mouse, or the text is there. */
  readonly wanted: ShallowRef<Vec | null>;
}

/**
 * Notices taps, Enter and Space in the arena while there is no text to place: focuses the field and shows a hint.
 *
 * @param pointer place of the mouse in the course
 */
export function useMissingText(
  field: Readonly<ShallowRef<HTMLElement | null>>,
  isMissing: () => boolean,
  pointer: () => Vec | null,
): MissingText {
  const wanted = shallowRef<Vec | null>(null);
  const place = shallowRef<{ xPx: number; yPx: number } | null>(null);
  let from = { x: 0, y: 0 };
  /** The mouse's place when it was pressed. */
  let pressed: Vec | null = null;
  let askedAtMs = -Infinity;
  let timer = 0;
  const isWanted = (event: Event): boolean => isMissing() && isInArena(event);
  function forget(): void {
    clearTimeout(timer);
    place.value = null;
  }
  function ask(at: Vec | null): void {
    wanted.value = at;
    const box = field.value?.getBoundingClientRect();
    if (box === undefined) return;
    field.value?.focus({ preventScroll: true });
    place.value = { xPx: box.left, yPx: box.bottom + 6 };
    clearTimeout(timer);
    timer = window.setTimeout(forget, SHOW_MS);
  }
  const listeners = {
    pointerdown: (event: PointerEvent) => {
      from = { x: event.clientX, y: event.clientY };
      if (!isInArena(event)) return;
      wanted.value = null;
      pressed = isMouse(event) ? pointer() : null;
    },
    pointerup: (event: PointerEvent) => {
      const slip = Math.max(Math.abs(event.clientX - from.x), Math.abs(event.clientY - from.y));
      if (!event.isPrimary || event.button !== 0 || slip > SLIP_PX || !isWanted(event)) return;
      askedAtMs = event.timeStamp;
      ask(isMouse(event) ? (pointer() ?? pressed) : null);
      // A press that follows its move at once: the arena tells the place with its next picture.
      if (isMouse(event))
        requestAnimationFrame(() => {
          if (event.timeStamp === askedAtMs) wanted.value ??= pointer();
        });
    },
    // The mouse events after a tap would move the focus back into the arena.
    mousedown: (event: MouseEvent) => {
      if (event.timeStamp - askedAtMs < TAP_MS && isWanted(event)) event.preventDefault();
    },
    keydown: (event: KeyboardEvent) => {
      if ((event.key !== 'Enter' && event.key !== ' ') || !isWanted(event)) return;
      event.preventDefault();
      event.stopPropagation();
      ask(null);
    },
    resize: forget,
  };
  listenFirst(listeners);
  onScopeDispose(forget);
  return { place, forget, wanted };
}

const isMouse = ({ pointerType }: PointerEvent): boolean => pointerType === 'mouse';

const isInArena = ({ target }: Event): boolean =>
  target instanceof Element && target.closest('[role="application"]') !== null;

/** Hears these events of the window before anything else does, as long as its scope lives. */
function listenFirst(listeners: object): void {
  const entries = Object.entries(listeners) as [string, EventListener][];
  for (const [type, listener] of entries) addEventListener(type, listener, true);
  onScopeDispose(() => {
    for (const [type, listener] of entries) removeEventListener(type, listener, true);
  });
}
