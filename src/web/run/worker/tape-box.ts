import type { InputEvent } from '#simulation/input';
import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';
import type { FromWorker } from './protocol';

/** Collects what a run shows, 50 times a second, and sends it to the page, packed. */
export class TapeBox {
  private readonly writer = new RowWriter();
  private pieces: Uint8Array[] = [];

  constructor(private readonly post: (message: FromWorker) => void) {}

  readonly moment = (snapshot: Snapshot): void => this.keep(this.writer.add(snapshot));

  /** Sends the pieces that have been filled. */
  tell(): void {
    for (const piece of this.pieces.splice(0)) this.post({ type: 'tape', piece });
  }

  /** Sends all there is, the last piece also if it is not full, and what was done to the run. */
  tellAll(inputs: readonly InputEvent[]): void {
    this.keep(this.writer.finish());
    this.tell();
    this.post({ type: 'inputs', inputs });
  }

  private keep(piece: Uint8Array | null): void {
    if (piece !== null) this.pieces.push(piece);
  }
}
