/**
 * The program's output on its way from the worker to the main thread, in shared memory: output is available at once,
 * even if the worker never returns from what it does next. A full buffer makes the worker wait.
 */
export interface SharedConsole {
  /** Two counters of bytes, written and read since the start, modulo 2³². */
  readonly counters: Int32Array;
  readonly bytes: Uint8Array;
}

const WRITTEN = 0;
const READ = 1;

/** Size of the buffer. Chosen: 6 s of a real board's serial line; must be a power of two so that counters may wrap. */
const BYTES = 65_536;

/** The longest sleep of the worker before it checks again for room, in ms. */
const PATIENCE_MS = 100;

/** Makes an empty one; it may be sent to a worker. */
export function createSharedConsole(): SharedConsole {
  return {
    counters: new Int32Array(new SharedArrayBuffer(2 * Int32Array.BYTES_PER_ELEMENT)),
    bytes: new Uint8Array(new SharedArrayBuffer(BYTES)),
  };
}

/** The worker's side: writes text, and waits for room if necessary. */
export function createConsoleWriter({ counters, bytes }: SharedConsole): (text: string) => void {
  const encoder = new TextEncoder();
  return (text) => {
    let rest = encoder.encode(text);
    while (rest.length > 0) {
      const written = Atomics.load(counters, WRITTEN);
      const read = Atomics.load(counters, READ);
      const room = BYTES - ((written - read) >>> 0);
      if (room === 0) {
        Atomics.wait(counters, READ, read, PATIENCE_MS);
        continue;
      }
      const start = (written >>> 0) % BYTES;
      const part = rest.subarray(0, Math.min(room, BYTES - start));
      bytes.set(part, start);
      Atomics.store(counters, WRITTEN, (written + part.length) | 0);
      rest = rest.subarray(part.length);
    }
  };
}

/** The main thread's side: returns what has come since the last call, never half a character. */
export function createConsoleReader({ counters, bytes }: SharedConsole): () => string {
  const decoder = new TextDecoder();
  return () => {
    let text = '';
    for (;;) {
      const read = Atomics.load(counters, READ);
      const waiting = (Atomics.load(counters, WRITTEN) - read) >>> 0;
      if (waiting === 0) return text;
      const start = (read >>> 0) % BYTES;
      const count = Math.min(waiting, BYTES - start);
      text += decoder.decode(bytes.slice(start, start + count), { stream: true });
      Atomics.store(counters, READ, (read + count) | 0);
      Atomics.notify(counters, READ);
    }
  };
}
