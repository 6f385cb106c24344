/** Console output on its way to the page: bounded batches, one in transit, and a mark at which the run should wait. */
export interface Outbox {
  put(text: string): void;
  /** The page has taken the batch in transit: the next one may go. */
  taken(): void;
  /** Sends everything at once, without waiting for the page: for the end of a run. */
  flush(): void;
  /** More is waiting than the page can take: simulated time must stand still. */
  readonly isFull: boolean;
  /** Nothing is waiting. What has been sent may still be on its way. */
  readonly isEmpty: boolean;
}

/** Longest batch in characters: small enough to be split into lines within a frame on a slow tablet. */
const BATCH = 32_768;
/** Number of waiting characters at which the run pauses: 10 s of a real board's serial line at 115200 baud. */
const FULL = 115_200;

/** Creates an outbox that hands its batches to `send`. */
export function createOutbox(send: (text: string) => void): Outbox {
  let waiting = '';
  let underWay = false;
  function next(): void {
    if (underWay || waiting === '') return;
    underWay = true;
    const batch = waiting.slice(0, BATCH);
    waiting = waiting.slice(BATCH);
    send(batch);
  }
  return {
    put(text) {
      waiting += text;
      next();
    },
    taken() {
      underWay = false;
      next();
    },
    flush() {
      if (waiting !== '') send(waiting);
      waiting = '';
    },
    get isFull() {
      return waiting.length >= FULL;
    },
    get isEmpty() {
      return waiting === '';
    },
  };
}
