import { Linter } from 'eslint';
import { describe, expect, it } from 'vitest';

import { docstringWords } from './docstring-words.mjs';

const linter = new Linter();
const judge = (code) =>
  linter
    .verify(code, {
      plugins: { parcours: { rules: { docstringWords } } },
      rules: { 'parcours/docstringWords': 'error' },
    })
    .map(({ message }) => message);

describe('the rule for docstrings', () => {
  it('lets a docstring pass that says what a thing is or does', () => {
    expect(
      judge('/** The pulses of a channel, in µs. */\nlet a;\n/** Reads them, whatever they are. */\nlet b;'),
    ).toEqual([]);
  });

  it('refuses one that begins with half a sentence, on one line or on several', () => {
    expect(judge('/** What is read. */\nlet a;')).toEqual([
      'A docstring says what a thing is or does; “What …” is half a sentence.',
    ]);
    expect(judge('/**\n * Where it is.\n */\nlet a;')).toHaveLength(1);
  });

  it('does not judge other comments, nor words that only begin alike', () => {
    expect(judge('// What for? Whatever.\nlet a;\n/** Offset of the axle. */\nlet b;\n/* So it is. */')).toEqual([]);
  });
});
