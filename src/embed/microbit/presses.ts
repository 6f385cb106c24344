/** Least simulated time between two changes of a button, in µs. Chosen: the board needs about 36 ms to count a press. */
const LEAST_US = 60_000;
/** Changes of one button that wait; more are lost. Chosen: eight presses. */
const MOST_WAITING = 16;

interface Told {
  down: boolean;
  atUs: number;
  readonly waiting: boolean[];
}

/**
 * Presses by a host, each long enough for the board to count it: a host may say down and up in one breath, or down again
 * without an up, which is another press.
 */
export class Presses {
  private readonly told = new Map<string, Told>();

  /** @param tell is told each change when its time has come */
  constructor(private readonly tell: (id: string, down: boolean) => void) {}

  /** A button is to go down or up. @param nowUs simulated time of the run */
  set(id: string, down: boolean, nowUs: number): void {
    const told = this.told.get(id) ?? { down: false, atUs: -LEAST_US, waiting: [] };
    this.told.set(id, told);
    const last = told.waiting.at(-1) ?? told.down;
    if (down && last) told.waiting.push(false);
    told.waiting.push(down);
    if (told.waiting.length > MOST_WAITING) told.waiting.splice(MOST_WAITING - 2, told.waiting.length - MOST_WAITING);
    this.advance(nowUs);
  }

  /** Simulated time has passed. */
  advance(nowUs: number): void {
    for (const [id, told] of this.told) {
      if (told.waiting.length === 0 || nowUs < told.atUs + LEAST_US) continue;
      const down = told.waiting.shift() ?? false;
      told.down = down;
      told.atUs = nowUs;
      this.tell(id, down);
    }
  }

  /** A run begins or is over: time begins anew, and what waited is done at once. */
  settle(): void {
    for (const [id, told] of this.told) {
      const last = told.waiting.pop();
      told.waiting.length = 0;
      told.atUs = -LEAST_US;
      if (last === undefined || last === told.down) continue;
      told.down = last;
      this.tell(id, last);
    }
  }
}
