import { FlashDataError } from '@microbit/microbit-connection';
import { createUSBConnection, type MicrobitUSBConnection } from '@microbit/microbit-connection/usb';
import { shallowRef } from 'vue';

import type { RealBoard } from '../../../session/run/board/real-board';
import { BoardOutput } from '../output/board-output';
import { HexError, usbProblem, type BoardVersion, type UsbProblem } from './usb-problem';

/** Progress of the transfer. */
export interface UsbProgress {
  readonly stage: 'choosing' | 'connecting' | 'sending' | 'starting';
  /** Everything, or just what is different; `null`: not known yet. */
  readonly extent: 'full' | 'partial' | null;
  /** 0 … 1, of the sending alone. */
  readonly part: number;
}

/** The outcome of the transfer. */
export type UsbEnd =
  | { readonly kind: 'done'; readonly extent: 'full' | 'partial' | 'unchanged'; readonly version: BoardVersion }
  | { readonly kind: 'problem'; readonly problem: UsbProblem }
  /** No board was chosen. */
  | { readonly kind: 'nothing' };

const silently = { log: () => undefined, error: () => undefined, event: () => undefined };

/** A board at the browser's USB: programs are put on it, and its serial output comes back for as long as it is connected. */
export class UsbBoard implements RealBoard {
  readonly name = shallowRef('');
  readonly state = shallowRef<'connected' | 'paused' | 'gone'>('gone');
  readonly start = shallowRef(0);
  readonly count = shallowRef(0);
  private readonly text = new BoardOutput();
  private readonly connection: MicrobitUSBConnection;
  /** The transfer that goes on; it never fails. */
  private transfer: Promise<unknown> | null = null;
  private isPulled = false;
  private isStopped = false;

  /** @param onEnd is called when the page has let go of the board for good */
  constructor(
    private readonly onEnd: () => void = () => undefined,
    private readonly nowMs: () => number = () => performance.now(),
  ) {
    this.connection = createUSBConnection({ deviceSelectionMode: 'UseAnyAllowed', logging: silently });
    this.connection.addEventListener('status', ({ status }) => {
      this.state.value = status === 'Connected' ? 'connected' : status === 'Paused' ? 'paused' : 'gone';
      if (status === 'NoAuthorizedDevice') this.isPulled = true;
    });
    this.connection.addEventListener('serialdata', ({ data }) => {
      this.text.write(data, this.nowMs());
      this.start.value = this.text.start;
      this.count.value += 1;
    });
    this.connection.addEventListener('serialreset', () => this.text.end(this.nowMs()));
    void this.connection.initialize();
  }

  get output(): RealBoard['output'] {
    return this.text.all;
  }

  get outputGone(): number {
    return this.text.gone;
  }

  /**
   * Puts a program on the board and starts it; only what is different is sent where that is quicker. Called by a click:
   * the browser may ask which board is meant.
   *
   * @param hexFor makes the hex once the board's version is known; rejects with a `HexError`
   */
  async put(
    hexFor: (version: BoardVersion) => Promise<string>,
    onProgress: (progress: UsbProgress) => void,
  ): Promise<UsbEnd> {
    const transfer = this.transferred(hexFor, new Progress(onProgress));
    this.transfer = transfer;
    const end = await transfer;
    this.transfer = null;
    return end;
  }

  private async transferred(hexFor: (version: BoardVersion) => Promise<string>, progress: Progress): Promise<UsbEnd> {
    [this.isPulled, this.isStopped] = [false, false];
    let refused: HexError | null = null;
    // With any other error than this the library disconnects.
    const source = async (version: BoardVersion): Promise<string> => {
      const hex = await hexFor(version).catch((error: unknown) => {
        if (!(error instanceof HexError)) throw error;
        refused = error;
        throw new FlashDataError(error.message);
      });
      if (this.isStopped) throw new FlashDataError('Stopped.');
      return hex;
    };
    try {
      await this.connection.flash(source, { progress: (stage, part) => this.goOn(progress, stage, part) });
      this.text.end(this.nowMs());
      return { kind: 'done', extent: progress.extent(), version: this.connection.getBoardVersion() };
    } catch (error) {
      const problem = this.problemOf(refused ?? error, progress.isTouched);
      return problem === null ? { kind: 'nothing' } : { kind: 'problem', problem };
    }
  }

  /**
   * Notes a step of the transfer. One that is stopped ends here, at each of its attempts: a library that just loses its line
   * opens it again and sends everything another way.
   */
  private goOn(progress: Progress, stage: string, part: number | undefined): void {
    if (!this.isStopped) progress.note(stage, part);
    if (!this.isStopped || isLast(stage, part)) return;
    if (part !== undefined) progress.isTouched = true;
    throw new FlashDataError('Stopped.');
  }

  private problemOf(error: unknown, isTouched: boolean): UsbProblem | null {
    if (this.isStopped) return isTouched ? { kind: 'stopped' } : null;
    // Without a board the library fails in many places, with as many words.
    return this.isPulled ? { kind: 'unplugged', isTouched } : usbProblem(error);
  }

  /** Breaks a transfer off. The board stays connected. */
  stop(): void {
    this.isStopped = this.transfer !== null;
  }

  send(text: string): void {
    if (this.state.value === 'connected') this.connection.serialWrite(text).catch(() => undefined);
  }

  async disconnect(): Promise<void> {
    this.stop();
    this.onEnd();
    await this.transfer; // else its end would open the line once more
    await this.connection.disconnect();
    this.connection.dispose();
  }
}

/** True for the report at a transfer's end, after which the library puts the board in order. */
const isLast = (stage: string, part: number | undefined): boolean => stage.endsWith('Flashing') && part === undefined;

/** Follows what the library tells of a transfer. */
class Progress {
  isTouched = false;
  private kind: 'full' | 'partial' | null = null;
  private hasPages = false;

  constructor(private readonly tell: (progress: UsbProgress) => void) {}

  note(stage: string, part: number | undefined): void {
    if (stage === 'FindingDevice') this.tell({ stage: 'choosing', extent: null, part: 0 });
    else if (stage === 'Connecting') this.tell({ stage: 'connecting', extent: null, part: 0 });
    else if (stage === 'PartialFlashing' || stage === 'FullFlashing') {
      if (part === undefined) return;
      this.kind = stage === 'FullFlashing' ? 'full' : 'partial';
      if (part < 1) this.hasPages = this.isTouched = true;
      this.tell({ stage: part < 1 ? 'sending' : 'starting', extent: this.kind, part });
    }
  }

  /** The library tells the end alone if no page is different. */
  extent(): 'full' | 'partial' | 'unchanged' {
    return this.kind === 'full' || this.hasPages ? (this.kind ?? 'full') : 'unchanged';
  }
}
