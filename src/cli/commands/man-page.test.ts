import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import about from '../../../package.json';
import { useFolder } from '../testing/parcours';
import { commandList } from './commands';
import { manPage } from './man-page';

const hasGroff = spawnSync('groff', ['--version']).status === 0;

/** The page as it is read, in one long line per paragraph. */
function read(page: string): { readonly text: string; readonly warnings: string } {
  const args = ['-man', '-ww', '-Tutf8', '-P-cbou', '-rLL=2000n', '-rHY=0'];
  const { stdout, stderr } = spawnSync('groff', args, { input: page, encoding: 'utf8' });
  return { text: stdout.replaceAll('‐', '-').replaceAll('’', "'"), warnings: stderr };
}

describe('the manual page', () => {
  useFolder(); // says how the command line is built
  const page = manPage('1.2.3');

  it('has the sections that a manual page has, and only signs of ASCII', () => {
    expect(page).toMatch(/^\.TH PARCOURS 1 "" "Parcours 1\.2\.3" "User Commands"\n\.SH NAME\nparcours \\- /);
    expect(Array.from(page.matchAll(/^\.SH (.*)$/gm), ([, title]) => title)).toEqual([
      ...['NAME', 'SYNOPSIS', 'DESCRIPTION', 'COMMANDS', 'OPTIONS', 'EXIT STATUS', 'EXAMPLES'],
    ]);
    expect(page).toMatch(/^[\n -~]*$/);
  });

  it('lies where the package says, in a list, since npm links nothing else', () => {
    expect(readFileSync(about.man[0] ?? '', 'utf8')).toMatch(
      new RegExp(`^\\.TH PARCOURS 1 "" "Parcours ${about.version}"`),
    );
  });

  it.runIf(hasGroff)('says in man what the help says: each command, option, sample, exit code and example', () => {
    const { text, warnings } = read(page);
    expect(warnings).toBe('');
    for (const { name, usage, text: told, options, exits, examples } of commandList) {
      for (const form of usage) expect(text).toContain(`parcours ${name} ${form}`.trimEnd());
      for (const paragraph of told) expect(text).toContain(paragraph);
      for (const [option, { value, help, sample = [] }] of Object.entries(options)) {
        expect(text).toContain(value === undefined ? `--${option}` : `--${option} ${value}`);
        for (const line of [help, ...sample]) expect(text).toContain(line);
      }
      for (const [code, meaning] of Object.entries(exits)) expect(text).toContain(`${code}: ${meaning}`);
      for (const example of examples) expect(text).toContain(`parcours ${example}`);
    }
  });
});
