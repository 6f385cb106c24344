import type { Port } from './port';

/** Takes what comes over a line; `null`: the line is gone. */
export type Taker = (bytes: Uint8Array | null, atMs: number) => void;

/** The last words of MicroPython before main.py starts. */
const REBOOTED = 'soft reboot\r\n';

/** A line that a transfer borrows: whatever comes afterwards goes to somebody else. */
export class LentPort implements Port {
  private readonly came: { readonly bytes: Uint8Array; readonly atMs: number }[] = [];
  private taker: Taker | null = null;

  constructor(
    private readonly port: Port,
    private readonly nowMs: () => number,
  ) {}

  write(bytes: Uint8Array): Promise<void> {
    return this.port.write(bytes);
  }

  async read(): Promise<Uint8Array | null> {
    for (;;) {
      const bytes = await this.port.read();
      if (this.taker === null) {
        if (bytes !== null) this.came.push({ bytes, atMs: this.nowMs() });
        return bytes;
      }
      this.taker(bytes, this.nowMs());
      if (bytes === null) return null;
    }
  }

  close(): Promise<void> {
    return this.port.close();
  }

  /** Hands over everything since the program's start, and what comes from now on; the first piece may be empty. */
  handOver(taker: Taker): void {
    const all = this.came.map(({ bytes }) => String.fromCharCode(...bytes)).join('');
    const rebooted = all.lastIndexOf(REBOOTED);
    const start = rebooted < 0 ? all.length : rebooted + REBOOTED.length;
    let at = 0;
    for (const { bytes, atMs } of this.came) {
      at += bytes.length;
      if (at >= start) taker(bytes.subarray(Math.max(0, bytes.length - (at - start))), atMs);
    }
    this.came.length = 0;
    this.taker = taker;
  }
}
