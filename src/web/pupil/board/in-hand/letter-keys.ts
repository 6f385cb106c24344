import type { Presses } from '../drawing/presses';

/** Handlers for a group of keys that the keyboard presses too, while the focus is in it; for `v-on`. */
export interface LetterHandlers {
  readonly keydown: (event: KeyboardEvent) => void;
  readonly keyup: (event: KeyboardEvent) => void;
  readonly focusout: (event: FocusEvent) => void;
}

/**
 * Lets letters, digits or arrows press keys.
 *
 * @param keyFor the key for what is pressed on the keyboard; `null`: none
 */
export function letterHandlers<Key extends string>(
  presses: Presses<Key>,
  keyFor: (event: KeyboardEvent) => Key | null,
): LetterHandlers {
  /** Places on the keyboard that are held: with Shift the same place says another letter when it comes up. */
  const held = new Set<string>();
  const letGo = (code: string): void => {
    held.delete(code);
    presses.letGo(`key ${code}`);
  };
  return {
    keydown(event) {
      const key = keyFor(event);
      if (key === null || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      held.add(event.code);
      presses.hold(`key ${event.code}`, [key]);
    },
    keyup: ({ code }) => letGo(code),
    focusout({ currentTarget, relatedTarget }) {
      if (currentTarget instanceof Node && relatedTarget instanceof Node && currentTarget.contains(relatedTarget))
        return;
      for (const code of [...held]) letGo(code);
    },
  };
}
