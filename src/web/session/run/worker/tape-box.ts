import type { InputEvent } from '#simulation/input';
import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';
import type { FromWorker } from './protocol';

/** Moments in a piece after the programs' end: a second. */
const SHORT = 50;
/** Time between two moments of a thin stretch, in µs. Chosen: a moment costs as much as 30 ms of a simple run, so 1.5 %. */
const THIN_US = 2_000_000;
/** Moments in a piece of a thin stretch. Chosen: it is sent to the page every third of a second or so. */
const THIN_MOMENTS = 15;

/** The part of the run that is read when all of its tape is wanted. */
interface TapedRun {
  readonly nowUs: number;
  readonly inputLog: readonly InputEvent[];
  snapshot(): Snapshot;
}

/**
 * Collects the pictures of a run, 50 times a second, and sends them to the page, packed. While the run goes as fast as
 * possible, that would take longer than the run itself: then it collects one moment in two seconds. The page obtains
 * the others on demand, by running the run again.
 */
export class TapeBox {
  private writer = new RowWriter();
  private pieces: Extract<FromWorker, { type: 'tape' }>[] = [];
  private moments = 0;
  /** Time of the last moment that was collected. */
  private lastUs = -1;
  /** The last moment before the thin stretch; `null`: all are collected. */
  private thinSinceUs: number | null = null;
  private wasThin = false;
  /** The programs have ended: the next run may begin at any time, so that nothing waits for long. */
  private isOver = false;

  constructor(private readonly post: (message: FromWorker) => void) {}

  readonly isMomentWanted = (timeUs: number): boolean =>
    this.thinSinceUs === null || this.lastUs < 0 || timeUs - this.lastUs >= THIN_US;

  readonly moment = (snapshot: Snapshot): void => {
    this.moments += 1;
    this.lastUs = snapshot.timeUs;
    this.keep(this.writer.add(snapshot));
    const most = this.thinSinceUs !== null ? THIN_MOMENTS : this.isOver ? SHORT : Infinity;
    if (this.moments >= most) this.keep(this.writer.finish());
  };

  /** Notes whether the run goes as fast as possible. */
  setThin(isThin: boolean): void {
    if (isThin === (this.thinSinceUs !== null)) return;
    this.keep(this.writer.finish());
    this.thinSinceUs = isThin ? this.lastUs : null;
    this.wasThin ||= isThin;
  }

  /** The programs have ended: sends everything, and from now on each second. Or they have restarted. */
  setOver(isOver: boolean, run: TapedRun): void {
    this.isOver = isOver;
    if (isOver) this.tellAll(run);
  }

  /** Sends the pieces that have been filled. */
  tell(): void {
    for (const piece of this.pieces.splice(0)) this.post(piece);
  }

  /** Sends everything, also the last piece if it is not full, and the inputs to the run. */
  tellAll(run: TapedRun): void {
    // Also at the current time: the next missing moments are those from here on.
    if (this.wasThin && run.nowUs > this.lastUs) this.moment(run.snapshot());
    this.keep(this.writer.finish());
    this.tell();
    this.post({ type: 'inputs', inputs: [...run.inputLog], nowUs: run.nowUs });
    if (!this.wasThin) return;
    // The page may replace the pieces so far: those to follow must not depend on them.
    this.writer = new RowWriter();
    if (this.thinSinceUs !== null) this.thinSinceUs = this.lastUs;
  }

  private keep(piece: Uint8Array | null): void {
    if (piece === null) return;
    this.pieces.push({ type: 'tape', piece, thinSinceUs: this.thinSinceUs });
    this.moments = 0;
  }
}
