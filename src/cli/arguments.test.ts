import { describe, expect, it } from 'vitest';
import { parseCommand } from './arguments';
import type { RunOptions } from './run-arguments';
import { parseDuration } from '#core/duration';

function optionsOf(line: string): RunOptions {
  const command = parseCommand(line.split(' '));
  if (command.type !== 'run') throw new Error(JSON.stringify(command));
  return command.options;
}

function problemOf(line: string): string {
  const command = parseCommand(line === '' ? [] : line.split(' '), { variables: {}, today: '2026-11-30' });
  return command.type === 'bad' ? command.problem : `not bad: ${JSON.stringify(command)}`;
}

describe('the command line', () => {
  it('needs no more than a program', () => {
    expect(optionsOf('run main.py')).toEqual({
      program: 'main.py',
      files: [],
      devices: [],
      scene: null,
      robot: 'auto',
      board: 'auto',
      firmware: '',
      forUs: null,
      seed: null,
      reality: null,
      rules: null,
      senses: null,
      robotOptions: {},
      myRobot: null,
      input: null,
      trace: null,
      record: null,
      log: null,
      untilVerdict: false,
      strict: false,
      lang: 'en',
      json: false,
      quiet: false,
    });
  });

  it('takes every option, before and after the program, and --file several times', () => {
    const line =
      'run --json --file a.py --device remote=r.py,robot=none,option=gamepad,file=c.py --device two=t.py,option=S1=claw main.py --file=b.py --scene s.json --robot none --board microbit-v2 --firmware newest --for 1.5s --seed 7 --reality 0.5 --senses off --option S1=claw --option S1=push --option=model=2E --my-robot p.json --input i.json --trace t.csv --record r.json --log l.csv --until-verdict --strict --lang de --quiet';
    expect(optionsOf(line)).toEqual({
      program: 'main.py',
      files: ['a.py', 'b.py'],
      devices: [
        {
          name: 'remote',
          program: 'r.py',
          files: ['c.py'],
          robot: 'none',
          board: 'auto',
          robotOptions: { inHand: 'gamepad' },
        },
        { name: 'two', program: 't.py', files: [], robot: 'auto', board: 'auto', robotOptions: { S1: 'claw' } },
      ],
      scene: 's.json',
      robot: 'none',
      board: 'microbit-v2',
      firmware: 'newest',
      forUs: 1_500_000,
      seed: 7,
      reality: 0.5,
      rules: null,
      senses: false,
      robotOptions: { S1: 'push', model: '2E' },
      myRobot: 'p.json',
      input: 'i.json',
      trace: 't.csv',
      record: 'r.json',
      log: 'l.csv',
      untilVerdict: true,
      strict: true,
      lang: 'de',
      json: true,
      quiet: true,
    });
  });

  it('shows the help on what is asked, wherever --help stands', () => {
    const helpOn = (line: string) => {
      const asked = parseCommand(line.split(' '));
      return asked.type === 'help' ? asked.options.about.join(' ') : JSON.stringify(asked);
    };
    for (const line of ['--help', '-h', 'help', 'help --help']) expect(helpOn(line)).toMatch(/^(help)?$/);
    for (const line of ['check --help', 'help check', '--help check a b', 'check a --jobs x -h'])
      expect(helpOn(line)).toBe('check');
    for (const line of ['probe --help', 'help probe']) expect(helpOn(line)).toBe('probe');
    expect(helpOn('probe compare a.csv --help')).toBe('probe compare');
    expect(parseCommand(['--version']).type).toBe('version');
    expect(parseCommand(['run', 'main.py', '--version']).type).toBe('version');
  });

  it('takes options of a command also before it, and files called like options behind --', () => {
    expect(optionsOf('--robot none run main.py')).toMatchObject({ program: 'main.py', robot: 'none' });
    expect(parseCommand(['check', 'closed-line', '--json', '--', '-2+3.py', '--help'])).toMatchObject({
      type: 'check',
      options: { json: true, work: { task: 'closed-line', handIns: ['-2+3.py', '--help'] } },
    });
    expect(optionsOf('run main.py --trace -2.csv').trace).toBe('-2.csv');
  });

  it('names the command that tells more', () => {
    const helpOf = (line: string) => {
      const asked = parseCommand(line.split(' '));
      return asked.type === 'bad' ? asked.help : asked.type;
    };
    expect(helpOf('check --rapport x')).toBe('npx parcours check --help');
    expect(helpOf('probe compare')).toBe('npx parcours probe compare --help');
    expect(helpOf('chek')).toBe('npx parcours --help');
  });

  it.each([
    ['', /What shall it do\? For example: parcours run main\.py/],
    ['run', /Which program\?/],
    [
      'drive main.py',
      /^Unknown command "drive"\. There are: run, check, sweep, hint, tournament, class add, [^]*, convert, replay, probe compare, /,
    ],
    ['chek closed-line class/ --json', /^Unknown command "chek"\. Did you mean check\?$/],
    ['chek --help', /^Unknown command "chek"\. Did you mean check\?$/],
    ['help konvert', /^Unknown command "konvert"\. Did you mean convert\?$/],
    ['probe', /^probe: which of its commands\? probe compare$/],
    ['probe compar a.csv', /^Unknown command "probe compar"\. Did you mean probe compare\?$/],
    ['probe compare', /Which output of a board\?/],
    ['run a.py b.py', /what is "b\.py"\? Further files come with --file/],
    [
      'run main.py --turbo 3',
      /^Unknown option --turbo\. Known: --scene, --rules, --robot, [^]*--quiet, --help, --version\.$/,
    ],
    ['check a b --rapport r.html', /^Unknown option --rapport\. Did you mean --report\?$/],
    ['run main.py --until', /^Unknown option --until\. Did you mean --until-verdict\?$/],
    ['run main.py --toString', /^Unknown option --toString\. Known: /],
    ['--rapport', /^Unknown option --rapport\. Did you mean --report\?$/],
    [
      'run main.py --report r.html',
      /^--report is not for run, but for check, sweep, tournament, class report\. run takes --scene, /,
    ],
    ['run main.py --out x', /^--out is not for run, but for convert\. /],
    ['probe compare a.csv --json', /^--json is not for probe compare, but for run, check, [^]* takes none\.$/],
    [
      'check t -2+3.py',
      /^-2\+3\.py begins like an option\. If it is the name of a file, put -- before .*: … -- -2\+3\.py$/,
    ],
    ['check t --anna.py', /^--anna\.py begins like an option\./],
    ['check t -h.py', /^-h\.py begins like an option\./],
    ['check', /^Which task\?/],
    ['check closed-line', /^Which hand-ins\?/],
    ['check closed-line bin --jobs 0', /^--jobs: "0" is not a whole number from 1 to 256\.$/],
    ['check closed-line bin --shard 8/7', /^--shard: "8\/7" is not like 2\/7/],
    ['check closed-line bin --shard auto', /^--shard auto: none of SLURM_ARRAY_TASK_ID/],
    ['check closed-line --merge src', /^--merge runs nothing: what is "closed-line"\?/],
    ['check --merge src --resume src', /^--resume and --merge: choose one of them\.$/],
    ['probe compare a b c', /^Two tables at most: what is "c"\?$/],
    ['completion fish', /There is no completion for "fish"\. Known: bash, zsh\./],
    ['run main.py --scene', /--scene needs a value/],
    ['run main.py --scene --json', /--scene needs a value/],
    ['run main.py --firmware=', /--firmware needs a value/],
    ['run main.py --json=yes', /--json takes no value/],
    ['run main.py --for 20', /--for: "20" has no unit\. Did you mean 20s\?/],
    ['run main.py --for soon', /--for: "soon" is not a time\. Write it like 500ms, 20s or 2min/],
    ['run main.py --for 0s', /no time at all/],
    ['run main.py --for -5s', /not a time|needs a value/],
    ['run main.py --for 2000min', /too long; the limit is 24h/],
    ['run main.py --seed x', /--seed: "x" is not a whole number/],
    ['run main.py --seed 1.5', /--seed: "1\.5" is not a whole number/],
    ['run main.py --lang xx', /--lang: "xx" is not available\. Known: de, fr, it, en\./],
    ['run main.py --reality 2', /--reality: "2" is not a number from 0 to 1/],
    ['run main.py --option claw', /--option: "claw" is not like S1=claw/],
  ])('refuses "%s"', (line, message) => {
    expect(problemOf(line)).toMatch(message);
  });
});

describe('a time', () => {
  it('is written with its unit', () => {
    expect(parseDuration('500ms')).toEqual({ us: 500_000 });
    expect(parseDuration('20s')).toEqual({ us: 20_000_000 });
    expect(parseDuration('2min')).toEqual({ us: 120_000_000 });
    expect(parseDuration('24h')).toEqual({ us: 86_400_000_000 });
    expect(parseDuration('0.25s')).toEqual({ us: 250_000 });
  });

  it('reads where a recorded run shall stop', () => {
    const replay = (...words: string[]) => parseCommand(['replay', 'run.json', ...words]);
    const options = { tape: 'run.json', stop: null, device: null, json: false, quiet: false };
    expect(replay()).toEqual({ type: 'replay', options });
    expect(replay('--at', '3.2s', '--json')).toEqual({
      type: 'replay',
      options: { ...options, stop: { timeUs: 3_200_000 }, json: true },
    });
    expect(replay('--line', 'my:car.py:14', '--hit', '3', '--device', 'remote')).toEqual({
      type: 'replay',
      options: { ...options, stop: { file: 'my:car.py', line: 14, hit: 3 }, device: 'remote' },
    });
  });

  it.each([
    [['replay'], 'Which recording?'],
    [['replay', 'a.json', 'b.json'], 'One recording at a time: what is "b.json"?'],
    [
      ['replay', 'a.json', '--scene', 'x'],
      '--scene is not for replay, but for run, sweep. replay takes --at, --line, ',
    ],
    [['replay', 'a.json', '--at', '3'], '--at: "3" has no unit.'],
    [['replay', 'a.json', '--line', '14'], '--line: "14" is not like main.py:14.'],
    [['replay', 'a.json', '--line', 'main.py:0'], '--line: "main.py:0" is not like main.py:14.'],
    [['replay', 'a.json', '--hit', '2'], '--hit needs a line'],
    [['replay', 'a.json', '--line', 'main.py:1', '--hit', '0'], '--hit: "0" is not a whole number from 1.'],
    [['replay', 'a.json', '--at', '1s', '--line', 'main.py:1'], '--at and --line: choose one of them.'],
    [['run', 'main.py', '--at', '1s'], '--at is not for run, but for replay.'],
  ])('says what is wrong with %j', (words, problem) => {
    const command = parseCommand(words);
    expect(command.type === 'bad' ? command.problem : '').toContain(problem);
  });
});
