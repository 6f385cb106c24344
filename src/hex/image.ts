import type { Firmware, HexBoard, Region } from './firmware';
import { knownFirmware } from './known';
import { hasAppended, layoutOf, roomOf, type Layout } from './layout';
import { hasText, without } from './memory';

/** Stands in every firmware of a Calliope mini and in none of a micro:bit; their chips and numbers are the same. */
const CALLIOPE = 'Calliope mini';

/** The board that MicroPython's bytes are for. */
export function boardOf(regions: readonly Region[], isOldChip: boolean): HexBoard {
  if (hasText(regions, CALLIOPE)) return isOldChip ? 'calliope-mini-1' : 'calliope-mini-3';
  return isOldChip ? 'microbit-v1' : 'microbit-v2';
}

/** The firmware without the files beside it: its bytes are those it was delivered with. */
export function firmwareOf(regions: readonly Region[], layout: Layout): Firmware {
  const bare = without(regions, layout.runtimeEnd, layout.dataEnd);
  const clean = hasAppended(regions) ? (layoutOf(bare) ?? layout) : layout;
  return {
    board: boardOf(bare, layout.isOldChip),
    version: layout.version,
    known: knownFirmware(bare),
    regions: bare,
    roomBytes: roomOf(clean),
  };
}
