import type { EmbeddedSimulator } from './simulator';

/** The connection with a host, and the time. */
export interface HostConnection {
  /** Sends a message to the host; plain data that can be cloned. Never throws. */
  post(message: object): void;
  /** Wall clock in ms, for rates. */
  nowMs(): number;
}

/** A protocol adapter: speaks one dialect with one host. */
export interface Adapter {
  /**
   * Takes a message of the host and never throws. It ignores what the dialect does not know. What the dialect knows but
   * cannot do is answered in its own form.
   */
  receive(message: unknown): void;
  /** Sends and receives nothing more; the page stays as it is. */
  close(): void;
}

/** Makes an adapter. If its dialect announces the page before it is asked (`ready`, `pythonReady`), it does so here. */
export type CreateAdapter = (simulator: EmbeddedSimulator, connection: HostConnection) => Adapter;
