// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';

import { aSeries } from '#check/series/testing/series';
import type { Series } from '#check/series/series';
import { seriesForPupils } from '#check/series/write-series';

import { createPage, type TestPage } from '../../../app/testing/page';
import { loadTexts } from '../../../kit/i18n';
import { LateModels } from '../../../kit/state/late-models';
import { stubDatabase } from '../../work/storage/testing/memory-database';
import { createDoneMarks } from './done-marks';
import { keepDraft, keepSeries, keptDraft, reopenSeries, storedSeriesAt } from './kept-series';
import { openTask, taskAfter, taskName, workOn } from './open-task';
import { placeOf } from './series-place';
import { isAsGiven, taskOfWork } from './series-task';
import { useSeriesWay } from './use-series-way';

const series: Series = seriesForPupils(aSeries());
const [line, goal, plain] = series.tasks as [Series['tasks'][0], Series['tasks'][0], Series['tasks'][0]];
const projectOf = (page: TestPage) => page.work.work.value.project;

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  localStorage.clear();
  sessionStorage.clear();
});

describe('a task of a series', () => {
  it('is called as the series says, else as its course', () =>
    expect(series.tasks.map(taskName)).toEqual(['Geschlossene Linie', 'Ans Ziel', 'Ohne Aufgabe']));

  it('is opened as it was handed out, with its locks, and knows its place over a reload', async () => {
    const page = createPage();
    openTask(page, series, goal);
    expect(projectOf(page)).toMatchObject({
      task: { handedOut: true, locks: { course: true } },
      handIn: { version: 1, series: { series: 'woche-3', task: 'b' } },
    });
    expect(taskOfWork(projectOf(page), series)).toBe(goal);
    await keepSeries(page, series);
    const way = page.scope.run(() => useSeriesWay(page))!;
    await flushPromises();
    expect([way.task.value, way.next.value]).toEqual([goal, plain]);
  });

  it('comes back as it was left if it was begun, or is opened anew', () => {
    const page = createPage();
    openTask(page, series, goal);
    page.work.setText('main.py', 'forward()\n# mein Weg\n');
    openTask(page, series, plain);
    expect(taskOfWork(projectOf(page), series)).toBe(plain);
    expect(workOn(page, series, goal)).toMatchObject({ project: { files: [{ text: 'forward()\n# mein Weg\n' }] } });
    openTask(page, series, goal);
    expect(page.work.find('main.py')?.text).toContain('# mein Weg');
    openTask(page, series, goal, true);
    expect(page.work.find('main.py')?.text).toBe('forward()\n');
  });

  it('is not put aside if it was only looked at', () => {
    const page = createPage();
    openTask(page, series, goal);
    openTask(page, series, plain);
    openTask(page, series, line);
    expect(page.work.work.value.previous).toEqual([]);
  });

  it('is none of the series any more once another course is under the program, and a changed course does not count', () => {
    const page = createPage();
    openTask(page, series, plain);
    expect(isAsGiven(projectOf(page), plain)).toBe(true);
    page.work.edit({ type: 'remove', ids: ['t'] });
    expect([taskOfWork(projectOf(page), series), isAsGiven(projectOf(page), plain)]).toEqual([plain, false]);
    page.work.setScene({ ...page.work.scene.value, name: 'Anderes' }, null);
    expect([placeOf(projectOf(page)), taskOfWork(projectOf(page), series)]).toMatchObject([{ task: '3' }, null]);
  });

  it('leads to the next one that can be opened', () => {
    const unread = { kind: 'unread', value: 1, problem: '', problems: [] } as const;
    const gap: Series = { ...series, tasks: [line, { ...goal, from: unread }, plain] };
    expect([taskAfter(gap, line), taskAfter(gap, plain)]).toEqual([plain, null]);
  });
});

describe('what is done', () => {
  const place = { series: 'woche-3', task: 'b' };

  it('stays in this browser with the most stars, for each series and task', () => {
    createDoneMarks(localStorage).mark(place, 2);
    createDoneMarks(localStorage).mark(place, 1);
    createDoneMarks(localStorage).mark({ ...place, series: 'woche-4' }, 0);
    const marks = createDoneMarks(localStorage);
    expect(marks.all.value).toEqual({ 'woche-3/b': 2, 'woche-4/b': 0 });
    marks.clear(place);
    expect(createDoneMarks(localStorage).all.value).toEqual({ 'woche-4/b': 0 });
  });

  it('is nothing where what is stored cannot be read', () => {
    for (const text of ['{', '[]', '{"a/b":7}']) {
      localStorage.setItem('parcours.series', text);
      expect(createDoneMarks(localStorage).all.value).toEqual({});
    }
  });
});

describe('a series that was opened', () => {
  it('is kept, also under the address that it was fetched from', async () => {
    const app = { late: new LateModels() };
    const { entries } = stubDatabase();
    await keepSeries(app, series, 'https://schule.example/a/series.json');
    expect([...entries.keys()]).toEqual(['series.of.woche-3']);
    expect(await reopenSeries(app, 'woche-3')).toEqual(series);
    expect(await reopenSeries(app, 'other')).toBeNull();
  });

  it('is still found by its address after it was opened by its id on another visit', async () => {
    stubDatabase();
    await keepSeries({ late: new LateModels() }, series, 'https://schule.example/a/series.json');
    expect(await reopenSeries({ late: new LateModels() }, 'woche-3')).toEqual(series);
    expect(await storedSeriesAt('https://schule.example/a/series.json')).toEqual(series);
  });

  it('works while the page is open where the browser keeps nothing', async () => {
    const app = { late: new LateModels() };
    stubDatabase(false);
    await keepSeries(app, series);
    expect(await reopenSeries(app, 'woche-3')).toEqual(series);
    expect(await storedSeriesAt('https://schule.example/')).toBeNull();
  });

  it('is kept with its solutions if it is still being made', async () => {
    stubDatabase();
    await keepDraft(aSeries());
    expect(await keptDraft()).toEqual(aSeries());
  });
});
