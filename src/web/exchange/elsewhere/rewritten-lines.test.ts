import { describe, expect, it } from 'vitest';

import { rewriteRepeat } from '#advice/repeat';
import { withLinesBack } from '#intake/lines-back';
import { linesStillThere } from './rewritten-lines';

const program = 'from mbrobot import *\nrepeat 4:\n    forward()\n    repeat 2:\n        left()\nrepeat:\n    stop()\n';

/** The lines that still are rewritten after the program was changed like this, and the program with them taken back. */
function after(change: (text: string) => string) {
  const read = rewriteRepeat(program);
  const rewritten = read.lines.map((line) => ({ file: 'main.py', ...line }));
  const now = { name: 'main.py', text: change(read.text) };
  const left = linesStillThere([{ name: 'main.py', text: read.text }], [now], rewritten);
  return { lines: left.map(({ line }) => line), back: withLinesBack(now, left).text };
}

describe('loops that were rewritten when a link was opened', () => {
  it('are all there at first, and taken back the program is as in the link', () =>
    expect(after((text) => text)).toEqual({ lines: [2, 4, 6], back: program }));

  it('are known where other lines were changed, and these stay', () =>
    expect(after((text) => text.replace('forward', 'backward').replace('stop', 'go'))).toEqual({
      lines: [2, 4, 6],
      back: program.replace('forward', 'backward').replace('stop', 'go'),
    }));

  it('are known further down after a line was put in, and further up after one was taken out', () => {
    expect(after((text) => text.replace('    forward()', '    forward()\n    delay(9)'))).toEqual({
      lines: [2, 5, 7],
      back: program.replace('    forward()', '    forward()\n    delay(9)'),
    });
    expect(after((text) => text.replace('    forward()\n', '')).lines).toEqual([2, 3, 5]);
  });

  it('are left alone where they were changed by hand', () =>
    expect(after((text) => text.replace('range(2)', 'range(3)'))).toEqual({
      lines: [2, 6],
      back: program.replace('repeat 2', 'for _ in range(3)'),
    }));

  it('are gone with their file', () => {
    const rewritten = [{ file: 'x.py', line: 1, before: 'repeat:', after: 'while True:' }];
    expect(linesStillThere([{ name: 'x.py', text: 'while True:' }], [], rewritten)).toEqual([]);
  });
});
