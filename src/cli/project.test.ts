import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { linkOf } from '#project/link/link';
import { anyHardware, defaultProjectSettings, type Project } from '#project/project';
import { parseScene } from '#scene/parse';
import { defaultScene, type Scene } from '#scene/scene';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { file } = useFolder();

const target = { type: 'target', id: 't', at: [800, 450], size: [120, 120], angle: 0, round: false, number: 0, blocks: 0 } as const; // prettier-ignore
const scene: Scene = { ...defaultScene(), objects: [target] };
const project: Project = {
  files: [
    { name: 'main.py', text: 'from drive import go\ngo()\n' },
    {
      name: 'drive.py',
      text: 'from callibot import *\ndef go():\n  forward()\n  delay(1600)\n  stop()\n  print("there")\n',
    },
  ],
  scene,
  course: null,
  settings: { ...defaultProjectSettings, device: 'calliope-mini-3', robot: 'callibot' },
};
const squareScene = (): Scene => {
  const parsed = parseScene(readFileSync('courses/square/scene.json', 'utf8'));
  if ('scene' in parsed) return parsed.scene;
  throw new Error(parsed.problem);
};
const anna = file('anna.parcours.json', projectToText(project));
const link = `https://example.org/parcours/#${linkOf(project, { courses: () => null, program: true })?.fragment ?? ''}`;

describe('parcours run with a project', { timeout: 60_000 }, () => {
  it.each([
    ['file', anna],
    ['link', link],
  ])('from a %s runs its program with its files, course, robot and microcomputer', (_, work) => {
    const report = lastLine(parcours('run', work, '--json').out);
    expect(report).toMatchObject({ ended: 'finished', console: 'there\n', robot: { type: 'callibot' } });
    expect(report.verdict).toMatchObject({ state: 'passed' });
  });

  it('names its device by the file', () => {
    expect(lastLine(parcours('run', anna, '--json').out).devices[0]?.name).toBe('anna');
  });

  it('lets all of several devices run, and adds those of --device', () => {
    const remote = { name: 'main.py', text: 'import radio\nradio.on()\nradio.send("go")\n' };
    const robot = { name: 'main.py', text: 'from callibot import *\nimport radio\nradio.on()\nwhile radio.receive() != "go": delay(5)\nprint("started")\n' }; // prettier-ignore
    const further = { ...anyHardware, sameAs: '', robot: 'none', name: 'Hand', files: [remote] };
    const pair = file('pair.json', projectToText({ ...project, files: [robot], devices: { first: 'Robi', others: [further] } })); // prettier-ignore
    expect(parcours('run', pair).out).toContain('Robi: started\n');
    const third = file('third.py', 'print("here")\n');
    const { devices } = lastLine(parcours('run', pair, '--device', `third=${third}`, '--json').out);
    expect(devices.map(({ name, ended, robot: body }) => [name, ended, body?.type])).toEqual([
      ['Robi', 'finished', 'callibot'],
      ['Hand', 'finished', undefined],
      ['third', 'finished', undefined],
    ]);
    const wrong = file('wrong.json', projectToText({ ...project, devices: { first: 'Robi', others: [{ ...further, robot: 'k9' }] } })); // prettier-ignore
    expect(parcours('run', wrong)).toMatchObject({ code: 2, err: expect.stringContaining('device "Hand": Unknown robot "k9"') as string }); // prettier-ignore
  });

  it('takes what the command line says instead', () => {
    const empty = file('empty.json', JSON.stringify({ format: 'parcours-scene', version: 1 }));
    const report = lastLine(parcours('run', anna, '--scene', empty, '--robot', 'none', '--for', '10ms', '--json').out);
    expect(report).toMatchObject({ robot: null, verdict: null });
  });

  it('is as used as the project says, and ideal when the command line says so', () => {
    const settings = { ...defaultProjectSettings, robot: 'callibot', reality: 1, seed: 9 };
    const used = file('used.json', projectToText({ ...project, settings }));
    const endOf = (...more: readonly string[]) => lastLine(parcours('run', used, '--json', ...more).out).robot;
    expect(endOf('--reality', '0')).toEqual(lastLine(parcours('run', anna, '--json').out).robot);
    expect(endOf()).not.toEqual(endOf('--reality', '0'));
    expect(endOf()).toEqual(lastLine(parcours('run', anna, '--reality', '1', '--seed', '9', '--json').out).robot);
  });

  it('opens a ready course that a link only names', () => {
    const ready = linkOf({ ...project, course: 'square', scene: squareScene() }, { courses: (id) => (id === 'square' ? squareScene() : null), program: true }); // prettier-ignore
    const { verdict } = lastLine(parcours('run', `#${ready?.fragment ?? ''}`, '--for', '10ms', '--json').out);
    expect(verdict).not.toBeNull();
  });

  it('takes a link of WebTigerPython', () => {
    const { code, err } = parcours('run', 'https://webtigerpython.ethz.ch/?code=damaged');
    expect([code, err]).toEqual([2, expect.stringMatching(/^parcours: https:.*The link cannot be opened\. /)]);
  });

  it.each([
    [
      'course.json',
      JSON.stringify({ format: 'parcours-scene', version: 1 }),
      'is a course without a program. Give it with --scene, and name a program.',
    ],
    [
      'run.json',
      '{ "format": "parcours-tape", "version": 1, "setup": {',
      'is a recorded run. Run it again with parcours replay.',
    ],
    ['else.json', '{"a": 1}', 'This is neither a project nor a course'],
    ['cut.json', projectToText(project).slice(0, 200), 'not JSON'],
  ])('refuses %s with a sentence', (name, text, message) => {
    const path = file(name, text);
    const { code, err } = parcours('run', path);
    expect(code).toBe(2);
    expect(err).toContain(path);
    expect(err).toContain(message);
  });

  it('is told what is wrong with it, also as a course; a file of ours without its ending is no program', () => {
    const wrong = file('wrong.parcours', projectToText(project).replace('"name": "drive.py"', '"nom": "x"').replace('"version": 1', '"version": 99')); // prettier-ignore
    for (const words of [[wrong], [anna, '--scene', wrong]]) {
      const { code, err } = parcours('run', ...words);
      expect([code, err]).toEqual([2, expect.stringContaining('Project version 99 is newer than this app')]);
    }
  });

  it('takes a name as the id of a ready course, also if a folder of that name exists', () => {
    const bin = fileURLToPath(new URL('../../bin/parcours.mjs', import.meta.url));
    const words = ['run', 'square/main.py', '--scene', 'square', '--until-verdict', '--quiet'];
    expect(spawnSync(process.execPath, [bin, ...words], { cwd: 'courses' }).status).toBe(0);
    expect(spawnSync(process.execPath, [bin, 'check', 'square', 'square/main.py'], { cwd: 'courses' }).status).toBe(0);
  });

  it.each([
    ['https://example.org/', 'The address holds neither a project nor a program. Copy the whole link.'],
    [link.slice(0, -5), 'The link cannot be opened. '],
  ])('refuses the address %s with a sentence', (address, message) => {
    const { code, err } = parcours('run', address);
    expect(code).toBe(2);
    expect(err).toContain(message);
  });
});
