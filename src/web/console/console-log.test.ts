import { describe, expect, it } from 'vitest';

import { CONSOLE_LIMITS, ConsoleLog, lastPlace, withPlaces } from './console-log';

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
