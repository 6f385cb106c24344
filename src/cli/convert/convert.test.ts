import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { documentOfAddress } from '#intake/address';
import { addresses, samples } from '#intake/testing/samples';
import { demoMap, mapFile, straight } from '#rescue-line/testing/maps';
import { parseProject, projectToText } from '#project/file';
import { fullProject } from '#project/testing/projects';
import { linkSamples } from '#project/webtigerpython/testing/links';
import { parseScene } from '#scene/parse';
import { useFolder } from '../testing/parcours';
import { converted } from './testing/converted';

const { file, folder } = useFolder();

/** The line of `--json`. */
interface Line {
  readonly kind: string;
  readonly program: Readonly<Record<string, string>>;
  readonly robot: string | null;
  readonly board: string | null;
  readonly scene: unknown;
  readonly notes: readonly string[];
  readonly text?: string;
}
async function lineOf(...words: readonly string[]): Promise<Line> {
  const { out, err } = await converted(...words, '--json');
  expect(err).toBe('');
  expect(out.trimEnd().split('\n')).toHaveLength(1);
  return JSON.parse(out) as Line;
}

const sample = (name: string): string => file(name, samples.find((one) => one.name === name)!.bytes);
const anna = file('anna.py', 'from callibot2 import *\r\nforward()\r\n');
const full = file('full.json', projectToText(fullProject()));
const repeated = (program: string): string => program.replace('repeat 4:', 'for _ in range(4):').replace('repeat:', 'while True:'); // prettier-ignore

describe('parcours convert --json', () => {
  it.each(linkSamples)(
    'tells the program of a link as it came, course and hardware: $name',
    async ({ link, program, playground }) => {
      const line = await lineOf(link);
      expect(line).toMatchObject({ kind: program === '' ? 'course' : 'program', board: 'microbit-v2' });
      expect(line.program).toEqual({ 'main.py': program });
      if (playground === null) expect(line.scene).toBeNull();
      else expect(parseScene(JSON.stringify(line.scene))).toHaveProperty('scene.size', playground['playgroundSize']);
      expect(line.notes).toHaveLength((program === '' ? 0 : 2) + (playground === null ? 1 : 0));
    },
  );

  it('tells of a program, a project, a course and a ready course', async () => {
    expect(await lineOf(anna)).toEqual({ kind: 'program', program: { 'main.py': 'from callibot2 import *\nforward()\n' }, robot: 'callibot', board: 'calliope-mini-3', scene: null, notes: [] }); // prettier-ignore
    const project = await lineOf(full);
    expect(project.kind).toBe('project');
    expect(Object.keys(project.program)).toEqual(fullProject().files.map(({ name }) => name));
    expect(await lineOf(sample('mylevel.json'))).toMatchObject({ kind: 'course', program: { 'main.py': '' }, robot: 'maqueen-lite', notes: [] }); // prettier-ignore
    expect(await lineOf('{"StartBox":[1,1,0]}')).toMatchObject({ kind: 'course', scene: { size: [2000, 2000] } });
    const ready = await lineOf('gate');
    expect(ready).toMatchObject({ kind: 'project', scene: { format: 'parcours-scene' } });
    expect(ready.program['main.py']).toContain('from mbrobot import *');
    expect(await lineOf(addresses.ready)).toMatchObject({ kind: 'project' });
    expect(await lineOf(addresses.project)).toMatchObject({ kind: 'project', scene: { name: 'Hall' } });
  });

  it('tells of a link that stands in a file', async () => {
    const [{ link }] = [linkSamples[5]!];
    expect(await lineOf(file('link.txt', `${link}\n`))).toMatchObject({ kind: 'course' });
    expect(await lineOf(sample('links.txt'))).toMatchObject({ kind: 'project' });
  });

  it('takes a program for a program, whatever it begins with', async () => {
    const program = { 'main.py': '#p=2.abc' };
    expect(await lineOf(file('comment.py', '#p=2.abc'))).toMatchObject({ kind: 'program', program });
  });

  it('has what was made, if no file takes it', async () => {
    const { text = '', notes } = await lineOf(full, '--as', 'webtigerpython');
    expect(text).toMatch(/^https:\/\/webtigerpython\.ethz\.ch\/#\?code=/);
    expect(notes).toContain('The picture on the floor is left out.');
  });
});

describe('parcours convert', () => {
  it('sums up for people what it is', async () => {
    const { code, out, err } = await converted(linkSamples[0]!.link);
    expect(code).toBe(0);
    expect(out).toContain('This is a program.\nProgram: main.py (6 lines)\nHardware: robot ');
    expect(out).toContain('Course: 2000 × 2000 mm, 4 × wall\n');
    expect(err).toBe(
      'parcours: TigerJython’s `repeat` now is a loop of Python, as it runs on the device (lines: 4).\n',
    );
  });

  it('writes what the ending of --out says: a project, or a program', async () => {
    const [project, program] = [join(folder, 'made.json'), join(folder, 'made.py')];
    const [{ link, program: text }] = [linkSamples[1]!];
    expect((await converted(link, '--out', project)).code).toBe(0);
    const parsed = parseProject(readFileSync(project, 'utf8'));
    expect(parsed).toMatchObject({ project: { files: [{ name: 'main.py', text: repeated(text) }], settings: { device: 'microbit-v2' } } }); // prettier-ignore
    expect((await converted(link, '--out', program)).out).toBe('');
    expect(readFileSync(program, 'utf8')).toBe(repeated(text));
  });

  it('prints every form', async () => {
    const [{ link }] = [linkSamples[1]!];
    expect((await converted(link, '--as', 'program')).out).toBe(repeated(linkSamples[1]!.program));
    expect(parseScene((await converted(link, '--as', 'course')).out)).toHaveProperty('scene.objects.length', 8);
    expect(parseProject((await converted(anna, '--as', 'project')).out)).toMatchObject({ project: { scene: { size: [1200, 900] }, settings: { arenaSenses: true } } }); // prettier-ignore
    const own = (await converted(link, '--as', 'link')).out.trim();
    expect(documentOfAddress(own, () => null)).toMatchObject({ kind: 'project', project: { scene: { size: [2000, 2000] } } }); // prettier-ignore
    const back = (await converted(own, '--as', 'webtigerpython')).out.trim();
    expect(documentOfAddress(back, () => null)).toMatchObject({ kind: 'program', notes: [], rewritten: [], scene: { size: [2000, 2000] } }); // prettier-ignore
  });

  it('says what is left out', async () => {
    expect((await converted(full, '--as', 'program')).err).toMatch(/^parcours: Only main\.py is in it, without .+\.$/m);
    expect((await converted(full, '--as', 'webtigerpython')).err).toContain(
      'parcours: Lines on the floor are left out',
    );
  });

  it.each<[string, readonly string[], string]>([
    ['nothing', [], 'What shall be converted? For example:'],
    ['two things', ['a.py', 'b.py'], 'One thing at a time: what is "b.py"?'],
    ['an unknown form', [anna, '--as', 'pdf'], '--as: "pdf" is not known. Known: project, course, program, files, hex, link, webtigerpython.'],
    ['a form with a slip', [anna, '--as', 'projct'], '--as: "projct" is not known. Did you mean project? Known: project,'],
    ['an ending that says nothing', [anna, '--out', 'x.txt'], '--out: x.txt does not end in .json (a project), .py (a program), .hex (for a board) or / (a folder).'],
    ['an option of others', [anna, '--seed', '3'], '--seed is not for convert, but for run, sweep. convert takes --out, --as, '],
    ['a missing file', [join(folder, 'no.py')], 'no.py: there is no such file.'],
    ['a recorded run', [sample('anna.run.json')], 'is a recorded run. Run it again with parcours replay.'],
    ['a series', [sample('week.json')], 'is a series of tasks.'],
    ['a picture', [sample('floor.png')], 'is not text in UTF-8'],
    ['readings', [sample('walk.csv')], 'walk.csv: is no program (.py), no project, no course and no link to one of them.'],
    ['broken JSON', [sample('broken.json')], 'is not JSON: line 1'],
    ['another address', [addresses.unreadable], 'is no program (.py), no project, no course and no link to one of them.'],
    ['a damaged link', ['https://webtigerpython.ethz.ch/?code=A'], 'The link is damaged: a part of it is missing or changed.'],
    ['an unknown course', ['https://parcours.example/?task=xy'], 'there is no ready course "xy".'],
    ['a course as a program', [sample('mylevel.json'), '--as', 'program'], 'has no program, only a course.'],
    ['a program as a course', [anna, '--as', 'course'], 'has no course, only a program.'],
    ['a file over itself', [anna, '--out', anna], 'is the file that is read. Choose another name.'],
    ['a place that is none', [anna, '--as', 'project', '--out', join(folder, 'no/x.json')], `--out: the folder ${join(folder, 'no')} does not exist.`],
  ])('refuses %s in a sentence', async (_, words, sentence) => {
    const { code, out, err } = await converted(...words);
    expect([code, out]).toEqual([2, '']);
    expect(err).toContain(sentence);
  }); // prettier-ignore
});

describe('parcours convert of a map of RoboCup Junior', () => {
  const map = file('map.json', JSON.stringify(demoMap()));

  it('makes the course of it, scored by the rules that are asked for', async () => {
    const { out, err } = await converted(map, '--as', 'course', '--rules', 'line-entry-2026');
    expect(err).toBe('');
    expect(parseScene(out)).toMatchObject({ scene: { name: 'Demo', league: { rules: 'line-entry-2026' } } });
    expect((await converted(map, '--rules', 'line-1999')).err).toContain('--rules: "line-1999" is not known.');
  });

  it('says what is wrong with it, and what is not in the course', async () => {
    expect((await converted(file('bad.json', JSON.stringify(mapFile({ '0,0,0': 1 }))))).err).toContain('tiles["0,0,0"]: must be an object'); // prettier-ignore
    const bumpy = file('bumpy.json', JSON.stringify(mapFile({ '0,0,0': straight(0, { items: { speedbumps: 1 } }) })));
    expect((await converted(bumpy)).err).toContain('parcours: Courses are flat: speed bumps are left out');
  });
});
