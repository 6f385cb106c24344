import { spawnSync } from 'node:child_process';
import { mkdtempSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { robotTypes } from '#robots/index';
import { commandList } from '../commands';
import { completionFor } from './completion';

const hasShell = (shell: string): boolean => spawnSync(shell, ['-c', 'true']).status === 0;

/** The lines for which offers are wanted; the last word is what is typed so far. */
const asked = {
  commands: ['parcours', ''],
  begun: ['parcours', 'co'],
  everywhere: ['parcours', '--'],
  second: ['parcours', 'probe', ''],
  options: ['parcours', 'check', 'closed-line', 'class.zip', '--r'],
  robots: ['parcours', 'run', 'main.py', '--robot', ''],
  equals: ['parcours', 'run', '--robot', '=', 'maqueen-p'],
  empty: ['parcours', 'check', '--lang', '='],
  forms: ['npx', 'parcours', 'convert', 'a.py', '--as', 'p'],
  boards: ['parcours', 'convert', '--board', 'calliope'],
  courses: ['parcours', '--json', 'check', 'slal'],
  files: ['parcours', 'check', 'task.json', 'anna.py', 'Ben'],
  value: ['parcours', 'check', '--resume', ''],
  number: ['parcours', 'run', '--seed', ''],
  ended: ['parcours', 'check', 'a', '--', '--r'],
  elsewhere: ['npx', 'vitest', '--r'],
  help: ['parcours', 'help', 'ch'],
};

describe('the completion for bash', () => {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-completion-'));
  afterAll(() => rmSync(folder, { recursive: true }));

  it.runIf(hasShell('bash'))('offers commands, options and their values, courses and files', () => {
    mkdirSync(join(folder, 'results of May'));
    for (const name of ['Ben 1.py', 'Bea.py', '*.py']) writeFileSync(join(folder, name), '');
    writeFileSync(join(folder, 'completion.bash'), completionFor('bash'));
    const tries = Object.entries(asked).map(
      ([name, words]) =>
        `COMP_WORDS=(${words.map((word) => `'${word}'`).join(' ')}) COMP_CWORD=${words.length - 1} COMPREPLY=()
         _parcours${words[0] === 'npx' ? '_npx' : ''}; printf '%s' ${name}; printf '\\t%s' "\${COMPREPLY[@]}"; printf '\\n'`,
    );
    const script = ['set -u', '. ./completion.bash', ...tries].join('\n');
    const { stdout, stderr } = spawnSync('bash', ['--norc', '-c', script], { cwd: folder, encoding: 'utf8' });
    expect(stderr).toBe('');
    const lines = stdout.trimEnd().split('\n').map((line) => line.split('\t')); // prettier-ignore
    const offers = Object.fromEntries(lines.map(([name = '', ...found]) => [name, found.filter((one) => one !== '')]));
    expect(offers).toEqual({
      commands: [...new Set(commandList.map(({ name }) => name.split(' ')[0]))],
      begun: ['convert', 'completion'],
      everywhere: ['--help', '--version'],
      second: ['compare'],
      options: ['--report', '--resume'],
      robots: [...robotTypes.map(({ id }) => id), 'none'],
      equals: ['maqueen-plus-v2', 'maqueen-plus-v3', 'maqueen-plus-v1'],
      empty: ['de', 'fr', 'it', 'en'],
      forms: ['project', 'program'],
      boards: ['calliope-mini-1', 'calliope-mini-3'],
      courses: ['slalom'],
      files: ['Ben 1.py'],
      value: ['results of May'],
      number: [],
      ended: [],
      elsewhere: [],
      help: ['check'],
    });
  });

  it.runIf(hasShell('bash'))('leaves another completion of npx alone', () => {
    const script = `complete -F _other npx\n${completionFor('bash')}\ncomplete -p npx parcours`;
    expect(spawnSync('bash', ['--norc', '-c', script], { encoding: 'utf8' }).stdout).toBe(
      'complete -F _other npx\ncomplete -F _parcours parcours\n',
    );
  });
});

describe('the completion for zsh', () => {
  const script = completionFor('zsh');

  it('has all commands, options and values', () => {
    expect(script.startsWith('#compdef parcours\n')).toBe(true);
    for (const { name, options } of commandList) {
      expect(script).toContain(`    '${name}')`);
      for (const option of Object.keys(options)) expect(script).toMatch(new RegExp(`'\\*?--${option}[=[]`));
    }
    expect(script).toContain(`:NAME:(${[...robotTypes.map(({ id }) => id), 'none'].join(' ')})'`);
    expect(script).toMatch(/:ready course:\([^)]*closed-line/);
  });

  it.runIf(hasShell('zsh'))('is a script that zsh can read', () => {
    const { status, stderr } = spawnSync('zsh', ['-fn', '-c', script], { encoding: 'utf8' });
    expect([status, stderr]).toEqual([0, '']);
  });
});
