import { Linter } from 'eslint';
import { describe, expect, it } from 'vitest';

import { classLines } from './class-lines.mjs';

const linter = new Linter();
const judge = (code) =>
  linter
    .verify(code, { plugins: { parcours: { rules: { classLines } } }, rules: { 'parcours/classLines': ['error', 4] } })
    .map(({ message }) => message);

describe('the limit for classes', () => {
  it('lets a class pass that is just as long as allowed', () => {
    expect(judge('class Short {\n  a = 1;\n  b = 2;\n}')).toEqual([]);
  });

  it('names a class that is longer, and its length', () => {
    expect(judge('class Long {\n  a = 1;\n  b = 2;\n  c = 3;\n}')).toEqual([
      'Class Long has 5 lines of code, at most 4 are allowed: give a part of it a class of its own.',
    ]);
  });

  it('counts neither comments nor empty lines, and each line of a long text', () => {
    expect(judge('class Told {\n  /**\n   * Why.\n   */\n\n  a = 1; // so\n\n  b = 2;\n}')).toEqual([]);
    expect(judge('class Text {\n  a = `1\n2\n3`;\n}')).toHaveLength(1);
  });

  it('holds for a class without a name, too', () => {
    expect(judge('export const it = class {\n  a = 1;\n  b = 2;\n  c = 3;\n};')).toHaveLength(1);
  });
});
