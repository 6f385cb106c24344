/** What can be pressed on the board. */
export type BoardKey = 'a' | 'b' | 'logo';

/** Who is told when a key goes down and up. */
export interface PressListener {
  press(key: BoardKey): void;
  release(key: BoardKey): void;
}

/**
 * Which keys of the board are held, by whom: fingers, the mouse and the keyboard may hold the same key at the same
 * time. A key goes down with the first that takes it and up with the last that lets go.
 */
export class Presses {
  readonly #holds = new Map<string, readonly BoardKey[]>();
  readonly #listener: PressListener;

  constructor(listener: PressListener) {
    this.#listener = listener;
  }

  /** Whether anyone holds this key. */
  isDown(key: BoardKey): boolean {
    return [...this.#holds.values()].some((keys) => keys.includes(key));
  }

  /** Someone takes these keys, instead of those it held before. */
  hold(holder: string, keys: readonly BoardKey[]): void {
    this.#change(() => this.#holds.set(holder, keys));
  }

  /** Someone lets go of what it holds. Nothing happens when it holds nothing. */
  letGo(holder: string): void {
    this.#change(() => this.#holds.delete(holder));
  }

  /** All let go: the window has lost the keyboard, or the board goes away. */
  letGoAll(): void {
    this.#change(() => this.#holds.clear());
  }

  #change(action: () => void): void {
    const keys: readonly BoardKey[] = ['a', 'b', 'logo'];
    const before = keys.filter((key) => this.isDown(key));
    action();
    for (const key of keys) {
      const down = this.isDown(key);
      if (down && !before.includes(key)) this.#listener.press(key);
      if (!down && before.includes(key)) this.#listener.release(key);
    }
  }
}
