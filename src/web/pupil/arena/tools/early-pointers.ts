import type { PointerNews, ToolPointers } from './tool-pointers';

/** The events of a gesture, to be replayed to a tool later. */
export type GestureEvent = 'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel';

/** Pointers that arrive before the code of the tools: the first tap works, also on a slow connection. */
export interface EarlyPointers {
  note(name: GestureEvent, event: PointerEvent): void;
  /** Passes all recorded events to the tools in their order, and forgets them. */
  replay(tools: Pick<ToolPointers, GestureEvent>): void;
  forget(): void;
}

/** Most events that are recorded: more than a minute of drawing. Later ones are dropped. */
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

/** Copies an event, whose figures change once it is over: not every browser preserves the place in its target. */
function copyOf(event: PointerEvent): PointerNews {
  const { pointerId, pointerType, button, altKey, shiftKey, ctrlKey, metaKey, timeStamp } = event;
  const { offsetX, offsetY, clientX, clientY } = event;
  const keys = { altKey, shiftKey, ctrlKey, metaKey };
  const places = { offsetX, offsetY, clientX, clientY };
  return { pointerId, pointerType, button, timeStamp, ...keys, ...places, currentTarget: null };
}
