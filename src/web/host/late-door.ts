import type { Door, Outside } from '#embed/door';

/** Opens a door whose code is fetched when it is needed. */
export type OpenLate = (outside: Outside) => Promise<Door>;

/** Messages that wait for their door's code. Chosen: more than any host sends by then. */
const MOST_WAITING = 200;

/** A door that keeps what is said until its code is there. @param onMissing its code could not be fetched: nobody answers */
export function lateDoor(open: OpenLate, outside: Outside, onMissing: () => void): Door {
  const waiting: unknown[] = [];
  let door: Door | null = null;
  let isClosed = false;
  open(outside).then(
    (opened) => {
      if (isClosed) {
        opened.close();
        return;
      }
      door = opened;
      for (const message of waiting.splice(0)) opened.receive(message);
    },
    () => {
      isClosed = true;
      waiting.length = 0;
      onMissing();
    },
  );
  return {
    receive(message) {
      if (door !== null) door.receive(message);
      else if (!isClosed && waiting.length < MOST_WAITING) waiting.push(message);
    },
    close() {
      isClosed = true;
      waiting.length = 0;
      door?.close();
    },
  };
}
