import { onScopeDispose, shallowRef } from 'vue';

/** Keys held by fingers, the mouse and the keyboard: a key goes down with its first holder and up with its last. */
export interface Holds<Key extends string> {
  readonly isDown: (key: Key) => boolean;
  /** A holder presses a key instead of the one before; `null`: it lets go. */
  readonly hold: (holder: string, key: Key | null) => void;
  /** The listeners of a button for a key: each finger counts for itself. */
  readonly on: (key: Key) => Readonly<Record<string, (event: Event) => void>>;
}

/** Makes holds; whatever is held is let go when the window loses the keyboard or the panel goes away. */
export function useHolds<Key extends string>(tell: (key: Key, isDown: boolean) => void): Holds<Key> {
  const held = shallowRef<ReadonlyMap<string, Key>>(new Map());
  const isDown = (key: Key): boolean => [...held.value.values()].includes(key);
  const hold = (holder: string, key: Key | null): void => {
    const before = held.value.get(holder);
    if (before === (key ?? undefined)) return;
    const others = [...held.value].filter(([one]) => one !== holder);
    const was = before !== undefined;
    const isNew = key !== null && !isDown(key);
    held.value = new Map(key === null ? others : [...others, [holder, key]]);
    if (was && !isDown(before)) tell(before, false);
    if (isNew) tell(key, true);
  };
  const letGoAll = (): void => [...held.value.keys()].forEach((holder) => hold(holder, null));
  addEventListener('blur', letGoAll);
  onScopeDispose(() => {
    removeEventListener('blur', letGoAll);
    letGoAll();
  });
  const finger = (event: Event): string => `finger ${event instanceof PointerEvent ? event.pointerId : 0}`;
  const isPress = (event: Event): boolean =>
    event instanceof KeyboardEvent && (event.key === ' ' || event.key === 'Enter');
  const on: Holds<Key>['on'] = (key) => ({
    pointerdown: (event) => {
      if (event instanceof PointerEvent && event.button === 0) hold(finger(event), key);
    },
    pointerup: (event) => hold(finger(event), null),
    pointercancel: (event) => hold(finger(event), null),
    pointerleave: (event) => hold(finger(event), null),
    keydown: (event) => {
      if (!isPress(event)) return;
      event.preventDefault();
      hold(`button ${key}`, key);
    },
    keyup: (event) => isPress(event) && hold(`button ${key}`, null),
    blur: () => hold(`button ${key}`, null),
    contextmenu: (event) => event.preventDefault(),
  });
  return { isDown, hold, on };
}
