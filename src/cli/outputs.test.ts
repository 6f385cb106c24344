import { chmodSync, existsSync, linkSync, mkdirSync, readdirSync, readFileSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { classToText } from '#school-class/class-file';
import { newClass } from '#school-class/school-class';
import { parseCommand } from './arguments';
import { checkHandIns } from './check/check-command';
import { changeClass } from './class/class-command';
import { commandList } from './commands/commands';
import { convert } from './convert/convert-command';
import { outputProblem } from './outputs';
import { sweep } from './lab/sweep-command';
import { tournament } from './lab/tournament-command';
import { run } from './run';
import { createTerminal } from './terminal';
import { useFolder } from './testing/parcours';

const { folder, file } = useFolder();
const at = (name: string): string => join(folder, name);

describe('files that a command writes', () => {
  const program = file('anna.txt', 'x = 1');
  const problem = (...paths: readonly string[]): string | null =>
    outputProblem(paths.map((path, index) => ({ option: `--o${index}`, path })), [program, at('missing')], 'check'); // prettier-ignore

  it('are never one that it reads: by its path, a link, a hard link, or a linked folder', () => {
    symlinkSync(program, at('soft'));
    linkSync(program, at('hard'));
    symlinkSync(folder, at('again'));
    for (const path of [program, at('soft'), at('hard'), at('again/anna.txt'), `${folder}/./anna.txt`])
      expect(problem(path)).toBe(`--o0: ${path} is read by this check. Choose another name.`);
  });

  it('are no programs, whoever they belong to', () => {
    expect(problem(at('result.PY'))).toBe(`--o0: ${at('result.PY')} is called like a program. Choose another name.`);
  });

  it('are not one file, also where it is not there yet', () => {
    mkdirSync(at('real'));
    symlinkSync(at('real'), at('alias'));
    expect(problem(at('real/r.csv'), at('alias/r.csv'))).toContain('--o0 and --o1:');
    expect(problem(at('r.csv'), at('r.xml'))).toBeNull();
  });

  it('may be no file at all, or not asked for', () => {
    expect(problem('/dev/null', '/dev/null')).toBeNull();
    expect(outputProblem([{ option: '--csv', path: null }], [program], 'run')).toBeNull();
  });
});

describe('a file that cannot be written', () => {
  const problem = (path: string): string | null => outputProblem([{ option: '--csv', path }], [], 'check');

  it('is told before the work: by the folder that is missing, or by what lies there', () => {
    expect(problem(at('nope/deep/r.csv'))).toBe(`--csv: the folder ${at('nope/deep')} does not exist.`);
    expect(problem('nope/r.csv')).toBe('--csv: the folder nope does not exist.');
    expect(problem(folder)).toBe(`--csv: ${folder} is a folder. Name a file in it.`);
    expect(problem(join(file('plain', ''), 'r.csv'))).toContain('a folder and a file are mixed up in this path.');
  });

  it.skipIf(process.getuid?.() === 0)('is told where the rights are missing', () => {
    chmodSync(file('locked.csv', 'kept'), 0o444);
    expect(problem(at('locked.csv'))).toContain('permission denied');
  });

  it('is found by trying, which leaves no file, and an earlier one as it was', () => {
    const before = readdirSync(folder);
    expect(problem(at('new.csv'))).toBeNull();
    expect(readdirSync(folder)).toEqual(before);
    expect(problem(file('earlier.csv', 'kept'))).toBeNull();
    expect(readFileSync(at('earlier.csv'), 'utf8')).toBe('kept');
  });

  it('may lie in a folder that the command makes', () => {
    const inNew = { option: '--resume', path: at('results/list.json'), isInNewFolder: true } as const;
    expect(outputProblem([inNew], [], 'check')).toBeNull();
  });

  const program = file('right.py', 'x = 1\n');
  const lines: Readonly<Record<string, readonly string[]>> = {
    run: ['run', program],
    check: ['check', 'closed-line', program],
    tournament: ['tournament', 'sumo', program, program],
    sweep: ['sweep', program, '--vary', 'seed=1'],
    'class report': ['class', 'report', file('8b.json', classToText(newClass('8b')))],
    convert: ['convert', program],
  };
  const writing = commandList.flatMap(({ name, options }) =>
    Object.entries(options).flatMap(([option, { path }]) => (path === 'writes' ? [{ name, option }] : [])),
  );

  it.each(writing)('ends $name --$option before its work', async ({ name, option }) => {
    let told = '';
    const terminal = createTerminal({ write: (text) => (told += text) }, { write: (text) => (told += text) }, false);
    const asked = parseCommand([...(lines[name] ?? []), `--${option}`, at('nope/file.json')]);
    const carryOut = (): Promise<number> | string => {
      if (asked.type === 'run') return run(asked.options, terminal);
      if (asked.type === 'class report') return changeClass(asked.options, terminal);
      if (asked.type === 'sweep') return sweep(asked.options, terminal);
      if (asked.type === 'tournament') return tournament(asked.options, terminal);
      if (asked.type === 'check') return checkHandIns(asked.options, terminal);
      return asked.type === 'convert' ? convert(asked.options, terminal, () => undefined) : `${name} is not tried here`;
    };
    expect(await carryOut()).toBe(2);
    expect(told).toBe(`parcours: --${option}: the folder ${at('nope')} does not exist.\n`);
    expect(existsSync(at('nope'))).toBe(false);
  });
});
