// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it } from 'vitest';

import { aSeries } from '#check/series/testing/series';
import { seriesForPupils } from '#check/series/write-series';

import { isThere, tap } from '../../../app/testing/find';
import { mountOn } from '../../../app/testing/mount-on';
import { createPage, type TestPage } from '../../../app/testing/page';
import { loadTexts } from '../../../kit/i18n';
import { doneMarks } from './done-marks';
import { keepSeries } from './kept-series';
import { openTask } from './open-task';
import SeriesNext from './SeriesNext.vue';
import { placeOf } from './series-place';

const series = seriesForPupils(aSeries());
const [, goal] = series.tasks;

/** The card after a task was passed. */
async function passed(
  change: (page: TestPage) => void = () => undefined,
  task = goal!,
  leads = true,
): Promise<TestPage> {
  const page = createPage();
  await keepSeries(page, series);
  openTask(page, series, task);
  change(page);
  mountOn(page, SeriesNext, { stars: null, leads });
  await flushPromises();
  return page;
}

beforeAll(() => loadTexts('de'));

describe('after a task of a series was passed', () => {
  it('it has its mark, and the next one can be opened, which has none yet', async () => {
    const page = await passed();
    expect(doneMarks(page).all.value).toEqual({ 'woche-3/b': 0 });
    await tap('series-next');
    await flushPromises();
    expect(placeOf(page.work.work.value.project)).toEqual({ series: 'woche-3', task: '3' });
    expect(doneMarks(page).all.value).toEqual({ 'woche-3/b': 0 });
  });

  it('the way back leads to all of them after the last one', async () => {
    const page = await passed(undefined, series.tasks.at(-1));
    expect(isThere('series-next')).toBe(false);
    await tap('series-back');
    expect(page.router.page.value).toEqual({ name: 'series', id: 'series/woche-3' });
  });

  it('it has its mark, and no way on where handing in comes first', async () => {
    const page = await passed(undefined, goal, false);
    expect([isThere('series-next'), doneMarks(page).all.value]).toEqual([false, { 'woche-3/b': 0 }]);
  });

  it('has no mark in a course that was changed', async () => {
    const page = await passed(({ work }) => {
      work.locks.task.value = null;
      work.edit({ type: 'remove', ids: ['t'] });
    });
    expect([isThere('series-next'), doneMarks(page).all.value]).toEqual([true, {}]);
  });
});
