import type { EmbeddedSimulator } from './simulator';

/** Where a door's messages go, and what time it is. */
export interface Outside {
  /** Sends a message to the host; plain data that can be cloned. Never throws. */
  post(message: object): void;
  /** Wall clock in ms, for rates. */
  nowMs(): number;
}

/** One dialect spoken with one host. */
export interface Door {
  /**
   * Takes a message of the host. Whatever it is, nothing is thrown: what the dialect does not know is ignored, what it
   * knows but cannot do is answered as the dialect says.
   */
  receive(message: unknown): void;
  /** Says no more, hears no more; the page stays as it is. */
  close(): void;
}

/** Opens a door. What a dialect says unasked when the page is ready (`ready`, `pythonReady`) is said here. */
export type OpenDoor = (simulator: EmbeddedSimulator, outside: Outside) => Door;
