const CTRL_C = 3;

/** The serial line between the board and a person: bytes both ways. */
export class ConsolePort {
  /** The byte that interrupts the program instead of being received; `null` for none. */
  interruptByte: number | null = CTRL_C;
  /** Called when that byte comes. */
  onInterrupt: () => void = () => undefined;
  /** True while a program waits in `input()` for a line. */
  awaitsLine = false;
  private line: number[] = [];
  /** Index in `line` of the first byte that was not taken. */
  private next = 0;
  private count = 0;

  /** @param send receives what the board sends */
  constructor(private readonly send: (bytes: Uint8Array) => void) {}

  /** Text that a person types. */
  feed(text: string): void {
    for (const byte of new TextEncoder().encode(text)) {
      if (byte === this.interruptByte) {
        this.onInterrupt();
      } else {
        this.line.push(byte);
        this.count++;
      }
    }
  }

  /** The board sends bytes. */
  write(bytes: Uint8Array): void {
    this.send(bytes);
  }

  /** How many bytes have been received since the start, taken or not. */
  get received(): number {
    return this.count;
  }

  /** How many received bytes wait. */
  get waiting(): number {
    return this.line.length - this.next;
  }

  /** How many received bytes make up the next line with its newline; all of them when no newline came yet. */
  get lineLength(): number {
    const end = this.line.indexOf(0x0a, this.next);
    return end < 0 ? this.waiting : end + 1 - this.next;
  }

  /** Takes the next received byte, or `undefined`. */
  take(): number | undefined {
    if (this.next === this.line.length) {
      this.line = [];
      this.next = 0;
    }
    const byte = this.line[this.next];
    if (byte !== undefined) this.next++;
    return byte;
  }

  /** Makes Ctrl-C interrupt again as main.py begins, whatever an earlier program or the REPL has set. */
  watchForInterrupt(): void {
    this.interruptByte = CTRL_C;
    this.awaitsLine = false;
  }

  /** Drops the bytes that were not taken, as a reset does. */
  reset(): void {
    this.line = [];
    this.next = 0;
  }
}
