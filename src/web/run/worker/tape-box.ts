import type { InputEvent } from '#simulation/input';
import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';
import type { FromWorker } from './protocol';

/** Moments in a piece after the programs' end: a second. */
const SHORT = 50;

/** Collects what a run shows, 50 times a second, and sends it to the page, packed. */
export class TapeBox {
  private readonly writer = new RowWriter();
  private pieces: Uint8Array[] = [];
  private moments = 0;
  /** The programs have ended: the next run may begin at any time, so that nothing waits for long. */
  private isOver = false;

  constructor(private readonly post: (message: FromWorker) => void) {}

  readonly moment = (snapshot: Snapshot): void => {
    this.moments += 1;
    this.keep(this.writer.add(snapshot));
    if (this.isOver && this.moments >= SHORT) this.keep(this.writer.finish());
  };

  /** The programs have ended: sends all there is, and from now on each second. Or they have begun anew. */
  setOver(isOver: boolean): void {
    this.isOver = isOver;
    if (!isOver) return;
    this.keep(this.writer.finish());
    this.tell();
  }

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
    if (piece === null) return;
    this.pieces.push(piece);
    this.moments = 0;
  }
}
