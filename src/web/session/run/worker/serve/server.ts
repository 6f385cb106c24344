import type { Answer } from '#check/lane';

import type { FromServer, ToServer } from './protocol';
import { openService, Unloaded } from './services';

/** A sign of life is sent this often, in ms of wall time. */
const BEAT_MS = 200;

/** The worker's functions that a server uses. */
export interface ServerPorts {
  post(message: FromServer): void;
  nowMs(): number;
}

/** Answers the requests to one service (`services.ts`), in their order; never throws. */
export class Server {
  private service: Promise<(request: unknown) => Promise<unknown>> = Promise.reject(new Error('No service is open.'));
  private saidMs = -Infinity;
  private world = -1;

  constructor(private readonly ports: ServerPorts) {
    this.service.catch(() => undefined);
  }

  async receive(message: ToServer): Promise<void> {
    if (message.type === 'serve-open') {
      const { opening, firmware } = message;
      this.service = openService(opening, { firmware, beat: (world) => this.beat(world) });
      // Whoever asks hears of it.
      this.service.catch(() => undefined);
    } else this.ports.post({ type: 'served', answer: await this.answer(message.request) });
  }

  private async answer(request: unknown): Promise<Answer<unknown>> {
    try {
      const serve = await this.service;
      return { result: await serve(request) };
    } catch (error) {
      if (error instanceof Unloaded) return { unloaded: true };
      return { broken: error instanceof Error ? error.message : String(error) };
    }
  }

  private beat(world: number): void {
    const nowMs = this.ports.nowMs();
    if (world === this.world && nowMs - this.saidMs < BEAT_MS) return;
    [this.world, this.saidMs] = [world, nowMs];
    this.ports.post({ type: 'serve-beat', world });
  }
}
