import { describe, expect, it } from 'vitest';

import { ConsoleLog } from './console-log';
import { latestLines } from './latest-lines';

describe('the output that is read aloud', () => {
  it('is the last 12 lines of the present run, without its traceback', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'run', number: 1 });
    log.write('früher\n');
    log.add({ kind: 'run', number: 2 });
    log.write(Array.from({ length: 14 }, (_, place) => `${String(place)}\n`).join(''));
    log.write('Traceback (most recent call last):\n  File "main.py", line 1\nValueError: x\n');
    expect(latestLines(log.entries)).toBe('2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13');
  });

  it('is nothing before the program has printed', () => {
    const log = new ConsoleLog();
    log.write('früher\n');
    log.add({ kind: 'run', number: 2 });
    expect(latestLines(log.entries)).toBe('');
  });
});
