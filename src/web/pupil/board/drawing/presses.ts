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
export interface PressListener<Key extends string = BoardKey> {
  press(key: Key): void;
  release(key: Key): void;
}

/**
 * The held keys of a thing, such as the board, and their holders: fingers, the mouse and the keyboard may hold the same key at the same
 * time. A key goes down with its first holder and up with its last. The run decides how long a press lasts for the
 * board (`InputQueue`).
 */
export class Presses<Key extends string = BoardKey> {
  private readonly holds = new Map<string, readonly Key[]>();

  constructor(private readonly listener: PressListener<Key>) {}

  /** True if any holder holds this key. */
  isDown(key: Key): boolean {
    return [...this.holds.values()].some((keys) => keys.includes(key));
  }

  /** A holder presses these keys, instead of those it held before. */
  hold(holder: string, keys: readonly Key[]): void {
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

  private down(): ReadonlySet<Key> {
    return new Set([...this.holds.values()].flat());
  }

  private change(action: () => void): void {
    const before = this.down();
    action();
    const after = this.down();
    for (const key of before) if (!after.has(key)) this.listener.release(key);
    for (const key of after) if (!before.has(key)) this.listener.press(key);
  }
}
