import { LEAST_PRESS_US } from '../run/worker/first-presses';

/** Changes of one button that wait; more are lost. Chosen: eight presses. */
const MOST_WAITING = 16;
/** Pictures that may be older than a change, counted from its message: one is in transit then. */
const OLD_PICTURES = 1;

interface Change {
  readonly down: boolean;
  readonly tell: () => void;
}

/** A button that a host has pressed during this run. */
interface Button {
  down: boolean;
  /** Pictures to come that need not know of the last change yet. */
  oldPictures: number;
  /** Simulated time of the first one that does; `null`: still to come. */
  knownUs: number | null;
  readonly waiting: Change[];
}

/**
 * Makes presses of a host last long enough for the board to notice them. A host may send down and up at once, and both
 * would fall into the same step of the world. So every change waits until the previous one is old enough, in simulated
 * time, however fast the run goes.
 */
export class SpacedPresses {
  readonly #buttons = new Map<string, Button>();

  /** Whether a change waits for its time. */
  get isWaiting(): boolean {
    return [...this.#buttons.values()].some(({ waiting }) => waiting.length > 0);
  }

  /** A button or pad goes down or up. @param tell passes it to the run, at once or when it is time */
  set(id: string, down: boolean, tell: () => void): void {
    const button = this.#buttons.get(id);
    if (button === undefined) {
      this.#buttons.set(id, { down, oldPictures: OLD_PICTURES, knownUs: null, waiting: [] });
      tell();
      return;
    }
    const last = button.waiting.at(-1) ?? button;
    if (last.down === down) return; // nothing new
    button.waiting.push({ down, tell });
    if (button.waiting.length > MOST_WAITING) button.waiting.splice(-2); // a press too many: down and up again
    if (button.knownUs === -Infinity) tellNext(button);
  }

  /** A picture of the run has come. @param nowUs its simulated time */
  advance(nowUs: number): void {
    for (const button of this.#buttons.values()) {
      if (button.oldPictures > 0) button.oldPictures -= 1;
      else button.knownUs ??= nowUs;
      if (button.knownUs === null || nowUs < button.knownUs + LEAST_PRESS_US) continue;
      button.knownUs = -Infinity;
      tellNext(button);
    }
  }

  /** No pictures come although time passes, as in a hidden page: the next change of every button is sent. */
  advanceBlindly(): void {
    for (const button of this.#buttons.values()) tellNext(button);
  }

  /** A run begins or is over: of what waits the last is done at once, and the buttons are as new. */
  settle(): void {
    const buttons = [...this.#buttons.values()];
    this.#buttons.clear();
    for (const { down, waiting } of buttons) {
      const last = waiting.at(-1);
      if (last !== undefined && last.down !== down) last.tell();
    }
  }
}

/** Tells the change that waits longest; nothing when none waits. */
function tellNext(button: Button): void {
  const next = button.waiting.shift();
  if (next === undefined) return;
  button.down = next.down;
  button.oldPictures = OLD_PICTURES;
  button.knownUs = null;
  next.tell();
}
