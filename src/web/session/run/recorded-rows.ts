import type { Snapshot } from '#simulation/snapshot';
import type { Chunk } from '#tape/rows/chunk';
import { Rows } from '#tape/rows/rows';
import type { Recording } from './recording';

/** Receives the unpacked moments. */
export interface RowsHearing {
  /** Called when another recording is requested than before, or its pieces have been replaced. */
  begin?(recording: Recording): void;
  /** Called for each piece as it is unpacked. */
  chunk?(chunk: Chunk): void;
}

/** The moments of the recording requested last; each of its pieces is unpacked once, as it arrives. */
export class RecordedRows {
  private pieces: Recording['pieces'] | null = null;
  private rows = new Rows<Snapshot>();
  private taken = 0;

  constructor(private readonly hearing: RowsHearing = {}) {}

  /** The moments of a recording that have arrived so far. */
  of(recording: Recording): Rows<Snapshot> {
    if (recording.pieces !== this.pieces) {
      this.pieces = recording.pieces;
      this.rows = new Rows<Snapshot>();
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
