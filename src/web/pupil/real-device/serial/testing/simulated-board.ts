import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Port, Timer } from '../port';

const STEP_US = 5000;

/** A simulated board with a cable: its serial line as a port, and its own time for waiting code. */
export interface SimulatedBoard {
  readonly port: Port;
  readonly timer: Timer;
  /** Everything it has sent since it was switched on. */
  console(): string;
  /** Sends it a text and lets this many simulated milliseconds pass. @returns what it sent in that time */
  type(text: string, ms?: number): string;
  /** Total time spent waiting, in simulated time. */
  waitedMs(): number;
  /** Pulls the cable. */
  unplug(): void;
}

/** The initial state of a board. */
export interface BoardStart {
  readonly files: Readonly<Record<string, string>>;
  readonly board: string;
  readonly robot?: string;
  /** The VM, compiled. */
  readonly firmware: WebAssembly.Module;
}

/** Switches a board on. Its time passes while code waits for it, as fast as it can. */
export async function simulatedBoard({ files, board, robot = 'none', firmware }: BoardStart): Promise<SimulatedBoard> {
  const setup = { scene: defaultScene(), files, robot, board, seed: 1, reality: 0, repl: 'at-once' } as const;
  let sent = '';
  let taken = 0;
  const simulation = await Simulation.create(soloRun(setup), firmware, { print: (text) => (sent += text) });
  const clock = new WaitingClock();
  let reader: ((bytes: Uint8Array | null) => void) | null = null;
  let isOut = false;
  const deliver = (): void => {
    if (reader === null || (!isOut && taken === sent.length)) return;
    const give = reader;
    reader = null;
    const text = sent.slice(taken);
    taken = sent.length;
    give(isOut ? null : new TextEncoder().encode(text));
  };
  const step = (): void => {
    simulation.advanceTo(simulation.nowUs + STEP_US);
    deliver();
  };
  clock.onStep = step;
  return {
    timer: clock,
    port: {
      write: (bytes) => {
        if (isOut) return Promise.reject(new Error('The device has been lost.'));
        simulation.input({ type: 'serial', text: new TextDecoder().decode(bytes) });
        return Promise.resolve();
      },
      read: () =>
        new Promise((resolve) => {
          reader = resolve;
          deliver();
        }),
      close: () => {
        reader?.(null);
        reader = null;
        return Promise.resolve();
      },
    },
    console: () => sent,
    waitedMs: () => clock.nowMs,
    type: (text, ms = 1000) => {
      const before = sent.length;
      simulation.input({ type: 'serial', text });
      for (let us = 0; us < ms * 1000; us += STEP_US) step();
      return sent.slice(before);
    },
    unplug: () => {
      isOut = true;
      deliver();
    },
  };
}

/** Time that advances in steps of 5 ms, and only while code waits for it. */
export class WaitingClock implements Timer {
  onStep: () => void = () => undefined;
  private readonly waiting = new Map<() => void, number>();
  nowMs = 0;
  private isTurning = false;

  after(ms: number, act: () => void): () => void {
    const call = (): void => act();
    this.waiting.set(call, this.nowMs + ms);
    this.turn();
    return () => void this.waiting.delete(call);
  }

  /** A turn of the event loop for each step: what was woken by the last one has been done by then. */
  private turn(): void {
    if (this.isTurning) return;
    this.isTurning = true;
    nextTurn(() => {
      this.isTurning = false;
      if (this.waiting.size === 0) return;
      this.nowMs += STEP_US / 1000;
      this.onStep();
      for (const [call, atMs] of [...this.waiting]) {
        if (atMs > this.nowMs) continue;
        this.waiting.delete(call);
        call();
      }
      this.turn();
    });
  }
}

/** Exists in browsers and in Node, and lacks the delay of timers. */
function nextTurn(act: () => void): void {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    port1.close();
    act();
  };
  port2.postMessage(null);
}
