/** The output of one device, without any of another one in between. */
export interface Output {
  /** Its place in the run's set-up. */
  readonly device: number;
  readonly text: string;
  /** Simulated time of its first character. */
  readonly timeUs: number;
}

/** Console output on its way to the page: bounded batches, one in transit, and a mark at which the run should wait. */
export interface Outbox {
  /** Adds the output since the last call, oldest first. */
  put(outputs: readonly Output[]): void;
  /** The page has taken the batch in transit: the next one may go. */
  taken(): void;
  /** Sends everything immediately, without waiting for the page: for the end of a run. */
  flush(): void;
  /** More is waiting than the page can take: simulated time must pause. */
  readonly isFull: boolean;
  /** Nothing is waiting. Sent output may still be in transit. */
  readonly isEmpty: boolean;
}

/** Longest batch in characters: small enough to be split into lines within a frame on a slow tablet. */
const BATCH = 32_768;
/** Number of waiting characters at which the run pauses: 10 s of a real board's serial line at 115200 baud. */
const FULL = 115_200;

/** Creates an outbox that hands its batches to `send`. */
export function createOutbox(send: (output: readonly Output[]) => void): Outbox {
  let waiting: Output[] = [];
  let length = 0;
  let underWay = false;
  function next(): void {
    if (underWay || length === 0) return;
    underWay = true;
    const batch = takeBatch(waiting);
    length -= lengthOf(batch);
    send(batch);
  }
  return {
    put(outputs) {
      for (const output of outputs) {
        append(waiting, output);
        length += output.text.length;
      }
      next();
    },
    taken() {
      underWay = false;
      next();
    },
    flush() {
      if (length > 0) send(waiting);
      waiting = [];
      length = 0;
    },
    get isFull() {
      return length >= FULL;
    },
    get isEmpty() {
      return length === 0;
    },
  };
}

/** Output of one device within this time is joined: one step of the world. Later output has its own time. */
const TOGETHER_US = 4000;

/** Adds output to a list; successive pieces of one device are joined. */
export function append(list: Output[], output: Output): void {
  const last = list.at(-1);
  if (last?.device === output.device && output.timeUs < last.timeUs + TOGETHER_US)
    list[list.length - 1] = { ...last, text: last.text + output.text };
  else list.push(output);
}

const lengthOf = (outputs: readonly Output[]): number => outputs.reduce((sum, { text }) => sum + text.length, 0);

/** Takes the first `BATCH` characters of the waiting output. */
function takeBatch(waiting: Output[]): readonly Output[] {
  const batch: Output[] = [];
  for (let room = BATCH; room > 0 && waiting[0] !== undefined;) {
    const first = waiting[0];
    batch.push({ ...first, text: first.text.slice(0, room) });
    if (first.text.length <= room) waiting.shift();
    else waiting[0] = { ...first, text: first.text.slice(room) };
    room -= first.text.length;
  }
  return batch;
}
