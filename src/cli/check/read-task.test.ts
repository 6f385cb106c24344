import { describe, expect, it } from 'vitest';
import { seriesLinkOf } from '#check/series/series-link';
import { aSeries, teachersTask } from '#check/series/testing/series';
import { seriesToFolder, seriesToText } from '#check/series/write-series';
import { projectToText } from '#project/file';
import { packed } from '#core/deflate';
import { sealed } from '#core/sealed';
import { readyCourse } from '../ready-courses';
import { useFolder } from '../testing/parcours';
import { readTask } from './read-task';

const { file } = useFolder();

/** The name of the task that a word means, or why it means none. */
async function named(word: string): Promise<string> {
  const read = await readTask(word);
  return 'problem' in read ? read.problem : read.name;
}
const week = () => file('week.json', seriesToText(aSeries()));
const link = () => seriesLinkOf(aSeries(), readyCourse)?.fragment ?? '';

/** The link of a series that is written like this. */
const linkOfFile = (tasks: readonly object[]): string => {
  const text = JSON.stringify({ format: 'parcours-series', version: 1, id: 'a', title: 'A', tasks });
  return `s=1.${sealed(packed(new TextEncoder().encode(text)))}`;
};

describe('a task of a series', () => {
  it('is meant by its number, from 1', async () => {
    expect(await named(`${week()}#1`)).toBe('closed-line');
    expect(await named(`${week()}#2`)).toBe('ziel');
    expect(await named(`${week()}#3`)).toBe('Ohne Aufgabe');
  });

  it('is meant by its id, and a number is always a place', async () => {
    const tasks = [
      { id: '2', course: 'closed-line' },
      { id: 'bend', title: 'Um die Ecke', course: 'slalom' },
    ];
    const moved = file('moved.json', JSON.stringify({ format: 'parcours-series', version: 1, title: 'A', tasks }));
    expect(await named(`${moved}#bend`)).toBe('Um die Ecke');
    expect(await named(`${moved}#2`)).toBe('Um die Ecke');
  });

  it('has everything that the teacher’s file holds', async () => {
    const read = await readTask(`${week()}#b`);
    expect('task' in read && read.task.worlds.map(({ id }) => id)).toEqual(['visible', 'geheim']);
  });

  it('is in a link of a series, too', async () => {
    expect(await named(`https://parcours.example/#${link()}#1`)).toBe('closed-line');
    expect(await named(`${link()}#b`)).toBe('ziel');
    expect(await named(`#${link()}#3`)).toBe('Ohne Aufgabe');
  });

  it('may lie in a file beside the series', async () => {
    const files = seriesToFolder(aSeries(), ({ title }) => title || 'task');
    for (const { name, text } of files) file(name, text);
    expect(await named(`${file('series.json', files[0]?.text ?? '')}#2`)).toBe('ziel');
  });

  it('is looked for in a file with # in its name only where there is none of the whole name', async () => {
    expect(await named(file('task#2', projectToText(teachersTask())))).toBe('ziel');
    const odd = file('week#5.json', seriesToText(aSeries()));
    expect(await named(`${odd}#2`)).toBe('ziel');
  });
});

describe('what is no task of a series', () => {
  const NAMES = '#1 (Closed line), #2 or #b (Ans Ziel), #3 (Ohne Aufgabe).';

  it('is a series: its tasks are named to choose from', async () => {
    expect(await named(week())).toBe(`${week()}: is a series. Say which of its tasks, such as ${week()}#1: ${NAMES}`);
    expect(await named(`${week()}#`)).toContain(NAMES);
    const whole = await named(`https://parcours.example/#${link()}`);
    expect(whole).toMatch(/^https:\/\/parcours.example\/#s=1\..{1,40}…: is a series/);
    expect(whole).toContain('such as LINK#1: #1 (Closed line)');
  });

  it.each(['0', '4', '99999999999999999999'])('is number %s of three tasks', async (number) => {
    expect(await named(`${week()}#${number}`)).toBe(`${week()}#${number}: there are tasks 1 to 3 in this series.`);
  });

  it('is an id that no task has', async () => {
    expect(await named(`${week()}#bend`)).toBe(
      `${week()}#bend: no task of this series has the id "bend". There are ${NAMES}`,
    );
  });

  it.each([
    [[], '1', 'there are no tasks in this series.'],
    [[{ course: 'no-such' }], '1', 'there is no ready course "no-such".'],
    [[{ link: 'p=2.abc' }], '1', 'tasks[0].link: The link is damaged'],
    [[{ file: 'gone.json' }], '1', 'gone.json: there is no such file.'],
    [[{ file: 'https://example.org/a.json' }], '1', 'lies on a web server. Save it beside the series.'],
    [[{ course: 'empty' }], '1', '#1: '],
  ])('%# cannot be had, and says why', async (tasks, number, problem) => {
    const text = JSON.stringify({ format: 'parcours-series', version: 1, title: 'A', tasks });
    expect(await named(`${file('bad.json', text)}#${number}`)).toContain(problem);
  });

  it('is a file beside a link', async () => {
    expect(await named(`${linkOfFile([{ file: 'a.json' }])}#1`)).toContain('a link has no files beside it.');
  });

  it('is a damaged link, a newer series, a single task', async () => {
    expect(await named(`${link().slice(0, -9)}#1`)).toContain('The link is damaged');
    expect(await named(`s=2.abc#1`)).toContain('The link is from a newer version. Update Parcours.');
    const newer = file('newer.json', '{"format":"parcours-series","version":2,"tasks":[]}');
    expect(await named(`${newer}#1`)).toBe(`${newer}#1: Series version 2 is newer than this app (1). Update Parcours.`);
    const single = file('single.json', projectToText(teachersTask()));
    expect(await named(`${single}#2`)).toBe(`${single}: is one task and no series. Leave out #2.`);
    expect(await named('closed-line#2')).toBe('closed-line: is one task and no series. Leave out #2.');
    expect(await named('nowhere.json#2')).toBe('nowhere.json: there is no such file.');
  });

  it('is one on a web server', async () => {
    expect(await named('https://parcours.example/#series=week/series.json')).toContain(
      'The series lies on a web server. Save its file, and name that.',
    );
  });
});
