import { spawn, spawnSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { folder, file } = useFolder();

const scene = (change: object): string => JSON.stringify({ format: 'parcours-scene', version: 1, ...change });
const wall = { id: 'w', type: 'wall', from: [0, 0], to: [100, 0] };

describe('parcours run', { timeout: 30_000 }, () => {
  const hello = file('hello.py', "print('hello')\n");

  it('prints what the program prints and exits with 0', () => {
    expect(parcours('run', hello)).toEqual({ code: 0, out: 'hello\n', err: '' });
  });

  it('prints one line with everything after --json, on a line of its own', () => {
    const { out } = parcours('run', file('half.py', "print('half a line', end='')"), '--json');
    expect(out.split('\n')).toHaveLength(3);
    const report = lastLine(out);
    expect(Object.keys(report)).toEqual([
      ...[
        'ended',
        'exception',
        'simulatedMs',
        'wallMs',
        'realTimeFactor',
        'robot',
        'display',
        'verdict',
        'console',
        'heapFree',
        'traceHash',
        'devices',
      ],
    ]);
    expect(Object.keys(report.robot ?? {})).toEqual([
      ...['type', 'xMm', 'yMm', 'headingDeg', 'turnedDeg', 'pathMm', 'collisions', 'leds', 'rgb', 'lamps', 'servos'],
    ]);
    expect(report).toMatchObject({ ended: 'finished', exception: null, console: 'half a line' });
    expect(report.robot).toMatchObject({ type: 'maqueen-lite', xMm: 600, yMm: 450, headingDeg: 0 });
    expect(report.display).toBe('00000:00000:00000:00000:00000');
    expect(report.traceHash).toMatch(/^[0-9a-f]{64}$/);
  });

  it('writes a trace over nothing that the run reads, and over no earlier trace when it is refused', () => {
    const program = file('traced.py', 'print(1)\n');
    const earlier = file('earlier.csv', 'kept');
    expect(parcours('run', program, '--trace', program).code).toBe(2);
    expect(parcours('run', program, '--trace', earlier, '--robot', 'tank').code).toBe(2);
    expect([readFileSync(program, 'utf8'), readFileSync(earlier, 'utf8')]).toEqual(['print(1)\n', 'kept']);
    expect(parcours('run', program, '--trace', earlier).code).toBe(0);
    expect(readFileSync(earlier, 'utf8')).toMatch(/^t_ms,/);
  });

  it('tells whether the task of the course is done, to people in a line, to programs as "verdict"', () => {
    const program = file('task.py', 'from mbrobot import *\nforward()\ndelay(3000)\nstop()\n');
    const target = { id: 't', type: 'target', at: [800, 450], size: [100, 100] };
    const course = file('task.json', scene({ version: 2, objects: [target] }));
    const { code, err } = parcours('run', program, '--scene', course);
    expect(code).toBe(0);
    expect(err).toMatch(/^Task: passed after \d\.\d s\.\n$/);
    const { out, err: nothing } = parcours('run', program, '--scene', course, '--json');
    expect(nothing).toBe('');
    expect(lastLine(out).verdict).toMatchObject({ state: 'passed', targets: { reached: 1, of: 1 } });
    expect(parcours('run', program, '--scene', course, '--quiet').err).toBe('');
  });

  it('gives the same trace hash twice, and another one for another program', () => {
    const drive = file('drive.py', 'from mbrobot import *\nforward()\ndelay(500)\nright()\ndelay(300)\nstop()\n');
    const hash = () => lastLine(parcours('run', drive, '--json', '--for', '1s').out).traceHash;
    expect(hash()).toBe(hash());
  });

  it('tells type, message, line and traceback of an exception and exits with 1', () => {
    const { code, out } = parcours('run', file('bad.py', 'x = 1\nprint(y)\n'), '--json');
    expect(code).toBe(1);
    expect(out).toContain('File "main.py", line 2, in <module>');
    const { exception } = lastLine(out);
    expect(exception).toMatchObject({ type: 'NameError', line: 2 });
    expect(exception?.message).toMatch(/y/);
    expect(exception?.traceback).toMatch(/^Traceback \(most recent call last\):\n {2}File "main\.py", line 2/);
  });

  it('says what an error means, as the console and a check do, in the language that is asked for', () => {
    const loop = 'from mbrobot import *\nrepeat 4:\n    forward()\n    delay(500)\n';
    const said = 'repeat gehört zu TigerJython. Hier heisst es: for i in range(4):';
    const { code, out, err } = parcours('run', file('repeat.py', loop), '--json', '--lang', 'de');
    expect([code, err]).toEqual([1, `parcours: ${said}\n`]);
    expect(lastLine(out).exception).toMatchObject({ type: 'SyntaxError', line: 2, advice: said });
    const helper = file('helper.py', loop);
    const two = parcours('run', file('fine.py', 'x = 1\n'), '--device', `two=${helper}`);
    expect(two.err).toContain('parcours: two: repeat belongs to TigerJython. Here you write: for i in range(4):\n');
  });

  it('shows a syntax error with its line and exits with 1', () => {
    const { code, out } = parcours('run', file('syntax.py', 'x = 1\nif x y:\n  pass\n'));
    expect(code).toBe(1);
    expect(out).toMatch(/File "main\.py", line 2[^]*SyntaxError: invalid syntax/);
  });

  it('finishes soon after the program, or exactly when --for says', () => {
    const short = lastLine(parcours('run', hello, '--json').out);
    expect(short.simulatedMs).toBeLessThan(100);
    const long = lastLine(parcours('run', hello, '--json', '--for', '2s').out);
    expect(long).toMatchObject({ ended: 'finished', simulatedMs: 2000 });
    const cut = lastLine(parcours('run', file('loop.py', 'while True: pass'), '--json', '--for', '300ms').out);
    expect(cut.ended).toBe('time-limit');
    expect(cut.simulatedMs).toBeGreaterThanOrEqual(300);
    expect(cut.simulatedMs).toBeLessThan(301);
  });

  it('puts further files on the board by their base name, and the program may import them', () => {
    const driver = file('my_driver.py', 'def answer(): return 42\n');
    const program = file('uses.py', 'import os, my_driver\nprint(my_driver.answer(), os.listdir())\n');
    expect(parcours('run', program, '--file', driver).out).toMatch(/^42 \[.*'my_driver\.py'.*\]\n$/);
  });

  it('does at each time what the input file says', () => {
    const input = file(
      'input.json',
      '[{"at":"200ms","button":"a","down":true},{"at":"400ms","serial":"hi\\r\\n"},{"at":"100ms","sensor":"temperature","value":-3}]',
    );
    const program = file(
      'input.py',
      'from microbit import *\nsleep(150)\nprint(temperature())\nwhile not button_a.is_pressed(): sleep(1)\nprint("a", running_time() // 100)\nprint(input())\n',
    );
    expect(parcours('run', program, '--input', input).out).toMatch(/^-3\na 2\nhi\r?\nhi\n$/);
  });

  it('writes the way of the robot, one line per 20 ms', () => {
    const trace = join(folder, 'trace.csv');
    expect(parcours('run', hello, '--for', '1s', '--trace', trace).code).toBe(0);
    const rows = readFileSync(trace, 'utf8').trimEnd().split('\n');
    expect(rows[0]).toMatch(/^t_ms,x_mm,y_mm,heading_deg,left_mm_s,right_mm_s,/);
    expect(rows).toHaveLength(52);
    expect(rows[51]).toMatch(/^1000,600,450,0,0,0,/);
  });

  it('says nothing of the program with --quiet, except its error', () => {
    expect(parcours('run', hello, '--quiet')).toEqual({ code: 0, out: '', err: '' });
    const { code, out, err } = parcours('run', file('quiet.py', '1/0'), '--quiet');
    expect({ code, out }).toEqual({ code: 1, out: '' });
    expect(err).toContain('ZeroDivisionError');
  });

  it('runs the bare board with --robot none', () => {
    const report = lastLine(parcours('run', hello, '--robot', 'none', '--json').out);
    expect(report.robot).toBeNull();
  });

  it('takes a program of 64 kB: it runs, or the board says that it is out of memory', () => {
    const { code, out } = parcours('run', file('big.py', `${'# comment\n'.repeat(6_400)}print("done")\n`));
    expect({ code, out }).toEqual({ code: 0, out: 'done\n' });
    const full = parcours('run', file('full.py', Array.from({ length: 4_000 }, (_, n) => `v${n} = "${n}"\n`).join('')));
    expect(full.code).toBe(1);
    expect(full.out).toContain('MemoryError');
  });
});

describe('files that a run writes', { timeout: 30_000 }, () => {
  const hello = file('written.py', "print('hello')\n");

  it('never overwrite what it reads, whatever links lead there', () => {
    symlinkSync(hello, join(folder, 'link.csv'));
    const { code, err } = parcours('run', hello, '--trace', join(folder, 'link.csv'));
    expect(code).toBe(2);
    expect(err).toContain('is read by this run');
    expect(readFileSync(hello, 'utf8')).toBe("print('hello')\n");
  });

  it('are not the same for the trace and the log', () => {
    const { code, err } = parcours(
      'run',
      hello,
      '--trace',
      join(folder, 'both.csv'),
      '--log',
      join(folder, 'both.csv'),
    );
    expect(code).toBe(2);
    expect(err).toContain('can be only one of them');
  });

  it('may be what is no file, such as /dev/null', () => {
    expect(parcours('run', hello, '--trace', '/dev/null', '--log', '/dev/null').code).toBe(0);
  });

  it.runIf(existsSync('/dev/full'))('end the run with a sentence when the disk is full', () => {
    const { code, err } = parcours('run', hello, '--trace', '/dev/full');
    expect(code).toBe(2);
    expect(err).toBe('parcours: A result cannot be written: the disk is full.\n');
  });
});

describe('parcours run with something wrong', { timeout: 30_000 }, () => {
  const hello = file('fine.py', "print('hello')\n");
  const table: readonly [what: string, args: readonly string[], message: RegExp][] = [
    ['a missing program', ['nowhere.py'], /^parcours: nowhere\.py: there is no such file\.\n$/],
    ['a folder as program', [folder], /is a folder/],
    [
      '10 MB of text as program',
      [file('huge.py', 'x = 1\n'.repeat(1_700_000))],
      /huge\.py: has 10200000 bytes; the limit is 262144/,
    ],
    ['a program that is no text', [file('photo.py', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0))], /is not text in UTF-8/],
    ['a program without end', ['/dev/zero'], /\/dev\/zero: has more than 262144 bytes/],
    ['signs that steer a terminal', ['\u001b[31mred.py'], /^parcours: \\x1b\[31mred\.py: there is no such file/],
    ['a missing driver', [hello, '--file', 'nothing.py'], /nothing\.py: there is no such file/],
    ['a driver twice', [hello, '--file', hello, '--file', hello], /there is already a file "fine\.py" on the board/],
    ['an unknown robot', [hello, '--robot', 'tank'], /Unknown robot "tank"\. Known robots: maqueen-lite/],
    ['an unknown board', [hello, '--board', 'x'], /Unknown board "x"\. Known boards: microbit-v2/],
    [
      'a course by a wrong id',
      [hello, '--scene', 'gat'],
      /gat: there is no such file\. There is no ready course "gat" either\. Did you mean gate\?/,
    ],
    ['a missing course', [hello, '--scene', 'no.json'], /no\.json: there is no such file/],
    [
      'a course that is not JSON',
      [hello, '--scene', file('a.json', '{\n "format": parcours }')],
      /a\.json: .*not JSON: line 2, column 12/,
    ],
    [
      'a newer course',
      [hello, '--scene', file('b.json', scene({ version: 9 }))],
      /Scene version 9 is newer than this app \(8\)/,
    ],
    [
      'a wall of length 0',
      [hello, '--scene', file('c.json', scene({ objects: [{ ...wall, to: [0, 0] }] }))],
      /objects\[0\]\.to: the wall has length 0/,
    ],
    [
      'a robot inside a wall',
      [hello, '--scene', file('d.json', scene({ objects: [{ ...wall, from: [600, 400], to: [600, 500] }] }))],
      /d\.json: robot\.at: at \[600, 450\] the robot stands inside the wall "w" \(objects\[0\]\)/,
    ],
    [
      'an unknown robot in the course',
      [hello, '--scene', file('tank.json', scene({ robot: { type: 'tank' } }))],
      /tank\.json: robot\.type: Unknown robot "tank"\. Known robots: maqueen-lite/,
    ],
    [
      'an unknown board in the course',
      [hello, '--scene', file('x.json', scene({ board: 'x' }))],
      /x\.json: board: Unknown board "x"\. Known boards: microbit-v2/,
    ],
    ['10 MB of course', [hello, '--scene', file('e.json', ' '.repeat(10_000_000))], /e\.json: .*the limit is 8000000/],
    ['inputs that are not JSON', [hello, '--input', file('f.json', 'x')], /f\.json: is not JSON/],
    [
      'an input of an unknown sensor',
      [hello, '--input', file('g.json', '[{"at":"1s","sensor":"smell","value":1}]')],
      /g\.json: \[0\]: There is no sensor "smell"/,
    ],
    [
      'an edit that is none',
      [hello, '--input', file('h.json', '[{"at":"1s","edit":{"type":"add","objects":[{"type":"tree"}]}}]')],
      /h\.json: \[0\]\.edit\.objects\[0\]\.type: "tree" is unknown\. Known: wall, /,
    ],
    [
      'an edit of what is not there',
      [hello, '--input', file('i.json', '[{"at":"1s","edit":{"type":"remove","ids":["w"]}}]')],
      /i\.json: \[0\]: edit\.ids\[0\]: there is no object "w"/,
    ],
    [
      'a trace in no folder',
      [hello, '--trace', join(folder, 'no', 'trace.csv')],
      /^parcours: --trace: the folder .*no does not exist\.\n$/,
    ],
  ];
  it('names the option that was probably meant, and the help on the command', () => {
    expect(parcours('run', hello, '--trase', 'x.csv')).toEqual({
      ...{ code: 2, out: '' },
      err: 'parcours: Unknown option --trase. Did you mean --trace?\nHelp: npx parcours run --help\n',
    });
  });

  it.each(table)('%s: says so and exits with 2', (_what, args, message) => {
    const { code, out, err } = parcours('run', ...args);
    expect({ code, out }).toEqual({ code: 2, out: '' });
    expect(err).toMatch(message);
    expect(err).not.toMatch(/\n +at /);
  });
});

describe('a run that does not end', { timeout: 40_000 }, () => {
  async function interrupted(program: string): Promise<{ code: number | null; out: string; answeredMs: number }> {
    const child = spawn(process.execPath, ['bin/parcours.mjs', 'run', file('endless.py', program), '--json']);
    let out = '';
    let sentMs = 0;
    child.stdout.setEncoding('utf8').on('data', (text: string) => {
      if (out === '') {
        sentMs = performance.now();
        child.kill('SIGINT');
      }
      out += text;
    });
    const code = await new Promise<number | null>((resolve) => child.on('close', resolve));
    return { code, out, answeredMs: performance.now() - sentMs };
  }

  it.each([
    ["print('go')\nwhile True: pass"],
    ["while True: print('go')"],
    ["print('go')\nwhile True:\n  try:\n    while True: pass\n  except: pass"],
    ["print('go')\nsum(map(sum, [range(10**9)] * 100))"],
  ])('is stopped by Ctrl-C: %j', async (program) => {
    const { code, out } = await interrupted(program);
    expect(code).toBe(1);
    expect(lastLine(out).ended).toBe('stopped');
  });

  it('is ended as stuck when its thread gives no sign of life', () => {
    const copy = join(folder, 'hung');
    cpSync('dist/cli', copy, { recursive: true });
    writeFileSync(join(copy, 'worker.mjs'), 'setInterval(() => {}, 1000);');
    const program = file('stuck.py', "print('never')");
    const { status, stdout, stderr } = spawnSync(process.execPath, [join(copy, 'main.mjs'), 'run', program, '--json'], {
      encoding: 'utf8',
    });
    expect(status).toBe(1);
    expect(lastLine(stdout)).toMatchObject({ ended: 'stuck', console: '' });
    expect(stderr).toContain('no sign of life');
  });

  it('is not stuck in a long call inside the interpreter: its time passes', () => {
    const program = file('long.py', "print('go')\nsum(map(sum, [range(10**9)] * 100))");
    const { code, out } = parcours('run', program, '--for', '3s', '--json');
    expect(code).toBe(0);
    // The limit takes effect with the next few µs of work, which are charged together.
    const simulatedMs: unknown = expect.closeTo(3000, 1);
    expect(lastLine(out)).toMatchObject({ ended: 'time-limit', console: 'go\n', simulatedMs });
  });
});
