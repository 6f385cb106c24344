import { onBeforeUnmount, onMounted, shallowRef, type ShallowRef } from 'vue';
import { Presses, type BoardKey, type PressListener } from './presses';

/** Time for which a mere click, from a screen reader or a switch, holds a key, in ms. Chosen: to be seen. */
const CLICK_MS = 200;

/** Handlers for one thing that can be pressed; for `v-on`. */
export interface PressHandlers {
  pointerdown(event: PointerEvent): void;
  pointerup(event: PointerEvent): void;
  pointercancel(event: PointerEvent): void;
  lostpointercapture(event: PointerEvent): void;
  keydown(event: KeyboardEvent): void;
  keyup(event: KeyboardEvent): void;
  blur(): void;
  click(event: MouseEvent): void;
  contextmenu(event: Event): void;
}

/** Keys that are pressed by hand. */
export interface HandPresses<Key extends string> {
  readonly down: Readonly<ShallowRef<ReadonlySet<Key>>>;
  /** The handlers of something that presses these keys. */
  readonly handlersFor: (keys: readonly Key[]) => PressHandlers;
  readonly presses: Presses<Key>;
}

/** Lets fingers, mouse, keyboard and screen readers press the keys of a thing, such as the board. */
export function usePresses<Key extends string = BoardKey>(listener: PressListener<Key>): HandPresses<Key> {
  const down = shallowRef<ReadonlySet<Key>>(new Set());
  const presses = new Presses<Key>({
    press(key) {
      down.value = new Set([...down.value, key]);
      listener.press(key);
    },
    release(key) {
      down.value = new Set([...down.value].filter((other) => other !== key));
      listener.release(key);
    },
  });
  const letGoAll = (): void => presses.letGoAll();
  onMounted(() => window.addEventListener('blur', letGoAll));
  onBeforeUnmount(() => {
    window.removeEventListener('blur', letGoAll);
    presses.letGoAll();
  });
  return { down, handlersFor: (keys) => handlers(presses, keys), presses };
}

function handlers<Key extends string>(presses: Presses<Key>, keys: readonly Key[]): PressHandlers {
  const name = keys.join('+');
  const letGo = (event: PointerEvent): void => presses.letGo(`pointer ${String(event.pointerId)}`);
  const isPressKey = (event: KeyboardEvent): boolean => event.key === 'Enter' || event.key === ' ';
  return {
    pointerdown(event) {
      if (event.button !== 0) return;
      if (event.currentTarget instanceof Element) event.currentTarget.setPointerCapture(event.pointerId);
      presses.hold(`pointer ${String(event.pointerId)}`, keys);
    },
    pointerup: letGo,
    pointercancel: letGo,
    lostpointercapture: letGo,
    keydown(event) {
      if (!isPressKey(event)) return;
      event.preventDefault();
      if (!event.repeat) presses.hold(`key ${name}`, keys);
    },
    keyup(event) {
      if (!isPressKey(event)) return;
      event.preventDefault(); // else a space would click as well
      presses.letGo(`key ${name}`);
    },
    blur: () => presses.letGo(`key ${name}`),
    click(event) {
      if (event.detail !== 0) return; // a real click was a pointer before
      presses.hold(`click ${name}`, keys);
      setTimeout(() => presses.letGo(`click ${name}`), CLICK_MS);
    },
    contextmenu: (event) => event.preventDefault(), // a finger that holds a key asks for no menu
  };
}
