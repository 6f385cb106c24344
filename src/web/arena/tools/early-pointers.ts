import type { PointerNews, ToolPointers } from './tool-pointers';

/** The events of a gesture, to be replayed to a tool later. */
export type GestureEvent = 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel';

/** Pointers that came before the code of the tools: the first tap acts, also on a slow line. */
export interface EarlyPointers {
  note(name: GestureEvent, event: PointerEvent): void;
  /** Tells the tools everything in its order, and forgets it. */
  replay(tools: Pick<ToolPointers, GestureEvent>): void;
  forget(): void;
}

/** More than a minute of drawing; what comes after is dropped. */
const MOST = 10_000;

export function createEarlyPointers(): EarlyPointers {
  let noted: { readonly name: GestureEvent; readonly news: PointerNews }[] = [];
  return {
    note(name, event) {
      const isGesture = noted.length > 0 || name === 'pointerdown'; // hovering is not a gesture
      if (!isGesture || noted.length >= MOST) return;
      noted.push({ name, news: copyOf(event) });
    },
    replay(tools) {
      const all = noted;
      noted = [];
      for (const { name, news } of all) tools[name](news);
    },
    forget() {
      noted = [];
    },
  };
}

/** An event's own figures change when it is over: the place in its target is not kept everywhere. */
function copyOf(event: PointerEvent): PointerNews {
  const { pointerId, pointerType, button, altKey, shiftKey, ctrlKey, metaKey, timeStamp } = event;
  const { offsetX, offsetY, clientX, clientY } = event;
  const keys = { altKey, shiftKey, ctrlKey, metaKey };
  const places = { offsetX, offsetY, clientX, clientY };
  return { pointerId, pointerType, button, timeStamp, ...keys, ...places, currentTarget: null };
}
