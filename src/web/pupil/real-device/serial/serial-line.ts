import type { Port, Timer } from './port';
import { PutError } from './problem';

/**
 * Bytes that are sent at a time, and the pause after them: the device has no flow control and a small buffer. As
 * microfs does.
 */
const PIECE_BYTES = 32;
const PIECE_PAUSE_MS = 10;
/** How long the computer may take to send one piece. */
const WRITE_LIMIT_MS = 3000; // chosen: 32 bytes take 3 ms at 115,200 baud
/** Limit for unread output of a device that prints without end. */
const KEPT_CHARACTERS = 16_384; // chosen: far more than any expected answer

/**
 * Text over a port: sends in small pieces, and waits for expected text, with a time limit. One thing at a time: callers
 * wait for the end of a call before the next one.
 */
export class SerialLine {
  private text = '';
  private isGone = false;
  private heard = 0;
  private wake: () => void = () => undefined;

  /** @param signal ends every wait with the problem `stopped` */
  constructor(
    private readonly port: Port,
    private readonly timer: Timer,
    private readonly signal: AbortSignal,
  ) {
    signal.addEventListener('abort', () => this.wake());
    void this.listen();
  }

  /** Number of bytes received so far. */
  get heardBytes(): number {
    return this.heard;
  }

  /** Discards everything received that no call has taken yet. */
  forget(): void {
    this.text = '';
  }

  /** Takes everything received that no call has taken yet. */
  take(): string {
    const { text } = this;
    this.text = '';
    return text;
  }

  /**
   * Sends a text of ASCII characters.
   *
   * @throws PutError `interrupted`, `stuck`, `stopped`
   */
  async send(text: string): Promise<void> {
    for (let place = 0; place < text.length; place += PIECE_BYTES) {
      const piece = text.slice(place, place + PIECE_BYTES);
      await this.write(Uint8Array.from(piece, (sign) => sign.charCodeAt(0)));
      await this.pause(PIECE_PAUSE_MS);
    }
  }

  /**
   * Waits for a mark, and takes everything up to and including it.
   *
   * @returns what came before the mark, or `null` when the mark does not come in time
   * @throws PutError `interrupted`, `stopped`
   */
  async until(mark: string, limitMs: number): Promise<string | null> {
    let place = -1;
    const isThere = (): boolean => (place = this.text.indexOf(mark)) >= 0;
    if (!(await this.wait(limitMs, isThere))) return null;
    const before = this.text.slice(0, place);
    this.text = this.text.slice(place + mark.length);
    return before;
  }

  /** Waits for this many milliseconds. @throws PutError `interrupted`, `stopped` */
  async pause(ms: number): Promise<void> {
    await this.wait(ms, () => false);
  }

  private async write(bytes: Uint8Array): Promise<void> {
    let state: 'going' | 'done' | 'failed' = 'going';
    const become = (next: 'done' | 'failed') => (): void => {
      state = next;
      this.wake();
    };
    this.port.write(bytes).then(become('done'), become('failed'));
    const isOver = await this.wait(WRITE_LIMIT_MS, () => state !== 'going');
    if (!isOver) throw new PutError({ kind: 'stuck' });
    if ((state as string) === 'failed') throw new PutError({ kind: 'interrupted' });
  }

  private async wait(limitMs: number, isDone: () => boolean): Promise<boolean> {
    let isLate = false;
    const callOff = this.timer.after(limitMs, () => {
      isLate = true;
      this.wake();
    });
    try {
      for (;;) {
        if (this.signal.aborted) throw new PutError({ kind: 'stopped', isTouched: false });
        if (isDone()) return true;
        if (this.isGone) throw new PutError({ kind: 'interrupted' });
        if (isLate) return false;
        await new Promise<void>((resolve) => (this.wake = resolve));
      }
    } finally {
      callOff();
      this.wake = () => undefined;
    }
  }

  /** Collects what arrives until the line is gone. */
  private async listen(): Promise<void> {
    try {
      for (let bytes = await this.port.read(); bytes !== null; bytes = await this.port.read()) {
        this.heard += bytes.length;
        const came = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
        this.text = (this.text + came).slice(-KEPT_CHARACTERS);
        this.wake();
      }
    } catch {
      // A line that fails is as good as closed.
    }
    this.isGone = true;
    this.wake();
  }
}
