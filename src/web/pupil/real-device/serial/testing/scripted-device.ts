import type { Port, Timer } from '../port';
import { putFiles, type PutResult } from '../put-files';

/** Time that jumps to the next moment that somebody waits for. */
export class JumpingClock implements Timer {
  nowMs = 0;
  private readonly waiting = new Map<() => void, number>();

  after(ms: number, act: () => void): () => void {
    const call = (): void => act();
    this.waiting.set(call, this.nowMs + ms);
    return () => void this.waiting.delete(call);
  }

  /** @returns what the promise gives; fails when nobody waits for anything and it still is not there */
  async runTo<T>(promise: Promise<T>): Promise<T> {
    let isOver = false;
    const end = (): void => void (isOver = true);
    promise.then(end, end);
    for (;;) {
      for (let turn = 0; turn < 40 && !isOver; turn++) await Promise.resolve();
      if (isOver) return promise;
      const [first] = [...this.waiting].sort(([, a], [, b]) => a - b);
      if (first === undefined) throw new Error('It hangs: nothing will ever happen again.');
      this.nowMs = first[1];
      this.waiting.delete(first[0]);
      first[0]();
    }
  }
}

/** A device that answers each piece sent as a script wants it. */
export function scripted(answer: (sent: string) => string | null): Port {
  const queue: (Uint8Array | null)[] = [];
  let reader: ((bytes: Uint8Array | null) => void) | null = null;
  const deliver = (): void => {
    if (reader === null || queue.length === 0) return;
    const give = reader;
    reader = null;
    give(queue.shift() ?? null);
  };
  return {
    write: (bytes) => {
      const reply = answer(String.fromCharCode(...bytes));
      if (reply !== '') queue.push(reply === null ? null : Uint8Array.from(reply, (sign) => sign.charCodeAt(0)));
      deliver();
      return Promise.resolve();
    },
    read: () =>
      new Promise((resolve) => {
        reader = resolve;
        deliver();
      }),
    close: () => Promise.resolve(),
  };
}

/** A board's greeting in raw mode. */
export const BANNER = '\r\nraw REPL; CTRL-B to exit\r\n>';

function putOn(port: Port): Promise<PutResult> {
  const timer = new JumpingClock();
  const wish = {
    files: [
      { name: 'lib.py', text: 'x = 1\n'.repeat(50) },
      { name: 'main.py', text: 'import lib' },
    ],
    modules: [['microbit']],
    isKnown: () => false,
    mayReplace: () => Promise.resolve(true),
  };
  const around = { timer, signal: new AbortController().signal, onProgress: () => undefined };
  return timer.runTo(putFiles(port, wish, around));
}

/** The problem with which two files are put on a device, or another outcome. */
export const problemOf = async (port: Port): Promise<string> => {
  const result = await putOn(port);
  return result.kind === 'problem' ? result.problem.kind : result.kind;
};
