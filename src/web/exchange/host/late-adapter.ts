import type { Adapter, HostConnection } from '#embed/adapter';

import { fetchAgain } from './fetch-again';

/** Makes an adapter whose code is fetched when it is needed. */
export type OpenLate = (connection: HostConnection) => Promise<Adapter>;

/** Reports what a late adapter cannot do. */
export interface LateAdapterListener {
  /** Its code could not be fetched, however often it was tried. */
  onMissing(): void;
  /** This message is lost: too many wait (`busy`), or the code is missing (`broken`). */
  onLost(message: unknown, why: 'busy' | 'broken'): void;
}

/** Most messages that can wait for their adapter's code. Chosen: more than any host sends by then. */
const MOST_WAITING = 200;

/** An adapter that keeps messages until its code is there. After a failed fetch, the next message tries again. */
export function lateAdapter(open: OpenLate, connection: HostConnection, listener: LateAdapterListener): Adapter {
  const waiting: unknown[] = [];
  let adapter: Adapter | null = null;
  let isFetching = false;
  let isClosed = false;
  function fetchCode(): void {
    isFetching = true;
    fetchAgain(() => (isClosed ? Promise.reject(new Error('closed')) : open(connection))).then(
      (opened) => {
        if (isClosed) {
          opened.close();
          return;
        }
        adapter = opened;
        for (const message of waiting.splice(0)) opened.receive(message);
      },
      () => {
        isFetching = false;
        if (isClosed) return;
        for (const message of waiting.splice(0)) listener.onLost(message, 'broken');
        listener.onMissing();
      },
    );
  }
  fetchCode();
  return {
    receive(message) {
      if (isClosed) return;
      if (adapter !== null) {
        adapter.receive(message);
        return;
      }
      if (waiting.length >= MOST_WAITING) listener.onLost(message, 'busy');
      else waiting.push(message);
      if (!isFetching) fetchCode();
    },
    close() {
      isClosed = true;
      waiting.length = 0;
      adapter?.close();
    },
  };
}
