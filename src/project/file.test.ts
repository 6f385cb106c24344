import { readFileSync } from 'node:fs';

import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';

import { parseProject, parseProjectValue, projectToText } from './file';
import type { ProjectProblem } from './problem';
import { FILE_BYTES, utf8Bytes, type Project } from './project';
import { classProject, devicesProject, fullProject, handedInProject, measuredProject } from './testing/projects';

const kept = (name: string): string => readFileSync(new URL(`kept/${name}`, import.meta.url), 'utf8');
const small: Project = { files: [{ name: 'main.py', text: 'print(1)\n' }], scene: defaultScene(), course: null };
const asValue = (project: Project): Record<string, unknown> =>
  JSON.parse(projectToText(project)) as Record<string, unknown>;

function problemsOf(value: unknown): readonly ProjectProblem[] {
  const parsed = typeof value === 'string' ? parseProject(value) : parseProjectValue(value);
  return 'problems' in parsed ? parsed.problems : [];
}

describe('a project file', () => {
  it('gives back what was saved: files, course, robot and settings', () => {
    for (const project of [
      small,
      fullProject(),
      measuredProject(),
      devicesProject(),
      { ...small, course: 'closed-line' },
    ])
      expect(parseProject(projectToText(project))).toEqual({ project });
  });

  it('is readable, and the same project always gives the same text', () => {
    const text = projectToText(small);
    expect(text.split('\n').slice(0, 6)).toEqual([
      '{',
      '  "format": "parcours-project",',
      '  "version": 1,',
      '  "files": [',
      '    {"name":"main.py","text":"print(1)\\n"}',
      '  ],',
    ]);
    expect(text).toContain('\n  "scene": {\n    "format": "parcours-scene",\n');
    expect(projectToText(fullProject())).toBe(projectToText(fullProject()));
  });

  it('opens as it always did in version 1', () => {
    expect(parseProject(kept('v1.json'))).toEqual({ project: fullProject() });
  });

  it('opens as it always did in version 2, with the pupil’s own robot; without one it is still of version 1', () => {
    expect(parseProject(kept('v2.json'))).toEqual({ project: measuredProject() });
    expect(projectToText(measuredProject())).toBe(kept('v2.json'));
    expect(projectToText(fullProject())).toContain('"version": 1,');
  });

  it('opens as it always did in version 3, with several devices', () => {
    expect(parseProject(kept('v3.json'))).toEqual({ project: devicesProject() });
    expect(projectToText(devicesProject())).toBe(kept('v3.json'));
  });

  it('opens as it always did in version 4, with the data of a task; a hand-in is of that version, too', () => {
    expect(parseProject(kept('v4.json'))).toEqual({ project: classProject() });
    expect(projectToText(classProject())).toBe(kept('v4.json'));
    expect(projectToText(handedInProject())).toContain('"version": 4,');
    expect(parseProject(projectToText(handedInProject()))).toEqual({ project: handedInProject() });
  });

  it('carries no data of a task that is none, too deep or too long', () => {
    const deep = JSON.parse(`${'{"a":'.repeat(40)}1${'}'.repeat(40)}`) as unknown;
    const codes = [7, [], deep, { a: 'x'.repeat(2_000_001) }].map(
      (task) => problemsOf({ ...asValue(small), task })[0]?.code,
    );
    expect(codes).toEqual(['wrong-type', 'wrong-type', 'too-many', 'too-long']);
  });

  it('names the device, and the way out, where devices do not fit together', () => {
    const { devices } = devicesProject();
    const [remote, third] = devices?.others ?? [];
    const wrong = (...others: readonly object[]): readonly string[] =>
      problemsOf({ ...asValue(small), devices: { first: 'Roboter', others } }).map(({ message }) => message);
    const own = { ...remote, sameAs: undefined };
    const third2 = { ...third, files: undefined };
    expect(wrong(own, third2)).toEqual([]);
    expect(wrong({ ...own, name: 'Roboter' })).toEqual([
      'devices.others[0].name: "Roboter" cannot be the name of a device: another device has it.',
    ]);
    expect(wrong({ ...own, name: '' })[0]).toContain('it is empty');
    expect(wrong({ ...own, name: 'a=b' })[0]).toContain('none of , = "');
    expect(wrong({ ...third2, sameAs: 'Ärzt 2' })).toEqual([
      'devices.others[0].sameAs: "Ärzt 2" cannot run the program of "Ärzt 2". Name another device that has files of its own.',
    ]);
    expect(wrong({ ...third2, sameAs: 'Zoe' })[0]).toContain('cannot run the program of "Zoe"');
    expect(wrong({ ...own, sameAs: 'Roboter' })[0]).toContain('files of its own or "sameAs", not both');
    expect(wrong({ ...own, files: [] })[0]).toBe('devices.others[0].files: 0 entries; there may be 1 … 20.');
    expect(wrong()[0]).toBe('devices.others: 0 entries; there may be 1 … 7.');
    expect(wrong(...Array.from({ length: 8 }, (_, at) => ({ ...own, name: `R${String(at)}` })))[0]).toBe(
      'devices: 9 devices are too many: at most 8 share a run. Take some away.',
    );
  });

  it('names what cannot be about the pupil’s own robot', () => {
    const project = measuredProject();
    const wrong = (change: object): readonly ProjectProblem[] =>
      problemsOf({
        ...asValue(project),
        settings: { ...project.settings, myRobot: { ...project.settings?.myRobot, ...change } },
      });
    expect(wrong({ name: 'x'.repeat(41) })[0]).toMatchObject({ code: 'too-long', path: 'settings.myRobot.name' });
    expect(wrong({ traits: null })[0]).toMatchObject({ path: 'settings.myRobot.traits' });
    const alike = { ...project.settings?.myRobot?.measured, line: { M: { black: 7, floor: 7 } } };
    expect(wrong({ measured: alike })[0]?.message).toBe(
      'settings.myRobot.measured.line.M: 7 on black and on white alike: the sensor sees no difference.',
    );
  });

  it('asks to reload the page if it is of a newer version', () => {
    const [problem] = problemsOf({ ...asValue(small), version: 7 });
    expect(problem).toMatchObject({ code: 'newer-version', params: { version: 7, known: 4 } });
    expect(problem?.message).toBe('Project version 7 is newer than this app (4). Reload the page to update.');
    for (const version of [0, 1.5, '1', null, undefined])
      expect(problemsOf({ ...asValue(small), version })[0]?.code).toBe('unknown-version');
  });

  it('says so if it is none', () => {
    for (const value of [null, 7, 'x', [], {}, { format: 'parcours-scene' }])
      expect(problemsOf(value === 'x' ? '"x"' : value)[0]?.code).toBe('not-a-project');
    expect(problemsOf('{ "format": ')[0]?.message).toBe(
      'The project file is not JSON: line 1, column 13, where it ends.',
    );
    expect(problemsOf('x'.repeat(12_000_001))[0]?.code).toBe('too-long');
  });

  it('names place and value of everything that is wrong', () => {
    const file = { name: 'a b.py', text: 7 };
    const settings = { reality: 2, seed: 0.5, colour: 'red', robotOptions: { callibot: { lamp: 1 } } };
    const problems = problemsOf({ ...asValue(small), course: 7, files: [file], settings, scene: { version: 2 } });
    expect(problems.map(({ message }) => message)).toEqual([
      'course: must be a text in quotes, not 7.',
      'settings.colour: unknown property. Known here: device, firmware, robot, robotOptions, reality, seed, arenaSenses, myRobot.',
      'settings.robotOptions.callibot.lamp: must be a text in quotes, not 1.',
      'settings.reality: 2 is not within 0 … 1.',
      'settings.seed: 0.5 is not within 1 … 9999.',
      'files[0].text: must be a text in quotes, not 7.',
      'scene: format: This is not a course file: "format" must be "parcours-scene".',
    ]);
  });

  it('has a main.py first and no name twice', () => {
    const files = (...names: string[]): unknown => ({
      ...asValue(small),
      files: names.map((name) => ({ name, text: '' })),
    });
    expect(problemsOf(files('fahren.py'))[0]?.message).toBe('files[0].name: the first file must be main.py, not "fahren.py".'); // prettier-ignore
    expect(problemsOf(files('main.py', 'main.py'))[0]?.params).toEqual({ rule: 'nameTaken' });
    expect(problemsOf(files('main.py', '../x.py'))[0]?.params).toEqual({ rule: 'nameCharacters' });
    expect(problemsOf(files())[0]?.message).toBe('files: 0 entries; there may be 1 … 20.');
    expect(problemsOf(files('main.py', ...Array.from({ length: 20 }, (_, i) => `f${String(i)}.py`)))[0]?.code).toBe('too-many'); // prettier-ignore
  });

  it('has files of 256 kB at most', () => {
    const file = (text: string): unknown => ({ ...asValue(small), files: [{ name: 'main.py', text }] });
    expect(problemsOf(file('x'.repeat(FILE_BYTES)))).toEqual([]);
    expect(problemsOf(file(`${'x'.repeat(FILE_BYTES - 1)}ü`))[0]).toMatchObject({
      code: 'file-too-large',
      params: { length: 262_145, max: 262_144 },
    });
  });
});

describe('the bytes of a text', () => {
  it('are counted as UTF-8 has them', () => {
    for (const text of ['', 'abc', 'Grüezi', '10 €', '👋a👋', 'a\ud800b', '\udc00'])
      expect(utf8Bytes(text)).toBe(new TextEncoder().encode(text).length);
  });
});
