import type { Snapshot } from '#simulation/snapshot';
import type { Chunk } from '#tape/rows/chunk';
import { Rows } from '#tape/rows/rows';
import type { Recording } from './recording';

/** Who hears of what is unpacked. */
export interface RowsHearing {
  /** Another recording is asked for than before. */
  begin?(recording: Recording): void;
  /** A piece of it is unpacked. */
  chunk?(chunk: Chunk): void;
}

/** The moments of the recording that was asked for last; each of its pieces is unpacked once, as it comes. */
export class RecordedRows {
  private recording: Recording | null = null;
  private rows: Rows<Snapshot>;
  private taken = 0;

  /** @param mostBytes above this the older moments are thinned; left out: never */
  constructor(
    private readonly hearing: RowsHearing = {},
    private readonly mostBytes?: number,
  ) {
    this.rows = new Rows<Snapshot>(mostBytes);
  }

  /** The moments of a recording as far as they have come. */
  of(recording: Recording): Rows<Snapshot> {
    if (recording !== this.recording) {
      this.recording = recording;
      this.rows = new Rows<Snapshot>(this.mostBytes);
      this.taken = 0;
      this.hearing.begin?.(recording);
    }
    for (const piece of recording.pieces.slice(this.taken)) {
      const chunk = this.rows.push(piece);
      if (chunk !== null) this.hearing.chunk?.(chunk);
    }
    this.taken = recording.pieces.length;
    return this.rows;
  }
}
