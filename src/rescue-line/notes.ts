import type { Unlike } from './map';

/** What of a map is not in its course, or not as it was: the codes of the sentences in `words`. */
export type MapNoteCode = Unlike | 'drawn' | 'upstairs' | 'open';

/** A note on a map. */
export interface MapNote {
  readonly code: MapNoteCode;
  /** Values for the sentence about it. */
  readonly params: Readonly<Record<string, string | number>>;
}
