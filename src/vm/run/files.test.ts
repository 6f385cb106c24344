import { describe, expect, it } from 'vitest';
import { fileHint, Files, type StoredFile } from './files';

const written = (files: Files, name: string, bytes: number): number => {
  const file = files.create(name);
  return typeof file === 'number' ? file : files.append(file, new Uint8Array(bytes));
};

describe('Files', () => {
  it('lists the files in the order in which they were written', () => {
    const files = new Files({ 'main.py': 'print(1)' });
    written(files, 'b.txt', 1);
    written(files, 'a.txt', 1);
    expect(files.names).toEqual(['main.py', 'b.txt', 'a.txt']);
  });

  it('takes a name of 120 characters and refuses 121 with ENOENT (2)', () => {
    const files = new Files();
    expect(written(files, 'a'.repeat(120), 1)).toBe(0);
    expect(files.create('a'.repeat(121))).toBe(-2);
  });

  it('holds 24,000 bytes in one file and refuses 24,192 with ENOSPC (28), losing the file', () => {
    const files = new Files();
    expect(written(files, 'a', 24_000)).toBe(0);
    expect(written(files, 'a', 24_192)).toBe(-28);
    expect(files.names).toEqual([]);
  });

  it('needs a chunk of 126 bytes even for an empty file: 192 files fill it', () => {
    const files = new Files();
    for (let i = 0; i < 192; i++) expect(written(files, `f${i}`, 0)).toBe(0);
    expect(files.create('one more')).toBe(-28);
  });

  it('does not write into a file that was begun anew: EBADF (9)', () => {
    const files = new Files();
    const first = files.create('a') as StoredFile;
    files.create('a');
    expect(files.append(first, Uint8Array.of(1))).toBe(-9);
  });
});

describe('fileHint', () => {
  it('says how much a program of 64 kB needs', () => {
    expect(fileHint({ 'main.py': 'x'.repeat(64_000) })).toBe('The files need 64.1 kB on the board, which has 24.2 kB.');
  });

  it('names a file name that is too long', () => {
    expect(fileHint({ ['n'.repeat(130)]: '' })).toContain('130 characters; the board takes 120');
  });

  it('has nothing against a small program', () => expect(fileHint({ 'main.py': 'print(1)' })).toBeNull());
});
