import { shallowRef, triggerRef, watch, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import { Trails } from '../../run/trails';
import { unpackTape } from '../../run/unpack-tape';
import { addWays } from '../../run/ways-of-tape';

/** A tape that is being unpacked. */
export interface GhostTape {
  readonly rows: Rows<Snapshot>;
  /** The ways of its robots, by the place of their device. */
  readonly trails: Trails;
  /** All of it is there. */
  isWhole: boolean;
}

/** The tape whose pieces these are, as far as it is unpacked; it triggers as more comes. */
export function useGhostTape(
  pieces: () => readonly Uint8Array[],
  devices: () => number,
): Readonly<ShallowRef<GhostTape>> {
  const empty = (): GhostTape => ({ rows: new Rows<Snapshot>(), trails: new Trails(), isWhole: false });
  const tape = shallowRef(empty());
  watch(
    pieces,
    (all) => {
      const mine = (tape.value = empty());
      void unpackTape(all, {
        rows: mine.rows,
        isWanted: () => tape.value === mine,
        onChunk: (chunk) => addWays(chunk, devices(), mine.trails),
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
