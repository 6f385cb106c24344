import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { linkOf } from '#project/link/link';
import { defaultProjectSettings } from '#project/project';
import { defaultScene } from '#scene/scene';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { folder, file } = useFolder();

const remote = file(
  'remote.py',
  'from microbit import *\nimport radio\nradio.on()\nwhile not button_b.is_pressed(): sleep(5)\nradio.send("go")\nprint("sent")\n',
);
const robot = file(
  'robot.py',
  'from mbrobot import *\nimport radio\nradio.on()\nwhile radio.receive() != "go": delay(5)\nforward()\ndelay(500)\nstop()\nprint("there")\n',
);
const press = file(
  'press.json',
  JSON.stringify([
    { at: '200ms', device: 'remote', button: 'b', down: true },
    { at: '350ms', device: 'remote', button: 'b', down: false },
  ]),
);
const DEVICES = ['run', robot, '--device', `remote=${remote}`, '--input', press];

describe('parcours run with --device', { timeout: 60_000 }, () => {
  it('lets a remote control start the robot, and says who prints what', () => {
    expect(parcours(...DEVICES)).toEqual({ code: 0, out: 'remote: sent\nrobot: there\n', err: '' });
  });

  it('tells of each device in "devices", the first one first, and of the first one where it always did', () => {
    const report = lastLine(parcours(...DEVICES, '--json').out);
    expect(report).toMatchObject({ ended: 'finished', console: 'there\n', robot: { type: 'maqueen-lite' } });
    expect(report.devices).toMatchObject([
      { name: 'robot', ended: 'finished', exception: null, console: 'there\n', robot: { type: 'maqueen-lite' } },
      { name: 'remote', ended: 'finished', console: 'sent\n', robot: null, radio: [{ text: 'go' }] },
    ]);
    expect(report.robot?.pathMm).toBeGreaterThan(50);
  });

  it('gives the same line again, but for the time it took', () => {
    const told = () => ({ ...lastLine(parcours(...DEVICES, '--json').out), wallMs: 0, realTimeFactor: 0 });
    expect(told()).toEqual(told());
  });

  it('puts a micro:bit in the hand into a gamepad, and refuses one for what has no slot', () => {
    const pad = file('pad.py', 'from microbit import *\nsleep(300)\nprint(pin1.read_analog(), pin16.read_digital())\n');
    const moves = file(
      'moves.json',
      JSON.stringify([
        { at: '100ms', device: 'pad', stick: { x: -1, y: 0 } },
        { at: '200ms', device: 'pad', gamepad: 'F', down: true },
      ]),
    );
    const calm = file('calm.py', 'pass\n');
    const run = (option: string) =>
      parcours('run', calm, '--device', `pad=${pad},robot=none,${option}`, '--input', moves);
    expect(run('option=gamepad')).toEqual({ code: 0, out: 'pad: 0 0\n', err: '' });
    expect(run('board=microbit-v2')).toMatchObject({
      code: 2,
      err: expect.stringContaining('has no gamepad') as string,
    });
    expect(run('option=paddle')).toMatchObject({
      code: 2,
      err: expect.stringContaining('"paddle" is no choice of inHand. Known: nothing, gamepad.') as string,
    });
    expect(run('option=gamepad,board=calliope-mini-3').code).toBe(2);
  });

  it('has one device, named by its program, without --device', () => {
    const { devices } = lastLine(parcours('run', file('alone.py', 'print(1)'), '--json').out);
    expect(devices).toMatchObject([{ name: 'alone', console: '1\n' }]);
  });

  it('puts the robot of a further device beside the first, with its own driver', () => {
    const driver = file('twice.py', 'def twice(n): return 2 * n\n');
    const second = file('second.py', 'from callibot import *\nfrom twice import twice\nprint(twice(4))\n');
    const { out } = parcours('run', robot, '--device', `two=${second},robot=callibot,file=${driver}`, '--for', '1s', '--json'); // prettier-ignore
    const [first, two] = lastLine(out).devices;
    expect(two).toMatchObject({ console: '8\n', robot: { type: 'callibot', collisions: 0 } });
    expect(two?.robot?.yMm).toBeGreaterThan((first?.robot?.yMm ?? 0) + 100);
  });

  it('takes a project file or a link for a device: the program of its first one, with its robot and microcomputer', () => {
    const text = 'from callibot import *\nprint(BOARD)\n';
    const settings = { ...defaultProjectSettings, device: 'calliope-mini-3', robot: 'callibot' };
    const project = { files: [{ name: 'main.py', text: text.replace('BOARD', '7') }], scene: defaultScene(), course: null, settings }; // prettier-ignore
    const fragment = linkOf(project, { courses: () => null, program: true })?.fragment ?? '';
    for (const work of [
      file('two.json', projectToText(project)),
      file('two.parcours', projectToText(project)),
      `#${fragment}`,
    ]) {
      const { code, out } = parcours('run', robot, '--device', `two=${work}`, '--device', `hand=${work},robot=none,board=microbit-v2`, '--for', '1s', '--json'); // prettier-ignore
      const [, two, hand] = lastLine(out).devices;
      expect(code).toBe(1);
      expect(two).toMatchObject({ console: '7\n', robot: { type: 'callibot' } });
      expect(hand?.robot).toBeNull();
    }
  });

  it('writes the device into each line of the trace', () => {
    const trace = join(folder, 'both.csv');
    parcours('run', robot, '--device', `too=${robot},robot=maqueen-plus-v2`, '--for', '100ms', '--trace', trace);
    const [header = '', first = '', second = ''] = readFileSync(trace, 'utf8').split('\n');
    expect(header).toMatch(/^t_ms,.*,collisions,device$/);
    expect([first, second].map((line) => line.split(',').at(-1))).toEqual(['robot', 'too']);
    expect(first.split(',').length).toBe(header.split(',').length);
  });

  it('says with --strict of each device what its board would not understand, and with --quiet what ended it', () => {
    const ok = file('fits.py', 'print(1)\n');
    const modern = `new=${file('modern.py', 'x = 3\nprint(f"{x}")\n')}`;
    const strict = parcours('run', ok, '--device', modern, '--strict');
    expect(strict).toMatchObject({ code: 1, out: '', err: expect.stringMatching(/^new: main\.py:2:7: .*f-strings/) as string }); // prettier-ignore
    const { code, out, err } = parcours('run', ok, '--device', `bad=${file('fails.py', '1/0')}`, '--quiet');
    expect([code, out]).toEqual([1, '']);
    expect(err).toContain('bad: ZeroDivisionError: divide by zero');
  });

  it('ends with 1 when the program of any device fails', () => {
    expect(parcours('run', file('ok.py', 'pass'), '--device', `bad=${file('bad.py', '1/0')}`).code).toBe(1);
  });

  it.each([
    [['--device', ` =${remote}`], '--device: " " cannot be the name of a device. Take one without quotes'],
    [['--device', 'remote'], '--device: "remote" is not like remote=remote.py,robot=none.'],
    [
      ['--device', `a=${remote},speed=3`],
      '--device a: "speed=3" is unknown here. Known: robot=ID, board=ID, option=CHOICE, file=DRIVER.py.',
    ],
    [
      ['--device', `a=${remote},robot=tank`],
      /^parcours: --device a: Unknown robot "tank"\. Known robots: maqueen-lite, /,
    ],
    [
      ['--device', `a=${remote}`, '--device', `a=${remote}`],
      'Two devices are named "a". Give one of them another name.',
    ],
    [['--device', 'a=missing.py'], /missing\.py: /],
    [
      Array.from({ length: 8 }, (_, n) => ['--device', `d${n}=${remote}`]).flat(),
      '9 devices are too many: at most 8 share a run. Take some away.',
    ],
    [
      [
        '--device',
        `a=${remote}`,
        '--input',
        file('wrong.json', '[{"at": "1s", "device": "b", "button": "a", "down": true}]'),
      ],
      'There is no device "b". Known are "robot", "a".',
    ],
  ] as const)('refuses %j', (args, message) => {
    const { code, err } = parcours('run', robot, ...args);
    expect(code).toBe(2);
    if (typeof message === 'string') expect(err).toContain(message);
    else expect(err).toMatch(message);
  });
});
