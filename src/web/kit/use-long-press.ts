import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** Time for which a finger must rest before the hint shows, in ms. */
const HOLD_MS = 500;
/** Distance that it may slip meanwhile, in px. */
const SLIP_PX = 10;

/** A hint on a control, shown where a finger rests on it. */
export interface Hint {
  readonly text: string;
  /** Middle of the control, in px from the left. */
  readonly xPx: number;
  /** Lower edge of the control, in px from the top. */
  readonly yPx: number;
  /** Beside a column of tools the hint is at its right, this many px from the left; `null`: above or below. */
  readonly besidePx: number | null;
}

/** Time for which a hint stays after the finger has left, in ms. */
const LINGER_MS = 1200;

/**
 * Hints for fingers: a mouse sees a control's title when it rests on it, a finger when it is held down. The tap that
 * showed a hint does nothing else; every other tap acts at once.
 */
export function useLongPress(): Readonly<ShallowRef<Hint | null>> {
  const press = new LongPress();
  const listeners = {
    pointerdown: (event: PointerEvent) => press.start(event),
    pointermove: (event: PointerEvent) => press.move(event),
    pointerup: () => press.end(),
    pointercancel: () => press.end(),
    contextmenu: (event: Event) => press.menu(event),
    click: (event: Event) => press.click(event),
  };
  const entries = Object.entries(listeners) as [string, EventListener][];
  for (const [type, listener] of entries) addEventListener(type, listener, true);
  onScopeDispose(() => {
    for (const [type, listener] of entries) removeEventListener(type, listener, true);
  });
  return press.hint;
}

/** One finger on one control at a time. */
class LongPress {
  readonly hint = shallowRef<Hint | null>(null);
  private timer: ReturnType<typeof setTimeout> | undefined;
  private control: HTMLElement | null = null;
  private from = { x: 0, y: 0 };
  private swallowsClick = false;

  start(event: PointerEvent): void {
    clearTimeout(this.timer);
    this.hint.value = null;
    this.swallowsClick = false;
    const target = event.target instanceof Element ? event.target.closest<HTMLElement>('button[title]') : null;
    this.control = event.pointerType === 'touch' ? target : null;
    this.from = { x: event.clientX, y: event.clientY };
    if (this.control !== null) this.timer = setTimeout(() => this.show(), HOLD_MS);
  }

  move(event: PointerEvent): void {
    if (Math.hypot(event.clientX - this.from.x, event.clientY - this.from.y) > SLIP_PX) clearTimeout(this.timer);
  }

  end(): void {
    clearTimeout(this.timer);
    if (this.hint.value !== null) this.timer = setTimeout(() => (this.hint.value = null), LINGER_MS);
  }

  /** Shows the hint instead of the menu that a browser opens on a long press. */
  menu(event: Event): void {
    if (this.control === null) return;
    event.preventDefault();
    this.show();
  }

  click(event: Event): void {
    if (!this.swallowsClick) return;
    this.swallowsClick = false;
    event.preventDefault();
    event.stopPropagation();
  }

  private show(): void {
    if (this.control === null) return;
    clearTimeout(this.timer);
    const box = this.control.getBoundingClientRect();
    const column = this.control.closest('[role="toolbar"][aria-orientation="vertical"]');
    this.hint.value = {
      text: this.control.title,
      xPx: box.left + box.width / 2,
      yPx: box.bottom,
      besidePx: column?.getBoundingClientRect().right ?? null,
    };
    this.swallowsClick = true;
  }
}
