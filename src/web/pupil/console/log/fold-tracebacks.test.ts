import { describe, expect, it } from 'vitest';

import { ConsoleLog } from './console-log';
import { foldTracebacks } from './fold-tracebacks';

const TRACEBACK =
  "Traceback (most recent call last):\n  File \"main.py\", line 1, in <module>\nNameError: name 'x' isn't defined\n";

describe('the traceback of an error that is explained', () => {
  it('lies within its card, and what the program printed stays where it is', () => {
    const log = new ConsoleLog();
    log.add({ kind: 'run', number: 1 });
    log.write(`1\n${TRACEBACK}`);
    log.add({
      kind: 'error',
      place: { file: 'main.py', line: 1 },
      report: { failure: { type: 'NameError', message: '' }, source: null, table: null },
    });
    log.add({ kind: 'note', key: 'console.motorsOn' });
    const shown = foldTracebacks(log.entries);
    expect(shown.map(({ entry }) => entry.kind)).toEqual(['run', 'text', 'error', 'note']);
    expect(shown[1]?.entry).toMatchObject({ tone: 'plain', text: '1\n' });
    expect(shown[2]?.traceback.map(({ text }) => text)).toEqual([TRACEBACK]);
  });

  it('stands alone as long as nothing explains it', () => {
    const log = new ConsoleLog();
    log.write(TRACEBACK);
    expect(foldTracebacks(log.entries).map(({ entry }) => entry)).toEqual(log.entries);
  });
});
