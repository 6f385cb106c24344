import { linkSync, mkdirSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { outputProblem } from './outputs';
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
