import { describe, expect, it } from 'vitest';

import { ConsoleLog } from './console-log';
import { foldGreetings } from './fold-greeting';

const GREETING = 'MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2\r\nType "help()" for more information.\r\n>>> ';

/** Adds a run that prints `text`, ends, and is followed by what the device sends then. */
function addRun(log: ConsoleLog, number: number, text: string, after: string): void {
  log.add({ kind: 'run', number });
  log.write(text);
  log.add({ kind: 'note', key: 'console.finished' });
  for (const piece of after) log.write(piece);
}

const shown = (log: ConsoleLog, visited: readonly number[] = [], current = 1): string =>
  foldGreetings(log.entries, new Set(visited), current)
    .map((entry) => (entry.kind === 'text' ? entry.text : `<${entry.kind}>`))
    .join('');

describe('the greeting of the REPL after a program', () => {
  it('is not shown until somebody goes to the REPL', () => {
    const log = new ConsoleLog();
    addRun(log, 1, 'end\n', GREETING);
    expect(shown(log)).toBe('<run>end\n<note>');
    expect(shown(log, [1])).toContain('<note>MicroPython v1.18');
    expect(shown(log, [1])).toMatch(/>>> $/);
  });

  it('is not shown after a stop, which the device tells before the page does', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'run', number: 1 });
    log.write('Traceback (most recent call last):\n  File "main.py", line 1, in <module>\nKeyboardInterrupt:\n');
    log.write(GREETING);
    log.quieten();
    log.add({ kind: 'note', key: 'console.interrupted' });
    expect(shown(log)).toMatch(/KeyboardInterrupt:\n<note>$/);
  });

  it('stays in the log, which is what is copied', () => {
    const log = new ConsoleLog();
    addRun(log, 1, 'end\n', GREETING);
    expect(log.toText()).toBe(`end\n${GREETING.replaceAll('\r', '')}`);
  });

  it('stays away from earlier runs when the last one’s is shown', () => {
    const log = new ConsoleLog();
    addRun(log, 1, 'one\n', GREETING);
    addRun(log, 2, 'two\n', GREETING);
    expect(shown(log, [2], 2)).toMatch(/^<run>one\n<note><run>two\n<note>MicroPython/);
  });

  it('leaves what callbacks print after the end of the program', () => {
    const log = new ConsoleLog();
    addRun(log, 1, '', `${GREETING}tick\r\ntick\r\n`);
    expect(shown(log)).toBe('<run><note>tick\ntick\n');
  });

  it('is shown where the program itself prints it', () => {
    const log = new ConsoleLog();
    addRun(log, 1, GREETING, '');
    expect(shown(log)).toContain('MicroPython v1.18');
  });

  it('is not shown either when the heading of its run has been cleared away', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'note', key: 'console.finished' });
    log.write(GREETING);
    expect(shown(log, [], 3)).toBe('<note>');
    expect(shown(log, [3], 3)).toContain('>>> ');
  });
});
