/** The serial line between the board and a person: bytes both ways. */
export class ConsolePort {
  private received: number[] = [];
  /** Where in `received` the first byte stands that was not taken. */
  private next = 0;

  /** @param send what the board sends goes here */
  constructor(private readonly send: (bytes: Uint8Array) => void) {}

  /** Text that a person types. */
  feed(text: string): void {
    for (const byte of new TextEncoder().encode(text)) this.received.push(byte);
  }

  /** The board sends bytes. */
  write(bytes: Uint8Array): void {
    this.send(bytes);
  }

  /** How many received bytes wait. */
  get waiting(): number {
    return this.received.length - this.next;
  }

  /** How many received bytes make up the next line with its newline; all of them when no newline came yet. */
  get lineLength(): number {
    const end = this.received.indexOf(0x0a, this.next);
    return end < 0 ? this.waiting : end + 1 - this.next;
  }

  /** Takes the next received byte, or `undefined`. */
  take(): number | undefined {
    if (this.next === this.received.length) {
      this.received = [];
      this.next = 0;
    }
    const byte = this.received[this.next];
    if (byte !== undefined) this.next++;
    return byte;
  }
}
