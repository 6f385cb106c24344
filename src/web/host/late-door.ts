import type { Door, Outside } from '#embed/door';

import { fetchAgain } from './fetch-again';

/** Opens a door whose code is fetched when it is needed. */
export type OpenLate = (outside: Outside) => Promise<Door>;

/** Whom a late door tells of what it cannot do. */
export interface LateDoorListener {
  /** Its code could not be fetched, however often it was tried. */
  onMissing(): void;
  /** Nobody will hear this message: too many wait (`busy`), or the code is missing (`broken`). */
  onLost(message: unknown, why: 'busy' | 'broken'): void;
}

/** Messages that wait for their door's code. Chosen: more than any host sends by then. */
const MOST_WAITING = 200;

/** A door that keeps what is said until its code is there. Where that could not be fetched, the next message tries anew. */
export function lateDoor(open: OpenLate, outside: Outside, listener: LateDoorListener): Door {
  const waiting: unknown[] = [];
  let door: Door | null = null;
  let isFetching = false;
  let isClosed = false;
  function fetchCode(): void {
    isFetching = true;
    fetchAgain(() => (isClosed ? Promise.reject(new Error('closed')) : open(outside))).then(
      (opened) => {
        if (isClosed) {
          opened.close();
          return;
        }
        door = opened;
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
      if (door !== null) {
        door.receive(message);
        return;
      }
      if (waiting.length >= MOST_WAITING) listener.onLost(message, 'busy');
      else waiting.push(message);
      if (!isFetching) fetchCode();
    },
    close() {
      isClosed = true;
      waiting.length = 0;
      door?.close();
    },
  };
}
