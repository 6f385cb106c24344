import { describe, expect, it } from 'vitest';

import { nextIndent, replLine } from './repl-line';

describe('a line typed for the REPL', () => {
  it('rubs out the indentation that the device puts there, and brings its own', () => {
    expect(replLine('    print(i)')).toBe(`${'\x7f'.repeat(8)}    print(i)\r`);
  });

  it('ends a block when it is empty or has spaces alone', () => {
    expect(replLine('    ')).toBe(replLine(''));
    expect(nextIndent('    ')).toBe('');
  });

  it('is followed by one that is indented: 4 spaces more after a colon, else as much as before', () => {
    expect(nextIndent('for i in range(3):')).toBe('    ');
    expect(nextIndent('    if i:  # odd')).toBe('        ');
    expect(nextIndent('    print(i)')).toBe('    ');
    expect(nextIndent('print({1: 2})')).toBe('');
  });
});
