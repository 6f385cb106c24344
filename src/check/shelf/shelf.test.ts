import { readFileSync } from 'node:fs';
import Ajv2020 from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { parseProject } from '#project/file';
import { mutatedText, mutatedTree } from '#scene/testing/mutate';
import { parseSeries } from '../series/read-series';
import { seriesLinkOf, seriesOfLink } from '../series/series-link';
import { aSeries, readyCourses, teachersTask } from '../series/testing/series';
import { seriesForPupils } from '../series/write-series';
import { licenceName, licences, noAbout, type TaskAbout } from '../task/about';
import { parseShelf } from './read-shelf';
import { aboutOf, withAbout, type ShelfWork } from './shelf';
import { shelfToFolder, shelfToText, workToText } from './write-shelf';

const about: TaskAbout = {
  ...{ level: 'Klasse 8', topic: 'Linien', minutes: 45 },
  ...{ language: 'de', author: 'Ada Keller', licence: 'CC-BY-SA-4.0' },
};
const kept = readFileSync(new URL('kept/v1.json', import.meta.url), 'utf8');
const task: ShelfWork = { kind: 'task', project: teachersTask() };
const series: ShelfWork = { kind: 'series', series: aSeries() };

describe('level, topic, duration, language, author and licence', () => {
  it('go with the file of a task, which was none before, and can be taken away again', () => {
    const said = withAbout(task, about);
    const read = parseProject(workToText(said));
    expect('project' in read && aboutOf({ kind: 'task', project: read.project })).toEqual(about);
    expect(aboutOf(task)).toEqual(noAbout);
    expect(workToText(withAbout(said, noAbout))).not.toContain('about');
  });

  it('go with the file and the link of a series', () => {
    const said = withAbout(series, about);
    const read = parseSeries(workToText(said), readyCourses);
    expect('series' in read && read.series.about).toEqual(about);
    const given = seriesForPupils({ ...aSeries(), about });
    const { fragment } = seriesLinkOf(given, readyCourses)!;
    expect(seriesOfLink(fragment, readyCourses)).toEqual({ series: given });
    expect(aboutOf(withAbout(said, noAbout))).toEqual(noAbout);
  });

  it('are told by their place where one is wrong', () => {
    const project = { ...teachersTask(), task: { version: 1, about: { minutes: 0.5, licence: 'mine' } } };
    expect(aboutOf({ kind: 'task', project })).toBeNull();
    expect(workToText(withAbout({ kind: 'task', project }, about))).toBe(workToText({ kind: 'task', project }));
  });

  it('name the licences as they are written', () => {
    expect(licences.map(licenceName)).toEqual(['CC BY 4.0', 'CC BY-SA 4.0', 'CC BY-NC-SA 4.0', 'CC0 1.0']);
  });
});

describe('the list of a shelf', () => {
  it('is read and written the same, also the kept one of version 1, and fits its schema', () => {
    const read = parseShelf(kept);
    if ('problem' in read) throw new Error(read.problem);
    expect(read.list.entries[0]).toMatchObject({ name: 'Ab in die Garage', about });
    expect(read.list.entries[1]).toEqual({ name: 'Woche 3', file: 'series/woche-3.json', text: '', about: noAbout });
    expect(parseShelf(shelfToText(read.list))).toEqual(read);
    const schema = JSON.parse(readFileSync('schemas/shelf.schema.json', 'utf8')) as object;
    expect(new Ajv2020().validate(schema, JSON.parse(shelfToText(read.list)))).toBe(true);
  });

  it('comes as a folder: the list, and the file of each work with a name for any server', () => {
    const works = [
      { work: withAbout(task, about), name: 'Über Wände!', text: 'Ein Satz. '.repeat(100) },
      { work: series, name: 'Woche 3', text: '' },
    ];
    const files = shelfToFolder('Meine', works);
    expect(files.map(({ name }) => name)).toEqual(['shelf.json', '01-uber-wande.json', '02-woche-3.json']);
    const read = parseShelf(files[0]!.text);
    expect('list' in read && read.list.entries.map(({ file, about: { level } }) => [file, level])).toEqual([
      ['01-uber-wande.json', 'Klasse 8'],
      ['02-woche-3.json', ''],
    ]);
  });

  it.each([
    ['{', 'The shelf file is not JSON: line 1, column 2, where it ends.', false],
    ['{"format":"parcours-series"}', '"format" must be "parcours-shelf"', false],
    ['<!doctype html>', 'not JSON', false],
    ['{"format":"parcours-shelf","version":2}', 'Shelf version 2 is newer than this app (1)', true],
    ['{"format":"parcours-shelf","version":1}', 'entries: is missing', true],
    ['{"format":"parcours-shelf","version":1,"entries":[{"name":"x"}]}', 'entries[0].file: is missing', true],
    ['{"format":"parcours-shelf","version":1,"entries":[{"file":""}]}', 'entries[0].file: must not be empty', true],
    [`{"format":"parcours-shelf","version":1,"entries":[${'7,'.repeat(2000)}7]}`, '2001 entries', true],
    [`"${'x'.repeat(2_000_001)}"`, 'characters', false],
  ])('%# is refused with the reason', (text, problem, isShelf) => {
    expect(parseShelf(text)).toMatchObject({ problem: expect.stringContaining(problem) as string, isShelf });
  });

  it(`randomly changed, is valid or says what is wrong, never an exception (${String(fuzzRuns)})`, () => {
    const value: unknown = JSON.parse(kept);
    const counts = { read: 0, refused: 0 };
    for (let seed = 1; seed <= fuzzRuns; seed += 1) {
      const rng = createRng(seed);
      const text = rng.unit() < 0.3 ? mutatedText(kept, rng) : (JSON.stringify(mutatedTree(value, rng, false)) ?? '');
      const read = parseShelf(text);
      if ('problem' in read) expect(read.problem, `seed ${String(seed)}`).not.toBe('');
      else expect(parseShelf(shelfToText(read.list)), `seed ${String(seed)}`).toEqual(read);
      counts['list' in read ? 'read' : 'refused'] += 1;
    }
    for (const count of Object.values(counts)) expect(count).toBeGreaterThan(fuzzRuns / 100);
  });
});
