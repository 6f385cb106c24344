import type { Unlike } from './map';

/** The codes of what of a map is not in its course, or not as it was: each has a sentence in `words`. */
export type MapNoteCode = Unlike | 'drawn' | 'upstairs' | 'open';

/** A note on a map. */
export interface MapNote {
  readonly code: MapNoteCode;
  /** Values for the sentence about it. */
  readonly params: Readonly<Record<string, string | number>>;
}
