/** A serial line to a device: bytes both ways. */
export interface Port {
  /** Sends bytes. Fails when the cable is unplugged. */
  write(bytes: Uint8Array): Promise<void>;
  /** The next bytes to arrive, in chunks of any size; `null` once the line has ended. */
  read(): Promise<Uint8Array | null>;
  /** Releases the line. Never fails. */
  close(): Promise<void>;
}

/** The passing of time, so that tests can control it. */
export interface Timer {
  /** Calls `act` once after this many milliseconds. @returns a function that cancels it */
  after(ms: number, act: () => void): () => void;
}

/** Real time. */
export const pageTimer: Timer = {
  after: (ms, act) => {
    const id = setTimeout(act, ms);
    return () => clearTimeout(id);
  },
};

const CLOSE_LIMIT_MS = 2000;

/** Waits for something that may fail or never end. */
export function settle(promise: Promise<unknown>, timer: Timer): Promise<void> {
  return new Promise((resolve) => {
    const callOff = timer.after(CLOSE_LIMIT_MS, resolve);
    const end = (): void => {
      callOff();
      resolve();
    };
    promise.then(end, end);
  });
}
