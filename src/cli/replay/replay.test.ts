import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { parcours, useFolder } from '../testing/parcours';

const { folder, file } = useFolder();

const PROGRAM = `from mbrobot import *
def turn(n):
    for i in range(n):
        left()
        delay(20)
count = 0
while count < 8:
    forward()
    delay(100)
    turn(3)
    count += 1
    print(count)
`;

/** Records a run and gives the path of its file. */
function record(name: string, ...more: string[]): string {
  const tape = join(folder, name);
  expect(parcours('run', file('main.py', PROGRAM), '--record', tape, '--quiet', ...more)).toMatchObject({
    code: 0,
    err: '',
  });
  return tape;
}

describe('parcours replay', { timeout: 60_000 }, () => {
  it('runs a recorded run again and says that it is the same', () => {
    const tape = record('run.json');
    const { code, out, err } = parcours('replay', tape, '--json', '--quiet');
    expect(code).toBe(0);
    expect(err).toMatch(/^parcours: The same run: 1\.\d+ s, hash [0-9a-f]{16}…\n$/);
    expect(JSON.parse(out)).toMatchObject({
      same: true,
      differs: [],
      changes: [],
      run: { ended: 'finished', console: '1\n2\n3\n4\n5\n6\n7\n8\n' },
    });
  });

  it('does so with several devices, inputs and a course, run for a time', () => {
    const remote = file(
      'remote.py',
      'from microbit import *\nimport radio\nradio.on()\nwhile True:\n    radio.send("go")\n    sleep(100)',
    );
    const inputs = file('inputs.json', '[{ "at": "1s", "device": "remote", "button": "a", "down": true }]');
    const tape = record(
      'two.json',
      '--device',
      `remote=${remote},robot=none`,
      '--input',
      inputs,
      '--for',
      '2s',
      '--seed',
      '7',
      '--reality',
      '0.5',
    );
    expect(parcours('replay', tape, '--quiet').code).toBe(0);
    const { out } = parcours('replay', tape, '--at', '1.5s', '--device', 'remote', '--json');
    expect(JSON.parse(out)).toMatchObject({ file: 'main.py', robot: null });
    expect(JSON.parse(out)).toMatchObject({ timeMs: 1500 });
    expect(parcours('replay', tape, '--device', 'x')).toMatchObject({
      code: 2,
      err: 'parcours: --device: "x" is not in this recording. It has main, remote.\n',
    });
  });

  it('shows a moment: --at a time, or the n-th time that a line begins', () => {
    const tape = record('moment.json');
    const at = JSON.parse(parcours('replay', tape, '--at', '0.25s', '--json').out) as Record<string, unknown>;
    expect(at).toMatchObject({
      timeMs: 250,
      file: 'main.py',
      robot: { type: 'maqueen-lite' },
      globals: { count: { type: 'int', text: '1' } },
    });
    const hit = JSON.parse(parcours('replay', tape, '--line', 'main.py:4', '--hit', '5', '--json').out) as Record<
      string,
      unknown
    >;
    expect(hit).toMatchObject({
      line: 4,
      stack: [
        { function: 'turn', line: 4, locals: { n: { text: '3' }, i: { text: '1' } } },
        { function: '<module>', line: 10 },
      ],
    });
    expect(parcours('replay', tape, '--line', 'main.py:4', '--hit', '5').out).toContain('    i = 1 (int)\n');
  });

  it('says what does not come, and what is not there', () => {
    const tape = record('less.json');
    expect(parcours('replay', tape, '--line', 'main.py:4', '--hit', '99')).toMatchObject({
      code: 1,
      err: 'parcours: not reached: main.py:4 does not begin 99 times in this run.\n',
    });
    expect(parcours('replay', tape, '--line', 'other.py:4')).toMatchObject({
      code: 2,
      err: 'parcours: --line: there is no "other.py" on the board. It has main.py.\n',
    });
    expect(parcours('replay', tape, '--at', '1min').err).toMatch(
      /^parcours: --at: the recording ends after 1\.\d+ s\.\n$/,
    );
    expect(parcours('replay', join(folder, 'none.json'))).toMatchObject({ code: 2 });
    expect(parcours('replay', file('no.json', '[]'))).toMatchObject({
      code: 2,
      err: expect.stringContaining('This is no recorded run'),
    });
  });

  it('says that the run is another one, with exit code 1, when the program was changed since', () => {
    const tape = record('old.json');
    const changed = file('changed.json', readFileSync(tape, 'utf8').replace('count < 8', 'count < 5'));
    const { code, err } = parcours('replay', changed, '--quiet');
    expect(code).toBe(1);
    expect(err).toContain('The program of "main" was changed since the recording.');
    expect(err).toContain('This is not the run that was recorded.');
  });

  it('says that an older physics is why a run comes out differently, and looks into it all the same', () => {
    const text = readFileSync(record('physics.json'), 'utf8');
    const older = text
      .replace(/ *"physics": .*\n/, '')
      .replace(/"traceHash":"\w{64}"/, `"traceHash":"${'0'.repeat(64)}"`);
    const tape = file('older.json', older);
    const { code, err } = parcours('replay', tape, '--quiet');
    expect(code).toBe(1);
    expect(err).toContain('recorded with an older physics of the robots (1; this is 2)');
    expect(parcours('replay', tape, '--at', '0.25s', '--json')).toMatchObject({ code: 0, err: '' });
  });

  it('refuses to write over the program', () => {
    const program = file('own.py', PROGRAM);
    expect(parcours('run', program, '--record', program)).toMatchObject({
      code: 2,
      err: expect.stringContaining('--record'),
    });
    expect(existsSync(program)).toBe(true);
  });
});
