import { shallowRef } from 'vue';

import type { RealBoard } from '../../../session/run/board/real-board';
import { BoardOutput } from '../output/board-output';
import type { LentPort } from './lent-port';
import { pageTimer, settle } from './port';

/** A board whose serial line stays open after a transfer: what its program says comes back. */
export class SerialBoard implements RealBoard {
  readonly name;
  readonly state = shallowRef<'connected' | 'gone'>('connected');
  readonly start = shallowRef(0);
  readonly count = shallowRef(0);
  private readonly text = new BoardOutput();
  private readonly decoder = new TextDecoder();
  private hasStarted = false;

  /**
   * @param machine the board's name for itself
   * @param line is listened to from the start of the program on
   * @param onEnd is called when the page has let go of the board
   */
  constructor(
    machine: string,
    private readonly line: LentPort,
    private readonly onEnd: () => void,
  ) {
    this.name = shallowRef(machine.split(' with ')[0] ?? machine);
    line.handOver((bytes, atMs) => (bytes === null ? this.lose() : this.take(bytes, atMs)));
  }

  get output(): RealBoard['output'] {
    return this.text.all;
  }

  get outputGone(): number {
    return this.text.gone;
  }

  send(text: string): void {
    if (this.state.value === 'connected') this.line.write(new TextEncoder().encode(text)).catch(() => undefined);
  }

  async disconnect(): Promise<void> {
    this.lose();
    this.onEnd();
    await settle(this.line.close(), pageTimer);
  }

  private take(bytes: Uint8Array, atMs: number): void {
    if (!this.hasStarted) this.text.end(atMs);
    this.hasStarted = true;
    this.text.write(this.decoder.decode(bytes, { stream: true }), atMs);
    this.start.value = this.text.start;
    this.count.value += 1;
  }

  private lose(): void {
    this.state.value = 'gone';
  }
}
