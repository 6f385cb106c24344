import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';

/** Collects what a run shows, 50 times a second, until it goes to the page, packed. */
export class TapeBox {
  private readonly writer = new RowWriter();
  private pieces: Uint8Array[] = [];

  readonly moment = (snapshot: Snapshot): void => {
    const piece = this.writer.add(snapshot);
    if (piece !== null) this.pieces.push(piece);
  };

  /** The pieces that have been filled since the last call. */
  take(): readonly Uint8Array[] {
    return this.pieces.splice(0);
  }

  /** The same, the last one also if it is not full. */
  takeAll(): readonly Uint8Array[] {
    const last = this.writer.finish();
    if (last !== null) this.pieces.push(last);
    return this.take();
  }
}
