import { shallowRef, triggerRef, watch, type ShallowRef } from 'vue';

import { emptyTape, unpackTape, type RunTape } from '../../../session/run/unpack-tape';

/** A tape that is being unpacked. */
export interface GhostTape extends RunTape {
  /** True once all of it is unpacked. */
  isWhole: boolean;
}

/** The unpacked part of a tape with these pieces; triggers as more is unpacked. */
export function useGhostTape(
  pieces: () => readonly Uint8Array[],
  devices: () => number,
): Readonly<ShallowRef<GhostTape>> {
  const empty = (): GhostTape => ({ ...emptyTape(), isWhole: false });
  const tape = shallowRef(empty());
  watch(
    pieces,
    (all) => {
      const mine = (tape.value = empty());
      void unpackTape(all, {
        into: mine,
        devices,
        isWanted: () => tape.value === mine,
        onSome: () => triggerRef(tape),
      }).then((isWhole) => {
        if (!isWhole) return;
        mine.isWhole = true;
        triggerRef(tape);
      });
    },
    { immediate: true },
  );
  return tape;
}
