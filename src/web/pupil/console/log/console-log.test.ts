import { describe, expect, it } from 'vitest';

import { CONSOLE_LIMITS, ConsoleLog, lastPlace, withPlaces } from './console-log';
import { adviceFor } from '../advice/error-advice';

const TRACEBACK =
  'Traceback (most recent call last):\r\n  File "main.py", line 7, in <module>\r\n  File "drive.py", line 3, in go\r\nNameError: name \'x\' isn\'t defined\r\n';

describe('the console log', () => {
  it('keeps text as it was printed, without carriage returns', () => {
    const log = new ConsoleLog();
    log.write('a\r\nb');
    log.write('c\r\n');
    expect(log.toText()).toBe('a\nbc\n');
  });

  it('keeps a few thousand of a million lines, the newest ones', () => {
    const log = new ConsoleLog();
    for (let from = 0; from < 1_000_000; from += 5000) {
      log.write(Array.from({ length: 5000 }, (_, index) => `${from + index}\n`).join(''));
    }
    const lines = log.toText().trimEnd().split('\n');
    expect(lines.length).toBeLessThanOrEqual(CONSOLE_LIMITS.lines);
    expect(lines.length).toBeGreaterThan(CONSOLE_LIMITS.lines - 2 * CONSOLE_LIMITS.entryLines);
    expect(lines.at(-1)).toBe('999999');
    expect(log.isCut).toBe(true);
    expect(log.entries.length).toBeLessThan(60);
  });

  it('breaks a line without an end after 2000 characters, so that it stays bounded too', () => {
    const log = new ConsoleLog();
    for (let i = 0; i < 20_000; i += 1) log.write('x'.repeat(1000));
    expect(log.toText().length).toBeLessThanOrEqual(CONSOLE_LIMITS.lines * (CONSOLE_LIMITS.lineCharacters + 1));
    expect(
      Math.max(
        ...log
          .toText()
          .split('\n')
          .map((line) => line.length),
      ),
    ).toBe(2000);
  });

  it('keeps at most 200 entries, the newest ones, however many runs print, fail and are stopped', () => {
    const log = new ConsoleLog();
    const report = { failure: { type: 'ValueError', message: 'no', traceback: '' }, source: null, table: null };
    for (let number = 1; number <= 1000; number += 1) {
      log.add({ kind: 'run', number });
      log.write('1\n');
      log.add({ kind: 'error', place: null, report });
      log.add({ kind: 'note', key: 'console.stopped' });
    }
    expect(log.entries).toHaveLength(CONSOLE_LIMITS.entries);
    expect(log.entries[0]).toMatchObject({ kind: 'run', number: 951 });
    expect(log.entries.at(-1)?.kind).toBe('note');
    expect(log.isCut).toBe(true);
  });

  it('touches only the last entry when output comes in', () => {
    const log = new ConsoleLog();
    for (let i = 0; i < 250; i += 1) log.write(`${i}\n`);
    const before = log.entries;
    log.write('more\n');
    expect(log.entries.slice(0, -1)).toEqual(before.slice(0, -1));
    expect(log.entries[0]).toBe(before[0]);
  });

  it('shows a traceback as an error up to the line that names the exception', () => {
    const log = new ConsoleLog();
    log.write(`one\r\n${TRACEBACK}two\r\n`);
    const tones = log.entries.map((entry) => (entry.kind === 'text' ? [entry.tone, entry.lines] : entry.kind));
    expect(tones).toEqual([['plain', 1], ['error', 4], ['plain', 1]]); // prettier-ignore
  });

  it('shows the traceback of a stopped program quietly', () => {
    const log = new ConsoleLog();
    log.write('Traceback (most recent call last):\n  File "main.py", line 1, in <module>\nKeyboardInterrupt: \n');
    log.quieten();
    expect(log.entries.map((entry) => entry.kind === 'text' && entry.tone)).toEqual(['quiet']);
  });

  it('starts a run with a heading on a line of its own', () => {
    const log = new ConsoleLog();
    log.write('no end of line');
    log.add({ kind: 'run', number: 2 });
    log.write('next');
    expect(log.entries.map((entry) => entry.kind)).toEqual(['text', 'run', 'text']);
  });

  it('is empty after clearing', () => {
    const log = new ConsoleLog();
    log.write('a\n');
    log.clear();
    expect(log.entries).toEqual([]);
    expect(log.toText()).toBe('');
  });
});

describe('the console log as a terminal', () => {
  const shown = (...texts: string[]): string => {
    const log = new ConsoleLog();
    for (const text of texts) log.write(text);
    return log.toText();
  };

  it('shows a typed character taken back as the board’s line editor sends it: \\b and ESC [K', () => {
    expect(shown('>>> prinn', '\b\x1b[K', 't(1)\r\n1\r\n>>> ')).toBe('>>> print(1)\n1\n>>> ');
  });

  it('inserts in the middle of a line: the tail is written anew and the cursor goes back over it', () => {
    expect(shown('>>> pint', '\b\b\b', '\x1b[Krint', '\b\b\b')).toBe('>>> print');
    expect(shown('>>> ab', '\x1b[2D', 'xab', '\b\b', '\r\n')).toBe('>>> xab\n');
  });

  it('replaces a line from the history: 5 columns back, the rest erased', () => {
    expect(shown('>>> old_1', '\x1b[5D\x1b[Knew', '\r\n')).toBe('>>> new\n');
  });

  it('writes over a line after a carriage return, as a progress display does', () => {
    expect(shown('10 %\r', '20 %\r', '5 %')).toBe('5 %%');
    expect(shown('10 %\r\x1b[2K', '5 %')).toBe('5 %');
  });

  it('understands sequences that arrive in two pieces', () => {
    expect(shown('one\r', '\ntwo\x1b', '[', '1', 'D', '!')).toBe('one\ntw!');
  });

  it('leaves colours and other control characters out', () => {
    expect(shown('\x1b[31mred\x1b[0m\x07 \x04done')).toBe('red done');
  });

  it('clears everything when the program clears its screen', () => {
    expect(shown('a\nb\n\x1b[2J\x1b[Hc')).toBe('c');
  });

  it('goes on after a note in the middle of a line', () => {
    const log = new ConsoleLog();
    log.write('half');
    log.add({ kind: 'run', number: 1 });
    log.write('\b\b\x1b[Kx');
    expect(log.toText()).toBe('halfx');
  });

  it('keeps its bounds when a program rewrites one line a hundred thousand times', () => {
    const log = new ConsoleLog();
    for (let i = 0; i < 100; i += 1) log.write(Array.from({ length: 1000 }, (_, n) => `${i * 1000 + n}\r`).join(''));
    log.write('.');
    expect(log.toText()).toBe('.9999');
    expect(log.entries).toHaveLength(1);
  });
});

describe('places in a traceback', () => {
  it('are the lines of the pupil’s own files', () => {
    const places = withPlaces(TRACEBACK, ['main.py']).filter((piece) => piece.place !== null);
    expect(places).toEqual([{ text: 'File "main.py", line 7', place: { file: 'main.py', line: 7 } }]);
  });

  it('keep the whole text together', () => {
    const pieces = withPlaces(TRACEBACK, ['main.py', 'drive.py']);
    expect(pieces.map((piece) => piece.text).join('')).toBe(TRACEBACK);
  });

  it('end with the innermost one', () => {
    expect(lastPlace(TRACEBACK, ['main.py', 'drive.py'])).toEqual({ file: 'drive.py', line: 3 });
    expect(lastPlace(TRACEBACK, ['main.py'])).toEqual({ file: 'main.py', line: 7 });
    expect(lastPlace(TRACEBACK, [])).toBeNull();
  });
});

describe('an error that is typed at the REPL', () => {
  const say = (text: string): string[] => {
    const log = new ConsoleLog();
    for (const line of text.split(/(?<=\n)/)) log.write(line);
    return log.entries.map((entry) => (entry.kind === 'error' ? adviceFor(entry.report.failure).key : entry.kind));
  };
  const typed = (last: string): string =>
    `>>> x\r\nTraceback (most recent call last):\r\n  File "<stdin>", line 1, in <module>\r\n${last}\r\n>>> `;

  it('is explained before the next prompt', () => {
    expect(say(typed('ZeroDivisionError: divide by zero'))).toEqual([
      'text',
      'text',
      'error.ZeroDivisionError',
      'text',
    ]);
  });

  it('is not one when it is an interrupt, and main.py has its explanation elsewhere', () => {
    expect(say(typed('KeyboardInterrupt: '))).not.toContain('error.KeyboardInterrupt');
    expect(say(TRACEBACK)).toEqual(['text']);
  });
});
