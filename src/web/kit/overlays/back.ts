/** The page's own entries in the browser's history: the one that is shown says how many things lie open at it. */
interface Entry {
  /** Number of dialogs, sheets and menus that have an entry of their own, one upon the other. */
  readonly layers?: number;
  /** Number of entries that the page has made since the visit began. */
  readonly steps?: number;
}

/** Longest time that a way through the history may take, in ms; one that leads nowhere never reports. */
const WAY_MS = 1000;

const entry = (): Entry => (history.state ?? {}) as Entry;
const layersHere = (): number => entry().layers ?? 0;

/**
 * The browser's back button closes what lies open, on top first: each open layer has one entry in the history, and the entry goes
 * when the layer is closed otherwise. In the frame of a host there are none: the history is the host's.
 */
export class Back {
  /** Closes each open layer; the last one is on top. */
  private readonly open: (() => void)[] = [];
  private readonly waiting: (() => void)[] = [];
  private isPlanned = false;
  private way: ReturnType<typeof setTimeout> | null = null;
  private isHeard = false;

  constructor(readonly isFramed: () => boolean = () => window.parent !== window) {}

  /** Number of the page's own entries up to the one that is shown. */
  get steps(): number {
    return entry().steps ?? 0;
  }

  /** A layer has been opened. @returns how to tell that it is closed */
  add(close: () => void): () => void {
    if (this.isFramed()) return () => undefined;
    const layer = (): void => close();
    this.hear();
    this.open.push(layer);
    this.plan();
    return () => {
      const at = this.open.indexOf(layer);
      if (at === -1) return;
      this.open.splice(at, 1);
      this.plan();
    };
  }

  /** Adds an entry for something that has an address; nothing lies open at it yet. */
  push(state: object, address: string): void {
    history.pushState({ ...state, steps: this.steps + 1 }, '', address);
  }

  /** Goes back by that many entries of the page. */
  leave(steps: number): void {
    this.hear();
    this.go(-steps);
  }

  /** Does something with the history as soon as no way through it is under way. */
  whenStill(act: () => void): void {
    if (this.way === null) act();
    else this.waiting.push(act);
  }

  private hear(): void {
    if (this.isHeard) return;
    this.isHeard = true;
    addEventListener('popstate', () => this.arrive());
  }

  /** Later, all at once: a menu that makes way for a dialog leaves it its entry. */
  private plan(): void {
    if (this.isPlanned) return;
    this.isPlanned = true;
    setTimeout(() => {
      this.isPlanned = false;
      this.whenStill(() => this.settle());
    });
  }

  private settle(): void {
    const [has, wants] = [layersHere(), this.open.length];
    if (wants < has) this.go(wants - has);
    for (let layers = has + 1; layers <= wants; layers += 1)
      history.pushState({ ...entry(), layers, steps: this.steps + 1 }, '');
  }

  private go(by: number): void {
    if (this.way !== null) clearTimeout(this.way);
    this.way = setTimeout(() => this.rest(), WAY_MS);
    history.go(by);
  }

  private rest(): void {
    if (this.way !== null) clearTimeout(this.way);
    this.way = null;
    for (const act of this.waiting.splice(0)) this.whenStill(act);
  }

  private arrive(): void {
    const isOwn = this.way !== null;
    if (!isOwn) for (const close of this.open.slice(layersHere()).reverse()) close();
    this.rest();
    this.plan();
  }
}

/** The one history of the page. */
export const back = new Back();
