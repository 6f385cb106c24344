import { describe, expect, it } from 'vitest';

import { namesOf, scopeAt, type Scope } from './scopes';
import { readPython } from './tree';

const rootOf = (text: string): Scope => namesOf(readPython(text)).root;
const namesIn = ({ names }: Scope): string => names.map(({ name }) => name).join(' ');

/** The names of the scope at ¦. */
function at(text: string): string {
  const [source, offset] = [text.replace('¦', ''), text.indexOf('¦')];
  return namesIn(scopeAt(rootOf(source), source, offset));
}

describe('the names of a program', () => {
  it('come from assignments, loops, with, except, imports, def, class and :=', () => {
    expect(namesIn(rootOf('a = b = 1\nc, (d, e) = f\n[g, h] = i\nj: int = 2\nk.l = 3\nm[0] = 4'))).toBe(
      'a b c d e g h j',
    );
    expect(namesIn(rootOf('for a, b in c:\n  d = 1\nelse:\n  e = 2'))).toBe('a b d e');
    expect(namesIn(rootOf('with a as b, c as d: pass\ntry: pass\nexcept E as e: pass'))).toBe('b d e');
    expect(namesIn(rootOf('import a, b as c, d.e\nfrom f import g, h as i\nfrom j import *'))).toBe('a c d g i');
    expect(namesIn(rootOf('def a(b): c = 1\nclass d: e = 2\nif (f := 3): pass'))).toBe('a d f');
  });

  it('are the parameters of a function and what it assigns, but for what it takes from the module by global', () => {
    const text = 'def f(a, b=1, *c, d: int = 2, **e):\n  global g\n  g = h = 1\n  ¦\ni = 2';
    expect(at(text)).toBe('a b c d e h');
    expect(at(text.replace('¦', '') + '¦')).toBe('f g i');
  });

  it('are what methods assign to self for instances', () => {
    const { root, attributes } = namesOf(
      readPython('class A:\n  n = 1\n  def f(self):\n    self.x = self.y = 1\na.z = 2'),
    );
    expect(root.inner[0]?.fields.map(({ name }) => name)).toEqual(['x', 'y']);
    expect([...attributes].sort()).toEqual(['A', 'f', 'n', 'x', 'y', 'z']);
  });

  it('end with their lambda or comprehension', () => {
    expect(at('a = lambda b, c=1: b¦')).toBe('b c');
    expect(at('a = [b for b in c if b¦]')).toBe('b');
    expect(at('a = sum(b for b, c in d¦) + 1')).toBe('b c');
    expect(at('a = [b for b in c]¦')).toBe('a');
  });
});

describe('the scope at a place', () => {
  it('goes by the indentation of the line: a function goes on in an empty line that is indented', () => {
    expect(at('def f(a):\n    b = 1\n    ¦')).toBe('a b');
    expect(at('def f(a):\n    b = 1\n¦')).toBe('f');
    expect(at('def f(a):\n    ¦')).toBe('a');
    expect(at('def f(a): return a¦')).toBe('a');
    expect(at('class A:\n  def f(self, a):\n    pass\n  ¦\n')).toBe('f');
  });

  it('goes on behind a line that is indented wrongly', () => {
    expect(at('def f(a):\n    b = 1\n      c = 2\n    d = 3\n    ¦\ne = 4')).toBe('a b c d');
    expect(at('def f(a):\n    if a:\n        b = 1\n      c = 2\n    d = 3\n    ¦\ne = 4')).toBe('a b c d');
  });

  it('stays with its names while a line is half written', () => {
    for (const half of [
      'display.',
      'display.show(Im',
      'for i in ra',
      'if a',
      'if ',
      'while',
      'x = ',
      'x = (1, [',
      'print("a',
      'with open("a") as',
      'try:',
      'return a +',
      'a[',
      '@',
      'import',
      'from a import',
      'elif',
    ])
      expect(at(`def f(a):\n    b = 1\n    ${half}¦\n\ndef h():\n    pass\n`), half).toContain('a b');
  });
});
