import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';

import { checkForDevice } from './check-for-device';
import type { Device, Finding } from './finding';
import { pupilsPrograms } from './testing/pupils-programs';

const DEVICE: Device = { features: [], micropython: [1, 18, 0] };
const check = (files: Readonly<Record<string, string>>): readonly Finding[] => checkForDevice(files, DEVICE);
const rulesIn = (program: string): string[] => check({ 'main.py': program }).map(({ rule }) => rule);

/** All Python files of a folder and the folders in it. */
const pythonIn = (folder: string): string[] =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.py'))
    .map((name) => join(folder, name));

describe('the place of a finding', () => {
  it('is counted from 1: an f-string in line 3, column 7', () => {
    const program = 'x = 1\n\nprint(f"{x}")\n';
    expect(check({ 'main.py': program })).toEqual([
      {
        file: 'main.py',
        line: 3,
        column: 7,
        from: 13,
        to: 19,
        rule: 'f-string',
        name: '',
        instead: '"{}".format(x)',
        severity: 'error',
      },
    ]);
  });

  it('is the same line with the line ends of Windows', () => {
    expect(check({ 'main.py': 'x = 1\r\n\r\nprint(f"{x}")\r\n' })[0]).toMatchObject({ line: 3, column: 7 });
  });

  it('ends with its line where a text goes on over several', () => {
    expect(check({ 'main.py': "x = 1\nf'''a\n{x}'''" })[0]).toMatchObject({ line: 2, from: 6, to: 11 });
  });

  it('comes in the order of the files and their lines', () => {
    const files = { 'main.py': 'import json\nf""\nx = round(3, 1)', 'a.py': 'f""', 'notes.txt': 'f""' };
    expect(check(files).map(({ file, line, rule }) => `${file}:${line} ${rule}`)).toEqual([
      'main.py:1 module-instead',
      'main.py:2 f-string',
      'main.py:3 round-whole',
      'a.py:1 f-string',
    ]);
  });
});

describe('what to write instead of an f-string', () => {
  const instead = (program: string): string | undefined => check({ 'main.py': program })[0]?.instead;

  it('is the same text with format()', () => {
    expect(instead('f"{a} und {b:.2f}"')).toBe('"{} und {:.2f}".format(a, b)');
    expect(instead("f'{name!r:>9}!'")).toBe("'{!r:>9}!'.format(name)");
    expect(instead('f"Hallo"')).toBe('"Hallo"');
    expect(instead('rf"\\d{x[1:2]}"')).toBe('r"\\d{}".format(x[1:2])');
    expect(instead('f"{{}} {x + 1}"')).toBe('"{{}} {}".format(x + 1)');
  });

  it('is a pattern where the text is long or special', () => {
    expect(instead('f"{x=}"')).toBe('"{}".format(x)');
    expect(instead('f"{x:{width}}"')).toBe('"{}".format(x)');
    expect(instead(`f"${'long '.repeat(20)}{x}"`)).toBe('"{}".format(x)');
    expect(instead('f"""a\n{x}"""')).toBe('"{}".format(x)');
  });
});

describe('the pupil’s own files', () => {
  it('win over modules of the same name: import json with a file json.py', () => {
    expect(check({ 'main.py': 'import json\njson.dumps(1)', 'json.py': 'def dumps(x):\n    return x' })).toEqual([]);
    expect(check({ 'main.py': 'import json' })).toHaveLength(1);
  });

  it('may define in one file what another uses', () => {
    const text = 'class Text:\n    def splitlines(self):\n        return []\ndef compile(x):\n    return x\n';
    const main = 'from text import *\nt = Text()\nt.splitlines()\ncompile(1)';
    expect(check({ 'main.py': main, 'text.py': text })).toEqual([]);
    expect(check({ 'main.py': main.replace('from text', 'from other') }).map(({ rule }) => rule)).toEqual([
      'text-method',
      'builtin-name',
    ]);
  });
});

describe('a program that is being typed', () => {
  it('is read as far as it goes, at every character', () => {
    const program = Object.values(pupilsPrograms).join('\n');
    for (let length = 0; length <= program.length; length += 37) {
      const marks = check({ 'main.py': program.slice(0, length) });
      expect(marks, program.slice(Math.max(0, length - 60), length)).toEqual([]);
    }
  });

  it('finds the f-string in half a line', () => {
    expect(rulesIn('print(f"{x}')).toEqual(['f-string']);
    expect(rulesIn('x = 3\nif x:\nprint(f"{x}"')).toEqual(['f-string']);
  });
});

describe('no false alarm', () => {
  it.each(Object.entries(pupilsPrograms))('in the pupil’s program %s', (_name, program) => {
    expect(check({ 'main.py': program })).toEqual([]);
  });

  it.each(['src/robots', 'courses'].flatMap(pythonIn))('in our own %s', (path) => {
    expect(check({ [path]: readFileSync(path, 'utf8') })).toEqual([]);
  });

  it('is raised in thirty thousand characters, which are read in the time of a few frames', () => {
    const long = pupilsPrograms['snake'] ?? '';
    expect(check({ 'main.py': long.repeat(30) })).toEqual([]);
  });
});
