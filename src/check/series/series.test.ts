import { readFileSync } from 'node:fs';
import Ajv2020 from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';

import { projectToText } from '#project/file';
import { linkOf } from '#project/link/link';
import type { Project } from '#project/project';
import { readTasks } from '#intake/read-files';
import { looksLikeSeries, parseSeries, parseSeriesValue } from './read-series';
import { freeTaskId, seriesLimits, type Series, type TaskSource } from './series';
import { isSeriesLink, seriesLinkOf, seriesOfLink } from './series-link';
import { aSeries, readyCourses, teachersTask } from './testing/series';
import { seriesForPupils, seriesToFolder, seriesToText } from './write-series';

const KEPT = readFileSync(new URL('kept/v1.json', import.meta.url), 'utf8');
const head = { format: 'parcours-series', version: 1, title: 'Reihe' };
const withTasks = (...tasks: unknown[]): Series => {
  const read = parseSeriesValue({ ...head, tasks }, readyCourses);
  if ('problem' in read) throw new Error(read.problem);
  return read.series;
};
const sourceOf = (task: unknown): TaskSource => withTasks(task).tasks[0]!.from;
const problemOf = (task: unknown): string => {
  const from = sourceOf(task);
  return from.kind === 'unread' ? from.problem : '';
};
const refusal = (value: unknown): string => {
  const read = parseSeriesValue(value, readyCourses);
  return 'problem' in read ? read.problem : '';
};
const plain = (project: Project): unknown => JSON.parse(projectToText(project));

describe('the file of a series', () => {
  it('is read as it was written', () =>
    expect(parseSeries(seriesToText(aSeries()), readyCourses)).toEqual({ series: aSeries() }));

  it('can always be read in version 1', () => {
    const read = parseSeries(KEPT, readyCourses);
    if ('problem' in read) throw new Error(read.problem);
    const { id, tasks } = read.series;
    expect([id, tasks.map(({ from }) => from.kind)]).toEqual(['erste-woche', ['course', 'project', 'project', 'file']]);
    expect(looksLikeSeries(KEPT)).toBe(true);
  });

  it('fits its schema, as it is written and as it is kept', () => {
    const schema = JSON.parse(readFileSync('schemas/series.schema.json', 'utf8')) as object;
    const check = new Ajv2020({ strict: false }).compile(schema);
    for (const text of [KEPT, seriesToText(aSeries())]) {
      check(JSON.parse(text));
      expect(check.errors).toBeNull();
    }
    expect(check({ ...head, tasks: [{ title: 'ohne' }] })).toBe(false);
  });

  it('written by hand needs a title and the ids of ready courses', () => {
    const { id, text, tasks } = withTasks({ course: 'closed-line' }, { course: 'slalom', title: 'Zum Schluss' });
    expect([text, tasks]).toEqual([
      '',
      [
        { id: '1', title: '', from: { kind: 'course', course: 'closed-line' } },
        { id: '2', title: 'Zum Schluss', from: { kind: 'course', course: 'slalom' } },
      ],
    ]);
    expect(id).toMatch(/^s[a-z0-9]+$/); // progress is stored under it, as long as the series has the same contents
    expect(withTasks({ course: 'closed-line' }, { course: 'slalom', title: 'Zum Schluss' }).id).toBe(id);
  });

  it('may hold whole links', () => {
    const made = linkOf(teachersTask(), { courses: readyCourses, program: true });
    expect(sourceOf({ link: `https://parcours.example/#${made!.fragment}` })).toMatchObject({
      kind: 'project',
      project: { task: { id: 'ziel' } },
    });
  });
});

describe('what is no series', () => {
  it.each([
    [{ format: 'parcours-project', version: 4 }, 'This is not a series of tasks: "format" must be "parcours-series".'],
    [[], 'This is not a series'],
    [{ ...head, version: 2, tasks: [] }, 'Series version 2 is newer than this app (1). Reload the page to update.'],
    [{ ...head, version: '1', tasks: [] }, 'Series version "1" is unknown; this app reads version 1.'],
    [head, 'tasks: is missing; it must be a list [ … ].'],
    [{ ...head, tasks: Array(5000).fill({ course: 'slalom' }) }, 'tasks: 5000 entries; there may be 0 … 60.'],
    [{ ...head, tasks: [], title: 'x'.repeat(121) }, 'title: 121 characters are too many; the limit is 120.'],
    [{ ...head, tasks: [], id: '../a' }, 'id: "../a" may have letters, digits, "_" and "-" only.'],
    [
      { ...head, tasks: [], colour: 'red' },
      'colour: unknown property. Known here: format, version, id, title, text, tasks, about.',
    ],
  ])('%# says why', (value, message) => expect(refusal(value)).toContain(message));

  it('is told line and column where it is not even JSON', () => {
    expect(parseSeries('{ "format": "parcours-series",', readyCourses)).toMatchObject({
      problem: 'The series file is not JSON: line 1, column 31, where it ends.',
    });
  });

  it('has the word somewhere else', () => {
    expect(looksLikeSeries('{"format":"parcours-project","files":[{"text":"\\"parcours-series\\""}]}')).toBe(false);
    expect(looksLikeSeries('{"name":"parcours-series","format":"parcours-project"}')).toBe(false);
    expect(looksLikeSeries('')).toBe(false);
  });
});

describe('a task that cannot be read', () => {
  it.each([
    [
      { course: 'slalom', file: 'a.json' },
      'tasks[0].course: needs one of course, project, link, file, and has course, file.',
    ],
    [{ title: 'leer' }, 'needs one of course, project, link, file, and has none.'],
    [7, 'tasks[0]: must be an object { … }, not 7.'],
    [{ course: '' }, 'tasks[0].course: must not be empty.'],
    [{ project: { ...head, tasks: [] } }, 'tasks[0].project: is a series itself; a series holds tasks only.'],
    [{ project: { format: 'parcours-project', version: 99 } }, 'tasks[0].project: Project version 99 is newer'],
    [
      { link: 'p=9.abc' },
      'tasks[0].link: The link is damaged: a part of it is missing or changed. Copy it again, whole.',
    ],
    [{ course: 'slalom', level: 3 }, 'tasks[0].level: unknown property.'],
  ])('%# says where and why', (task, message) => expect(problemOf(task)).toContain(message));

  it('leaves the others as they are, and is written again as it was', () => {
    const bad = { id: 'x', project: { format: 'parcours-project', version: 99, secret: [1, 2] } };
    const series = withTasks({ course: 'slalom' }, bad, { course: 'closed-line' });
    expect(series.tasks.map(({ from }) => from.kind)).toEqual(['course', 'unread', 'course']);
    expect(JSON.parse(seriesToText(series))).toMatchObject({ tasks: [{}, bad, {}] });
  });

  it('is one that has the id of another', () =>
    expect(withTasks({ id: 'a', course: 'slalom' }, { id: 'a', course: 'square' }).tasks[1]!.from).toMatchObject({
      problem: 'tasks[1].id: another task has the id "a".',
    }));
});

describe('what pupils get of a series', () => {
  it('has neither solutions nor hidden worlds, and its locks hold', () => {
    const given = seriesForPupils(aSeries());
    expect(seriesToText(given)).not.toMatch(/Musterlösung|geheim|"solution"/);
    expect(given.tasks[1]!.from).toMatchObject({ project: { task: { handedOut: true, locks: { course: true } } } });
    expect(seriesToText(aSeries())).toMatch(/Musterlösung.*/);
  });

  it('has nothing that cannot be read, for it may hold them', () =>
    expect(seriesForPupils(withTasks({ course: 'slalom' }, { project: { solution: 'x' } })).tasks).toHaveLength(1));

  it('has nothing that somebody has handed in', () => {
    const project = { ...teachersTask(), handIn: { version: 1, alias: 'Ada' } };
    expect(JSON.stringify(seriesForPupils(withTasks({ project: plain(project) })))).not.toContain('Ada');
  });
});

describe('links that hold far too much', () => {
  /** Sixty links of 60 kB each: three seconds and more to open them all. */
  const large = { ...teachersTask(), files: [{ name: 'main.py', text: 'x = 1\n'.repeat(10_000) }] };
  const link = linkOf(large, { courses: readyCourses, program: true })!.fragment;
  const others = 'Together the links of this series hold more than 1048576 bytes. Put this task in as a file.';

  it('are opened as long as there is room for all of them together', () => {
    // Deflated: the room is the same, and they are read in no time.
    const text = 'x = 1\n'.repeat(33_000);
    const project = { ...large, files: [{ name: 'main.py', text }] };
    const link = linkOf(project, { courses: readyCourses, program: true })!.fragment;
    const { tasks } = withTasks(...Array<object>(60).fill({ link }));
    const kinds = tasks.map(({ from }) => from.kind);
    expect(kinds.lastIndexOf('project') * text.length).toBeLessThanOrEqual(seriesLimits.linkedBytes);
    expect((kinds.lastIndexOf('project') + 2) * text.length).toBeGreaterThan(seriesLimits.linkedBytes);
    expect(kinds.lastIndexOf('project')).toBe(kinds.indexOf('unread') - 1);
    expect(kinds.indexOf('project')).toBe(0);
    expect(tasks[59]!.from).toMatchObject({
      ...{ kind: 'unread', problem: `tasks[59].link: ${others}`, value: { link } },
      problems: [{ code: 'links-too-large', path: 'tasks[59].link', params: { max: seriesLimits.linkedBytes } }],
    });
  });

  it('take the room of others also where they are packed otherwise, or make no project', () => {
    const text = 'x'.repeat(900_000);
    const deflated = linkOf(
      { ...large, files: [{ name: 'main.py', text }] },
      { courses: readyCourses, program: true },
    )!;
    const { tasks } = withTasks(
      { link: deflated.fragment },
      { link },
      { link: deflated.fragment },
      { link },
      { course: 'slalom' },
    );
    expect(tasks.map(({ from }) => (from.kind === 'unread' ? from.problem : from.kind))).toEqual([
      'tasks[0].link: The link holds no project: files[0].text: 900000 bytes are too many; the limit is 262144.',
      'project',
      'tasks[2].link: The link holds no project: files[0].text: 900000 bytes are too many; the limit is 262144.',
      `tasks[3].link: ${others}`,
      'course',
    ]);
  });

  it('are not made', () => {
    // Deflated: the room is the same, and one of them is packed and read in no time.
    const text = 'x = 1\n'.repeat(33_000);
    const project = { ...large, files: [{ name: 'main.py', text }] };
    const task = (place: number) => ({ id: String(place), title: '', from: { kind: 'project' as const, project } });
    const made = (count: number) =>
      seriesLinkOf({ ...aSeries(), tasks: Array.from({ length: count }, (_, place) => task(place)) }, readyCourses);
    expect(made(5)).not.toBeNull();
    expect(made(30)).toBeNull();
  });
});

describe('a series as a link', () => {
  const link = seriesLinkOf(seriesForPupils(aSeries()), readyCourses)!;

  it('holds all that pupils need', () => {
    expect(link.fragment).toMatch(/^s=1\.[\w-]+$/);
    const read = seriesOfLink(`#${link.fragment}`, readyCourses);
    expect(read).toEqual({ series: seriesForPupils(aSeries()) });
    expect(isSeriesLink(link.fragment)).toBe(true);
  });

  it('is short enough for a chat and a QR code with three tasks', () =>
    expect(link.fragment.length).toBeLessThan(1000));

  it('stays under the 8,000 characters at which chats cut with twenty tasks', () => {
    const [, task] = aSeries().tasks;
    const tasks = Array.from({ length: 20 }, (_, place) => ({ ...task!, id: String(place) }));
    expect(seriesLinkOf({ ...aSeries(), tasks }, readyCourses)!.fragment.length).toBeLessThan(8000);
  });

  it('cut short anywhere is damaged, never half a series', () => {
    for (let length = 4; length < link.fragment.length; length += 7)
      expect(seriesOfLink(link.fragment.slice(0, length), readyCourses)).toEqual({ fault: 'damaged' });
  });

  it('says so if it is of a later version', () =>
    expect(seriesOfLink('#s=2.abcd', readyCourses)).toEqual({ fault: 'newer' }));

  it('is not unpacked if it is far too long', () =>
    expect(seriesOfLink(`#s=1.${'A'.repeat(600_000)}`, readyCourses)).toEqual({ fault: 'too-large' }));

  it('is not made of a series with files that are not there', () =>
    expect(seriesLinkOf(withTasks({ file: 'a.json' }), readyCourses)).toBeNull());

  it('is not made where it would be too long', () => {
    const text = Array.from({ length: 12_000 }, (_, line) => `x${String(line)} = ${String((line * 7919) % 99_991)}`);
    const project = { ...teachersTask(), files: [{ name: 'main.py', text: text.join('\n') }] };
    const tasks = Array.from({ length: 40 }, (_, place) => ({
      id: String(place),
      title: '',
      from: { kind: 'project', project } as const,
    }));
    expect(seriesLinkOf({ ...aSeries(), tasks: tasks.slice(0, 1) }, readyCourses)).not.toBeNull();
    expect(seriesLinkOf({ ...aSeries(), tasks }, readyCourses)).toBeNull();
  });
});

describe('a series as a folder', () => {
  const folder = seriesToFolder(aSeries(), ({ title }) => title || 'Über «Wände»!');

  it('has a file for itself and one for each task that is no ready course', () => {
    expect(folder.map(({ name }) => name)).toEqual(['series.json', '02-ans-ziel.json', '03-uber-wande.json']);
    expect(JSON.parse(folder[0]!.text)).toMatchObject({
      tasks: [{ course: 'closed-line' }, { file: '02-ans-ziel.json' }, { file: '03-uber-wande.json' }],
    });
  });

  it('is whole again once its files are read', async () => {
    const read = parseSeries(folder[0]!.text, readyCourses);
    if ('problem' in read) throw new Error(read.problem);
    const texts = new Map(folder.map(({ name, text }) => [name, text]));
    const load = (file: string) => Promise.resolve({ text: texts.get(file) ?? '' });
    expect(await readTasks(read.series, load)).toEqual(aSeries());
  });

  it('says where a file is missing, damaged or no series', async () => {
    const series = withTasks(
      { file: 'gone.json' },
      { file: 'bad.json' },
      { file: 'series.json' },
      { course: 'slalom' },
    );
    const load = (file: string) =>
      Promise.resolve(
        file === 'gone.json'
          ? { problem: 'The server has no such file.' }
          : { text: file === 'bad.json' ? '{ "format":' : folder[0]!.text },
      );
    const { tasks } = await readTasks(series, load);
    expect(tasks.map(({ from }) => (from.kind === 'unread' ? from.problem : from.kind))).toEqual([
      'gone.json: The server has no such file.',
      expect.stringContaining('bad.json: The project file is not JSON: line 1'),
      expect.stringContaining('series.json: is a series itself'),
      'course',
    ]);
    expect(seriesToText({ ...series, tasks })).toContain('"file":"gone.json"');
  });
});

describe('the id of another task', () => {
  it('is free', () => expect(freeTaskId([{ id: '1' }, { id: '3' }, { id: '4' }])).toBe('5'));
});
