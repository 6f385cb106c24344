/** The serial line between the board and a person: bytes both ways. */
export class ConsolePort {
  private readonly received: number[] = [];

  /** @param send what the board sends goes here */
  constructor(private readonly send: (bytes: Uint8Array) => void) {}

  /** Text that a person types. */
  feed(text: string): void {
    this.received.push(...new TextEncoder().encode(text));
  }

  /** The board sends bytes. */
  write(bytes: Uint8Array): void {
    this.send(bytes);
  }

  /** How many received bytes wait. */
  get waiting(): number {
    return this.received.length;
  }

  /** How many received bytes make up the next line with its newline; all of them when no newline came yet. */
  get lineLength(): number {
    const end = this.received.indexOf(0x0a);
    return end < 0 ? this.received.length : end + 1;
  }

  /** Takes the next received byte, or `undefined`. */
  take(): number | undefined {
    return this.received.shift();
  }
}
