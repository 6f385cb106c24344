import { describe, expect, it } from 'vitest';
import type { Port, Timer } from './port';
import { PutError } from './problem';
import { putFiles, type PutResult } from './put-files';
import { RawRepl } from './raw-repl';
import { SerialLine } from './serial-line';

/** Time that jumps to the next moment that somebody waits for. */
class JumpingClock implements Timer {
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
function scripted(answer: (sent: string) => string | null): Port {
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

const BANNER = '\r\nraw REPL; CTRL-B to exit\r\n>';

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

const problemOf = async (port: Port): Promise<string> => {
  const result = await putOn(port);
  return result.kind === 'problem' ? result.problem.kind : result.kind;
};

/** A dialogue in raw mode that has just begun. */
async function dialogue(answer: (sent: string) => string | null): Promise<(code: string) => Promise<unknown>> {
  const timer = new JumpingClock();
  const line = new SerialLine(scripted((sent) => (/^[\r\x01\x04]/.test(sent) ? BANNER : answer(sent))), timer, new AbortController().signal); // prettier-ignore
  const repl = new RawRepl(line);
  await timer.runTo(repl.enter());
  return (code) =>
    timer.runTo(
      repl.run(code).catch((error: unknown) => {
        if (error instanceof PutError) return error.problem;
        throw error;
      }),
    );
}

describe('the dialogue with a device', () => {
  it('tells a device that is silent from one that says something else', async () => {
    expect(await problemOf(scripted(() => ''))).toBe('silent');
    expect(await problemOf(scripted(() => 'Grbl 1.1h [$ for help]\r\n'))).toBe('no-prompt');
  });

  it('says that the cable is out when the line ends', async () => {
    expect(await problemOf(scripted(() => null))).toBe('interrupted');
  });

  it('gives up where the line takes nothing any more', async () => {
    const port: Port = { ...scripted(() => ''), write: () => new Promise(() => undefined) };
    expect(await problemOf(port)).toBe('stuck');
  });

  it('does not wait for a line that cannot be closed', async () => {
    const port: Port = { ...scripted(() => ''), close: () => new Promise(() => undefined) };
    expect(await problemOf(port)).toBe('silent');
  });

  it('does not let a device that chatters without end keep it waiting', async () => {
    const timer = new JumpingClock();
    const port: Port = {
      write: () => Promise.resolve(),
      read: () =>
        new Promise((resolve) => void timer.after(1, () => resolve(new TextEncoder().encode('blah '.repeat(100))))),
      close: () => Promise.resolve(),
    };
    const line = new SerialLine(port, timer, new AbortController().signal);
    const problem = await timer.runTo(new RawRepl(line).enter().catch((error: unknown) => error));
    expect(problem).toMatchObject({ problem: { kind: 'no-prompt' } });
    expect(timer.nowMs).toBeLessThan(10_000);
  });

  it('gives what was printed, and the words of an exception', async () => {
    const run = await dialogue((sent) => {
      if (!sent.endsWith('\x04')) return '';
      return sent.startsWith('good') ? 'OK 7\r\n\x04\x04>' : 'OK\x04Traceback\r\nValueError: 1\r\n\x04>';
    });
    expect(await run('good')).toBe('7');
    expect(await run('bad')).toEqual({ kind: 'exception', text: 'Traceback\r\nValueError: 1' });
    expect(await run('good')).toBe('7');
  });

  it('notices answers that make no sense, and those that stop in the middle', async () => {
    const answers: Readonly<Record<string, string>> = {
      noise: 'xxOK1\x04\x04>',
      prompt: 'OK1\x04\x04 no >',
      half: 'OK1\x04',
      nothing: '',
    };
    for (const [name, problem] of [
      ['noise', 'garbled'],
      ['prompt', 'garbled'],
      ['half', 'stuck'],
      ['nothing', 'stuck'],
    ]) {
      const run = await dialogue((sent) => (sent.endsWith('\x04') ? (answers[name ?? ''] ?? '') : ''));
      expect(await run('x'), name).toEqual({ kind: problem });
    }
  });

  it('sends long code in small pieces, with time between them', async () => {
    const timer = new JumpingClock();
    const pieces: { readonly length: number; readonly atMs: number }[] = [];
    const port = scripted((sent) => {
      pieces.push({ length: sent.length, atMs: timer.nowMs });
      return '';
    });
    const line = new SerialLine(port, timer, new AbortController().signal);
    await timer.runTo(line.send('a'.repeat(100)));
    expect(pieces).toEqual([32, 32, 32, 4].map((length, place) => ({ length, atMs: 10 * place })));
  });
});

describe('a device that answers rubbish', { timeout: 120_000 }, () => {
  /** Numerical Recipes' linear congruential generator. */
  const chance = (seed: number): ((below: number) => number) => {
    let state = seed;
    return (below) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return Math.floor((state / 2 ** 32) * below);
    };
  };
  const TOKENS = [BANNER, 'OK', '\x04', '>', '\x04\x04>', 'OK\x04\x04>', 'OK1\r\n\x04\x04>', 'OK-\r\n\x04\x04>', '\r\n>>> ', 'soft reboot', 'OK\x04OSError: 28\r\n\x04>', 'OK\x04Traceback\r\n\x04>', '\xff\x00\x80', 'x'.repeat(400), ''] as const; // prettier-ignore

  it('never hangs and never fails but with a problem of its own, in 10,000 dialogues', async () => {
    const seen = new Map<string, number>();
    for (let seed = 0; seed < 10_000; seed++) {
      const below = chance(seed);
      // From pure rubbish to a device that is nearly right.
      const sense = below(101);
      let mode: 'raw' | 'friendly' = 'raw';
      const right = (sent: string): string => {
        if (sent.startsWith('\x02')) mode = 'friendly';
        if (sent.startsWith('\x01')) return BANNER;
        if (mode === 'friendly') return sent === '\x04' ? '\r\nMPY: soft reboot\r\n' : '\r\n>>> ';
        if (sent === '\x04' && below(4) === 0) return BANNER;
        return sent.endsWith('\x04') ? (['OK1\r\n\x04\x04>', 'OK-\r\n\x04\x04>', BANNER][below(3)] ?? '') : '';
      };
      const port = scripted((sent) => {
        if (below(400) === 0) return null;
        return below(100) < sense ? right(sent) : (TOKENS[below(TOKENS.length)] ?? '');
      });
      const kind = await problemOf(port);
      seen.set(kind, (seen.get(kind) ?? 0) + 1);
    }
    // The rubbish reaches far into the dialogue.
    for (const kind of ['silent', 'no-prompt', 'interrupted', 'garbled', 'stuck', 'exception', 'wrong-board']) {
      if (kind !== 'silent') expect([...seen.keys()]).toContain(kind);
    }
  });
});
