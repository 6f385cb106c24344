import { describe, expect, it } from 'vitest';

import { completeName, freeName, nameProblem } from './project';

describe('file names', () => {
  const files = [{ name: 'main.py', text: '' }];

  it('get .py where no ending is typed', () => {
    expect(completeName(' drive ')).toBe('drive.py');
    expect(completeName('data.txt')).toBe('data.txt');
    expect(completeName('  ')).toBe('');
  });

  it('must be new, not empty, at most 120 characters and free of slashes and spaces', () => {
    expect(nameProblem('drive.py', files)).toBeNull();
    expect(nameProblem('fährt.py', files)).toBeNull();
    expect(nameProblem('', files)).toBe('nameEmpty');
    expect(nameProblem('main.py', files)).toBe('nameTaken');
    expect(nameProblem('main.py', files, 'main.py')).toBeNull();
    expect(nameProblem('a/b.py', files)).toBe('nameCharacters');
    expect(nameProblem('a b.py', files)).toBe('nameCharacters');
    expect(nameProblem(`${'x'.repeat(118)}.py`, files)).toBe('nameLong');
  });

  it('count up where a name is taken', () => {
    expect(freeName('main.py', files)).toBe('main2.py');
    expect(freeName('main.py', [...files, { name: 'main2.py', text: '' }])).toBe('main3.py');
  });
});
