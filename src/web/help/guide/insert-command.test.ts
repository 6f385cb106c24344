import { describe, expect, it } from 'vitest';

import type { Command } from './commands';
import { insertionOf } from './insert-command';

const forward: Command = { module: 'mbrobot', name: 'forward', calls: ['()'], code: 'forward()', text: '' };
const arc: Command = { module: 'mbrobot', name: 'leftArc', calls: [], code: 'leftArc(radius)', text: '' };
const IMPORT = 'from mbrobot import *\n';

/** The program afterwards; `|` is the cursor, `[ ]` what is marked. */
function done(marked: string, command: Command): string {
  const from = marked.search(/[|[]/);
  const to = marked.includes(']') ? marked.indexOf(']') - 1 : from;
  const program = marked.replace(/[|[\]]/g, '');
  const { changes, select } = insertionOf(program, from, to, command);
  let text = program;
  for (const change of [...changes].reverse())
    text = text.slice(0, change.from) + change.insert + text.slice(change.to);
  const { anchor, head } = select;
  const mark = anchor === head ? '|' : `[${text.slice(anchor, head)}]`;
  return text.slice(0, anchor) + mark + text.slice(head);
}

describe('a command put into the program', () => {
  it('stands where the cursor is on an empty line', () => {
    expect(done(`${IMPORT}while True:\n    |`, forward)).toBe(`${IMPORT}while True:\n    forward()|`);
  });

  it('gets a line of its own behind other code, further in after a colon', () => {
    expect(done(`${IMPORT}  stop()|\nend()`, forward)).toBe(`${IMPORT}  stop()\n  forward()|\nend()`);
    expect(done(`${IMPORT}while True:  # for ever|`, forward)).toBe(`${IMPORT}while True:  # for ever\n    forward()|`);
  });

  it('is a part of the line in the middle of one, and after an equals sign', () => {
    expect(done(`${IMPORT}print(|)`, forward)).toBe(`${IMPORT}print(forward()|)`);
    expect(done(`${IMPORT}x = |`, forward)).toBe(`${IMPORT}x = forward()|`);
  });

  it('replaces what is marked', () => {
    expect(done(`${IMPORT}[stop()]\nend()`, forward)).toBe(`${IMPORT}forward()|\nend()`);
  });

  it('has its first argument marked, to be typed over', () => {
    expect(done(`${IMPORT}|`, arc)).toBe(`${IMPORT}leftArc([radius])`);
  });

  it('brings the import of its module along, after the other ones', () => {
    expect(done('|', forward)).toBe(`${IMPORT}forward()|`);
    expect(done('# drive\nfrom microbit import *\n\nsleep(5)|', forward)).toBe(
      `# drive\nfrom microbit import *\n${IMPORT}\nsleep(5)\nforward()|`,
    );
    expect(done('|\nsleep(5)', forward)).toBe(`${IMPORT}forward()|\nsleep(5)`);
    expect(done('from microbit import *|\nsleep(5)', forward)).toBe(
      `from microbit import *\n${IMPORT}forward()|\nsleep(5)`,
    );
    expect(done('# d|rive\n# on', forward)).toBe(`# drive\n# on\n${IMPORT}forward()|`);
    expect(done('from microbit import *|', arc)).toBe(`from microbit import *\n${IMPORT}leftArc([radius])`);
  });

  it('is called as the program has imported its module', () => {
    expect(done('import mbrobot\n|', forward)).toBe('import mbrobot\nmbrobot.forward()|');
    expect(done('import mbrobot as robot\n|', arc)).toBe('import mbrobot as robot\nrobot.leftArc([radius])');
  });
});
