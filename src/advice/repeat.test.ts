import { describe, expect, it } from 'vitest';

import { rewriteRepeat } from './repeat';

const rewritten = (text: string): string => rewriteRepeat(text).text;

describe('a program of TigerJython', () => {
  it('has Python’s loops afterwards: a number of times, or for ever', () => {
    expect(rewritten('repeat 4:\n    forward()\nrepeat:\n\tstop()')).toBe(
      'for _ in range(4):\n    forward()\nwhile True:\n\tstop()',
    );
  });

  it('keeps line numbers, indentation and comments, and says which lines are new', () => {
    const text = 'from mbrobot import *\n\ndef f():\n    repeat  3 :  # thrice: so\n        left()\n';
    expect(rewriteRepeat(text)).toEqual({
      text: 'from mbrobot import *\n\ndef f():\n    for _ in range(3):  # thrice: so\n        left()\n',
      lines: [{ line: 4, before: '    repeat  3 :  # thrice: so', after: '    for _ in range(3):  # thrice: so' }],
    });
  });

  it.each([
    ['repeat (4):', 'for _ in range(4):'],
    ['repeat(4):', 'for _ in range(4):'],
    ['repeat (a + 1) * (b):', 'for _ in range((a + 1) * (b)):'],
    ['repeat len("a:#"):', 'for _ in range(len("a:#")):'],
    ['repeat x[1:][0]:', 'for _ in range(x[1:][0]):'],
    ['repeat max(a, b): # x', 'for _ in range(max(a, b)): # x'],
    ['repeat -n:', 'for _ in range(-n):'],
    ['repeat :', 'while True:'],
    ['repeat 4:\r', 'for _ in range(4):\r'],
  ])('counts with any value: %j', (before, after) => expect(rewritten(before)).toBe(after));

  it('may have loops within loops', () => {
    expect(rewritten('repeat 2:\n  repeat 3:\n    repeat:\n      f()')).toBe(
      'for _ in range(2):\n  for _ in range(3):\n    while True:\n      f()',
    );
  });

  it('counts with a name that the program does not have', () => {
    expect(rewritten('_ = 5\nrepeat 2:\n  print(_)')).toBe('_ = 5\nfor _1 in range(2):\n  print(_)');
    expect(rewritten('_, _1 = 5, 6\nrepeat 2:\n  repeat 3:\n    print(_)')).toBe(
      '_, _1 = 5, 6\nfor _2 in range(2):\n  for _2 in range(3):\n    print(_)',
    );
    expect(rewritten('# _\nx_1 = "_"\nrepeat 2:\n  f()')).toBe('# _\nx_1 = "_"\nfor _ in range(2):\n  f()');
  });

  it.each([
    'x = """\nrepeat 4:\n"""',
    '# repeat 4:',
    'f(\nrepeat:\n)',
    'x = {\n  repeat:\n  3}',
    'repeat(lambda:\n  3)',
    'x = 1 + \\\nrepeat:',
    "x = 'a\\\nrepeat:'",
    'repeat = 3',
    'repeat = lambda:',
    'repeat.x:',
    'repeat, x:',
    'repeat 1, 2:',
    'repeat 4: forward()',
    'repeat 4: if x:',
    'repeat; while x:',
    'repeat 4',
    'repeat:\\\n    x()',
    'repeats 4:',
    'Repeat 4:',
    'while repeat:',
    'x = repeat; y = 3 #:',
    '',
  ])('is left as it is where nothing says that it is a loop: %j', (text) =>
    expect(rewriteRepeat(text)).toEqual({ text, lines: [] }),
  );

  it('may be as long as a program can be', () => {
    const text = 'repeat 4:\n    forward()\n'.repeat(10_000);
    expect(rewriteRepeat(text).lines).toHaveLength(10_000);
  });
});
