/**
 * The programs' output on its way from the worker to the main thread, in shared memory: output is available at once,
 * even if the worker never returns from what it does next. A full buffer makes the worker wait. Two bytes mark the
 * beginning of another device's output: `SWITCH` and the device's place. At the start it is the first one's.
 */
export interface SharedConsole {
  /** Two counters of bytes, written and read since the start, modulo 2³². */
  readonly counters: Int32Array;
  readonly bytes: Uint8Array;
}

/** Output of one device. */
export interface Said {
  /** Its place among the devices. */
  readonly device: number;
  readonly text: string;
}

/** No byte of a text in UTF-8. */
const SWITCH = 0xff;

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
export function createConsoleWriter({ counters, bytes }: SharedConsole): (text: string, device?: number) => void {
  const encoder = new TextEncoder();
  let speaker = 0;
  const write = (given: Uint8Array): void => {
    let rest = given;
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
  return (text, device = 0) => {
    if (device !== speaker) write(Uint8Array.of(SWITCH, device));
    speaker = device;
    write(encoder.encode(text));
  };
}

/** The main thread's side: returns the output since the last call, in its order, never half a character. */
export function createConsoleReader({ counters, bytes }: SharedConsole): () => readonly Said[] {
  const sorter = createSorter();
  return () => {
    for (;;) {
      const read = Atomics.load(counters, READ);
      const waiting = (Atomics.load(counters, WRITTEN) - read) >>> 0;
      if (waiting === 0) return sorter.take();
      const start = (read >>> 0) % BYTES;
      const count = Math.min(waiting, BYTES - start);
      sorter.add(bytes.slice(start, start + count));
      Atomics.store(counters, READ, (read + count) | 0);
      Atomics.notify(counters, READ);
    }
  };
}

/** Parts the stream of bytes by device, and decodes each device's own. */
function createSorter() {
  const decoders = new Map<number, TextDecoder>();
  let said: Said[] = [];
  let speaker = 0;
  let isSwitching = false;
  const decode = (part: Uint8Array): void => {
    const decoder = decoders.get(speaker) ?? new TextDecoder();
    decoders.set(speaker, decoder);
    const text = decoder.decode(part, { stream: true });
    if (text !== '') said.push({ device: speaker, text });
  };
  return {
    add(bytes: Uint8Array): void {
      let from = 0;
      while (from < bytes.length) {
        if (isSwitching) {
          speaker = bytes[from] ?? 0;
          isSwitching = false;
          from += 1;
          continue;
        }
        const at = bytes.indexOf(SWITCH, from);
        decode(bytes.subarray(from, at < 0 ? bytes.length : at));
        isSwitching = at >= 0;
        from = at < 0 ? bytes.length : at + 1;
      }
    },
    take(): readonly Said[] {
      const taken = said;
      said = [];
      return taken;
    },
  };
}
