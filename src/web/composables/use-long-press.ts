import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** How long a finger must rest before the hint shows, in ms. */
const HOLD_MS = 500;
/** How far it may slip meanwhile, in px. */
const SLIP_PX = 10;

/** What a control is for, shown where a finger rests on it. */
export interface Hint {
  readonly text: string;
  /** Middle of the control, in px from the left. */
  readonly xPx: number;
  /** Lower edge of the control, in px from the top. */
  readonly yPx: number;
}

/**
 * Hints for fingers: a mouse sees a control's title when it rests on it, a finger when it is held down. The tap that
 * showed a hint does nothing else; every other tap acts at once.
 */
export function useLongPress(): Readonly<ShallowRef<Hint | null>> {
  const hint = shallowRef<Hint | null>(null);
  let timer: ReturnType<typeof setTimeout> | undefined;
  let start = { x: 0, y: 0 };
  let swallow = false;

  const listeners: { [type: string]: (event: PointerEvent) => void } = {
    pointerdown(event) {
      clearTimeout(timer);
      hint.value = null;
      swallow = false;
      const control = event.target instanceof Element ? event.target.closest<HTMLElement>('button[title]') : null;
      if (event.pointerType !== 'touch' || control === null) return;
      start = { x: event.clientX, y: event.clientY };
      timer = setTimeout(() => {
        const box = control.getBoundingClientRect();
        hint.value = { text: control.title, xPx: box.left + box.width / 2, yPx: box.bottom };
        swallow = true;
      }, HOLD_MS);
    },
    pointermove(event) {
      if (Math.hypot(event.clientX - start.x, event.clientY - start.y) > SLIP_PX) clearTimeout(timer);
    },
    pointerup() {
      clearTimeout(timer);
      setTimeout(() => (hint.value = null), 1200);
    },
    pointercancel() {
      clearTimeout(timer);
      hint.value = null;
    },
    click(event) {
      if (!swallow) return;
      swallow = false;
      event.preventDefault();
      event.stopPropagation();
    },
  };
  for (const [type, listener] of Object.entries(listeners)) addEventListener(type, listener as EventListener, true);
  onScopeDispose(() => {
    for (const [type, listener] of Object.entries(listeners))
      removeEventListener(type, listener as EventListener, true);
  });
  return hint;
}
