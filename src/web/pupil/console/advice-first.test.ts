import { describe, expect, it } from 'vitest';

import { adviceFirst } from './advice-first';
import { ConsoleLog } from './log/console-log';

describe('the explanation first', () => {
  it('puts the card before the traceback, and leaves what the program printed where it is', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'run', number: 1 });
    log.write('1\n');
    log.write(
      "Traceback (most recent call last):\n  File \"main.py\", line 1, in <module>\nNameError: name 'x' isn't defined\n",
    );
    log.add({
      kind: 'error',
      place: { file: 'main.py', line: 1 },
      report: { failure: { type: 'NameError', message: '' }, source: null, table: null },
    });
    log.add({ kind: 'note', key: 'console.motorsOn' });
    const said = adviceFirst(log.entries).map((entry) => (entry.kind === 'text' ? entry.tone : entry.kind));
    expect(said).toEqual(['run', 'plain', 'error', 'error', 'note']);
    expect(adviceFirst(log.entries)[2]?.kind).toBe('error');
  });

  it('changes nothing where there is no error', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'run', number: 1 });
    log.write('1\n2\n');
    expect(adviceFirst(log.entries)).toEqual(log.entries);
  });
});
