import { describe, expect, it } from 'vitest';
import type { Port } from './port';
import { PutError } from './problem';
import { RawRepl } from './raw-repl';
import { SerialLine } from './serial-line';
import { BANNER, JumpingClock, problemOf, scripted } from './testing/scripted-device';

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
