import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parcours, useFolder } from '../testing/parcours';

const { file } = useFolder();

const RIGHT = readFileSync('courses/push/main.py', 'utf8');

describe('parcours hint', () => {
  it('says of a program that passes that it does', () => {
    const { code, out } = parcours('hint', 'push', 'courses/push/main.py', '--json');
    expect([code, JSON.parse(out)]).toEqual([0, { passed: true }]);
  });

  it('tells a change that makes a program pass, and only as much as it may', () => {
    const wrong = file('wrong.py', RIGHT.replace('irLeft.read_digital() == 1', 'irLeft.read_digital() == 0'));
    const { code, out } = parcours('hint', 'push', wrong, '--level', '4', '--json');
    expect(code).toBe(3);
    const { hint, change, found } = JSON.parse(out) as {
      readonly found: boolean;
      readonly hint: object;
      readonly change: { readonly line: number; readonly before: string; readonly after: string };
    };
    expect([found, hint]).toMatchObject([true, { kind: 'polarity', line: 8 }]);
    const mended = readFileSync(wrong, 'utf8').replace(change.before, change.after);
    expect(parcours('check', 'push', file('mended.py', mended)).code).toBe(0);
    const told = parcours('hint', 'push', wrong, '--lang', 'de').out;
    expect(told).toBe('Bei 1.3 s war dein Programm zu Ende, und das Ziel war noch nicht erreicht.\n');
  });

  it('refuses several programs, unknown levels and budgets', () => {
    for (const words of [
      ['a.py', 'b.py'],
      ['a.py', '--level', '5'],
      ['a.py', '--budget', '-1'],
    ])
      expect(parcours('hint', 'push', ...words)).toMatchObject({ code: 2 });
  });
});
