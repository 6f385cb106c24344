/** A serial line to a device: bytes both ways. */
export interface Port {
  /** Sends bytes. Fails when the cable is out. */
  write(bytes: Uint8Array): Promise<void>;
  /** The next bytes that come, in pieces of any size; `null` when none will ever come again. */
  read(): Promise<Uint8Array | null>;
  /** Lets go of the line. It never fails. */
  close(): Promise<void>;
}

/** Time that passes, so that tests can let it pass. */
export interface Timer {
  /** Calls `act` once after this many milliseconds. @returns a function that cancels it */
  after(ms: number, act: () => void): () => void;
}

/** The time of the page. */
export const pageTimer: Timer = {
  after: (ms, act) => {
    const id = setTimeout(act, ms);
    return () => clearTimeout(id);
  },
};
