/** The keys of a board in the order in which the keyboard visits them: buttons, the logo, the touch pins. */
export const BOARD_KEYS = ['a', 'b', 'pinLogo', 'pin0', 'pin1', 'pin2', 'pin3'] as const;

/** One thing that can be pressed. Touch pads have the names of the simulation's touch actions. */
export type BoardKey = (typeof BOARD_KEYS)[number];

/** The two buttons. */
export type ButtonKey = 'a' | 'b';

/** True if this key is a button that clicks, rather than a pad that feels a finger. */
export function isButtonKey(key: BoardKey): key is ButtonKey {
  return key === 'a' || key === 'b';
}

/** Called when a key goes down and up. */
export interface PressListener {
  press(key: BoardKey): void;
  release(key: BoardKey): void;
}

/**
 * The held keys of the board and their holders: fingers, the mouse and the keyboard may hold the same key at the same
 * time. A key goes down with its first holder and up with its last. The run decides how long a press lasts for the
 * board (`InputQueue`).
 */
export class Presses {
  private readonly holds = new Map<string, readonly BoardKey[]>();

  constructor(private readonly listener: PressListener) {}

  /** True if any holder holds this key. */
  isDown(key: BoardKey): boolean {
    return [...this.holds.values()].some((keys) => keys.includes(key));
  }

  /** A holder presses these keys, instead of those it held before. */
  hold(holder: string, keys: readonly BoardKey[]): void {
    this.change(() => this.holds.set(holder, keys));
  }

  /** A holder releases all its keys. Nothing happens if it holds none. */
  letGo(holder: string): void {
    this.change(() => this.holds.delete(holder));
  }

  /** All keys are released: the window has lost the keyboard, or the board goes away. */
  letGoAll(): void {
    this.change(() => this.holds.clear());
  }

  private change(action: () => void): void {
    const before = BOARD_KEYS.filter((key) => this.isDown(key));
    action();
    for (const key of BOARD_KEYS) {
      const down = this.isDown(key);
      if (down === before.includes(key)) continue;
      if (down) this.listener.press(key);
      else this.listener.release(key);
    }
  }
}
