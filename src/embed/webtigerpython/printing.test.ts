import { describe, expect, it } from 'vitest';

import { Printing } from './printing';

const ERROR = 'Traceback (most recent call last):\n  File "main.py", line 1, in <module>\nValueError: no\n';

function heard() {
  const output: string[] = [];
  return { printing: new Printing((text) => output.push(text)), output };
}

describe('what the programs of a page print', () => {
  it('comes with the error that ended one apart, and all of it once more', () => {
    const { printing, output } = heard();
    printing.begin();
    printing.add('one\n');
    printing.add(ERROR);
    const end = printing.end({ traceback: ERROR.replaceAll('\n', '\r\n'), isStopped: false });
    expect(end).toEqual({ error: ERROR, whole: `one\n${ERROR}` });
    expect([output, printing.isLive]).toEqual([['one\n'], false]);
  });

  it('has no error where somebody stopped it', () => {
    const { printing } = heard();
    printing.begin();
    expect(printing.end({ traceback: ERROR, isStopped: true })?.error).toBeNull();
  });

  it('comes late, yet comes, where it only looked like the last error', () => {
    const { printing, output } = heard();
    printing.begin();
    printing.add(ERROR);
    expect(output).toEqual([]);
    printing.release();
    expect(output).toEqual([ERROR]);
  });

  it('is nothing where no program runs', () => {
    const { printing, output } = heard();
    printing.add('>>> 1\n');
    expect([printing.end({ traceback: null, isStopped: false }), output]).toEqual([null, []]);
  });
});
