import { chmodSync, closeSync, existsSync, linkSync, mkdirSync, readFileSync, readdirSync, statSync, symlinkSync } from 'node:fs'; // prettier-ignore
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { useFolder } from './testing/parcours';
import { closeOutput, emptyOutput, openOutput, replaceFile, writeAll, writeOutput } from './write-output';

const { folder, file } = useFolder();
const at = (name: string): string => join(folder, name);
const read = (name: string): string => readFileSync(at(name), 'utf8');

describe('a file that is written whole', () => {
  it('is new, or takes the place of an earlier one with its rights, and leaves no draft', () => {
    writeOutput(at('new.csv'), 'one');
    chmodSync(file('earlier.csv', 'a longer text'), 0o640);
    writeOutput(at('earlier.csv'), 'two');
    expect([read('new.csv'), read('earlier.csv')]).toEqual(['one', 'two']);
    expect((statSync(at('earlier.csv')).mode & 0o777).toString(8)).toBe('640');
    expect(readdirSync(folder).filter((name) => name.endsWith('.tmp'))).toEqual([]);
  });

  it('stays where links lead, and one file under two names', () => {
    symlinkSync(file('behind.csv', 'old'), at('soft.csv'));
    linkSync(file('first.csv', 'old'), at('second.csv'));
    writeOutput(at('soft.csv'), 'new');
    writeOutput(at('second.csv'), 'new');
    expect([read('behind.csv'), read('first.csv')]).toEqual(['new', 'new']);
  });

  it('keeps what it had where that fails', () => {
    mkdirSync(at('taken'));
    file('taken/inside', '');
    expect(() => replaceFile(at('taken'), 'new')).toThrow(/EISDIR|EEXIST|ENOTEMPTY|EPERM/);
    expect(existsSync(at('taken/inside'))).toBe(true);
    expect(readdirSync(folder).filter((name) => name.endsWith('.tmp'))).toEqual([]);
  });

  it.runIf(existsSync('/dev/full'))('tells when the disk is full', () => {
    expect(() => writeOutput('/dev/full', 'text')).toThrow(/ENOSPC/);
  });
});

describe('a file that is opened before the work', () => {
  it('keeps its bytes until it is emptied and written', () => {
    const opened = openOutput(file('trace.csv', 'earlier'));
    expect(read('trace.csv')).toBe('earlier');
    emptyOutput(opened);
    writeAll(opened, 'ä');
    writeAll(opened, 'b');
    closeOutput(opened);
    expect(read('trace.csv')).toBe('äb');
    expect(() => closeSync(opened)).toThrow(/EBADF/);
  });

  it('is never emptied or closed where it is what is printed on', () => {
    expect([openOutput('/dev/stdout'), openOutput('/dev/stderr')]).toEqual([1, 2]);
    closeOutput(1);
    expect(statSync('/dev/fd/1')).toBeDefined();
  });
});
