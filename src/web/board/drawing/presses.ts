/** What can be pressed on a board, in the order in which the keyboard visits it: buttons, the logo, the touch pins. */
export const BOARD_KEYS = ['a', 'b', 'pinLogo', 'pin0', 'pin1', 'pin2', 'pin3'] as const;

/** One thing that can be pressed. Touch pads have the names of the simulation's touch actions. */
export type BoardKey = (typeof BOARD_KEYS)[number];

/** The two buttons. */
export type ButtonKey = 'a' | 'b';

/** Whether this key is a button that clicks, rather than a pad that feels a finger. */
export function isButtonKey(key: BoardKey): key is ButtonKey {
  return key === 'a' || key === 'b';
}

/** Called when a key goes down and up. */
export interface PressListener {
  press(key: BoardKey): void;
  release(key: BoardKey): void;
}

/** Least time that a key stays down, in ms. Chosen: the board needs about 36 ms to count a press, a quick tap is shorter. */
export const LEAST_DOWN_MS = 100;

/** Least time that a key stays up before it goes down again, in ms. Chosen: enough to count as let go. */
export const LEAST_UP_MS = 60;

/** Changes of one key that wait for their time; more taps than that are lost. Chosen: two taps. */
const MOST_WAITING = 4;

/** One key in the listener's view, and its next event. */
interface Told {
  down: boolean;
  /** The states to come, one after the other. */
  readonly waiting: boolean[];
  /** Runs while the key may not change yet. */
  timer: ReturnType<typeof setTimeout> | null;
}

/**
 * The held keys of the board and their holders: fingers, the mouse and the keyboard may hold the same key at the same
 * time. A key goes down with its first holder and up with its last. The listener gets presses that are long enough for
 * the board: a quick tap lasts `LEAST_DOWN_MS`.
 */
export class Presses {
  readonly #holds = new Map<string, readonly BoardKey[]>();
  readonly #told = new Map<BoardKey, Told>();
  readonly #listener: PressListener;
  readonly #slowness: () => number;

  /** @param slowness how many times longer than at full speed a press has to last, 1 or more */
  constructor(listener: PressListener, slowness: () => number = () => 1) {
    this.#listener = listener;
    this.#slowness = slowness;
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

  /** All holders let go at once, however short the press was: there is no listener from now on. */
  end(): void {
    this.#holds.clear();
    for (const [key, told] of this.#told) {
      if (told.timer !== null) clearTimeout(told.timer);
      if (told.down) this.#listener.release(key);
    }
    this.#told.clear();
  }

  #change(action: () => void): void {
    const before = BOARD_KEYS.filter((key) => this.isDown(key));
    action();
    for (const key of BOARD_KEYS) {
      const down = this.isDown(key);
      if (down !== before.includes(key)) this.#tell(key, down);
    }
  }

  #tell(key: BoardKey, down: boolean): void {
    const told = this.#told.get(key) ?? { down: false, waiting: [], timer: null };
    this.#told.set(key, told);
    told.waiting.push(down);
    if (told.waiting.length > MOST_WAITING) told.waiting.splice(-2); // a tap too many: down and up again
    if (told.timer === null) this.#next(key, told);
  }

  #next(key: BoardKey, told: Told): void {
    told.timer = null;
    const down = told.waiting.shift();
    if (down === undefined) return;
    told.down = down;
    const leastMs = (down ? LEAST_DOWN_MS : LEAST_UP_MS) * Math.max(1, this.#slowness());
    told.timer = setTimeout(() => this.#next(key, told), leastMs);
    if (down) this.#listener.press(key);
    else this.#listener.release(key);
  }
}
