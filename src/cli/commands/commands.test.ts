import { describe, expect, it } from 'vitest';
import { parseCommand } from '../arguments';
import type { OptionAbout } from './about';
import { commandList, everywhere, type CommandName } from './commands';
import { helpText } from './help';
import { listsWith, valuesOf } from './lists';
import { nearest } from './nearest';

/** The fewest words that each command takes. */
const least: Readonly<Record<CommandName, readonly string[]>> = {
  run: ['main.py'],
  check: ['closed-line', 'class/'],
  sweep: ['main.py', '--vary', 'seed=1..3/1'],
  hint: ['closed-line', 'main.py'],
  tournament: ['sumo', 'a.py', 'b.py'],
  'class add': ['8b.json', 'closed-line', 'class/'],
  'class set': ['8b.json'],
  'class merge': ['8b.json', 'copy.json'],
  'class report': ['8b.json'],
  convert: ['main.py'],
  replay: ['run.json'],
  'probe compare': ['board.csv'],
  completion: ['bash'],
  help: [],
};

/** Options that are nothing without another one. */
const needs: Readonly<Record<string, readonly string[]>> = {
  'check --decimals': ['--table', 't.csv'],
  'class report --decimals': ['--csv', 't.csv'],
  'replay --hit': ['--line', 'main.py:14'],
  'convert --firmware': ['--as', 'hex', '--firmware', 'a.hex'],
  'convert --board': ['--as', 'hex', '--firmware', 'a.hex'],
  'convert --file': ['--as', 'hex', '--firmware', 'a.hex'],
};

/** A value as its name says; a choice that is not the usual one. */
function sampleOf({ value = '', choices }: OptionAbout): string {
  const said: Readonly<Record<string, string>> = {
    TIME: '2s',
    DAY: '2026-12-01',
    'PERCENT|even': '50',
    'TASK=DAY': 'bend=2026-12-01',
    N: '201',
    'N,N': '1,2,3',
    NUMBER: '1',
    'I/N': '2/7',
    '1|2|3|4': '3',
    'FILE:LINE': 'main.py:3',
  };
  if (choices !== undefined)
    return valuesOf(choices, listsWith(['slalom'])).find((one) => !['en', 'league', 'point'].includes(one)) ?? '';
  return said[value] ?? (value.includes('=') ? 'two=b.py' : 'x.json');
}

const around = { variables: {}, today: '2026-11-30' };

describe('the table of commands', () => {
  const rows = commandList.flatMap(({ name, options }) =>
    Object.entries(options).map(([option, about]) => ({ name, option, about })),
  );

  it.each(rows)('$name --$option changes what is asked for', ({ name, option, about }) => {
    const line = [...name.split(' '), ...least[name], ...(needs[`${name} --${option}`] ?? [])];
    // These tell all that is done: nothing else says what is run.
    const isWhole = ['merge', 'verify'].includes(option) ? name.split(' ') : line;
    const typed = about.value === undefined ? [`--${option}`] : [`--${option}`, sampleOf(about)];
    const [before, after] = [parseCommand(line, around), parseCommand([...isWhole, ...typed], around)];
    expect(after).toMatchObject({ type: name });
    expect(after).not.toEqual(before);
  });

  it('has each option with a value in all commands, or in none, and none twice', () => {
    for (const { option, about } of rows) {
      const same = rows.filter((one) => one.option === option);
      expect(same.every((one) => (one.about.value === undefined) === (about.value === undefined))).toBe(true);
      expect(Object.keys(everywhere)).not.toContain(option);
    }
  });

  it('has examples that can be read', () => {
    for (const { name, examples } of commandList)
      for (const example of examples)
        expect(parseCommand(example.split(' '), around), example).toMatchObject({
          type: name === 'help' ? 'help' : name,
        });
  });
});

describe('the help', () => {
  it('lists all commands, and for each of them all its options, in lines of 100 characters', () => {
    const overview = helpText([]);
    for (const { name, summary, options, exits } of commandList) {
      expect(overview).toContain(`  ${name.padEnd(20)}${summary}`);
      const text = helpText(name.split(' '));
      for (const option of Object.keys(options)) expect(text).toMatch(new RegExp(`^ {2}--${option}( |$)`, 'm'));
      for (const code of Object.keys(exits)) expect(text).toMatch(new RegExp(`(Exit code:|;)\\s+${code} `));
      const lines = `${overview}\n${text}`.split('\n');
      expect(lines.filter((line) => line.length > 100 || line.endsWith(' '))).toEqual([]);
    }
  });

  it('names the values that an option may have', () => {
    const text = helpText(['run']);
    expect(text).toMatch(/--robot NAME [^]*one of maqueen-lite, [^]*callibot,[^]* none\n {2}--board/);
    expect(text).toContain('one of de, fr, it, en');
    expect(text).not.toContain('one of on, off');
    expect(text).toMatch(/--file DRIVER\.py [^]*may be given several times\n/);
  });

  it('tells of all commands of a family', () => {
    expect(helpText(['probe'])).toBe(helpText(['probe', 'compare']));
  });
});

describe('the nearest known word', () => {
  const known = ['check', 'convert', 'report', 'resume', 'replay', 'lang', 'at'];

  it.each([
    ['chek', 'check'],
    ['chekc', 'check'],
    ['rapport', 'report'],
    ['language', 'lang'],
    ['conv', 'convert'],
    ['replya', 'replay'],
    ['ta', 'at'],
    ['drive', null],
    ['x', null],
    ['re', null],
  ])('to "%s" is %s', (typed, meant) => expect(nearest(typed, known)).toBe(meant));
});
