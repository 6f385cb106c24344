// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';

import { aSeries } from '#check/series/testing/series';
import { seriesForPupils } from '#check/series/write-series';

import { byId, idsShown, isThere, tap } from '../../app/testing/find';
import { leavePage, mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { doneMarks } from '../../session/task/series/done-marks';
import { keepSeries } from '../../session/task/series/kept-series';
import { placeOf } from '../../session/task/series/series-place';
import SeriesPage from './SeriesPage.vue';

const series = seriesForPupils(aSeries());

/** The page of a series that was opened before, with what is done of it; `from` is its address. */
async function opened(done: Readonly<Record<string, number>> = {}, from = 'woche-3') {
  const page = createPage();
  await keepSeries(page, series);
  for (const [task, stars] of Object.entries(done)) doneMarks(page).mark({ series: 'woche-3', task }, stars);
  page.router.open('series', from);
  const mounted = mountOn(page, SeriesPage);
  await flushPromises();
  return { page, mounted };
}

describe('the page of a series', () => {
  it('shows its tasks in order, and how many are done', async () => {
    await opened({ b: 0 });
    expect(idsShown('series-task-')).toEqual(['series-task-1', 'series-task-2', 'series-task-3']);
    expect(textOf(byId('series-sum'))).toBe('1 von 3 erledigt');
    expect(idsShown('series-done-')).toEqual(['series-done-2']);
    expect(textOf(byId('series-task-2'))).toContain('Ans Ziel');
  });

  it('goes on with the first task that is not done, and opens it', async () => {
    const { page } = await opened({ '1': 2 });
    expect(byId('series-task-2').getAttribute('aria-current')).toBe('step');
    await tap('series-open-next');
    expect(placeOf(page.work.work.value.project)).toEqual({ series: 'woche-3', task: 'b' });
    expect(page.router.page.value).toBeNull();
  });

  it('says when all are done, and then offers no next one', async () => {
    await opened({ '1': 0, b: 0, '3': 0 });
    expect(textOf(byId('series'))).toContain('Alle Aufgaben sind erledigt');
    expect(isThere('series-open-next')).toBe(false);
  });

  it('says that a series is not in this browser', async () => {
    await opened({}, 'woche-4');
    expect(textOf(byId('series-problem'))).toContain('nicht in diesem Browser');
    expect(idsShown('series-task-')).toEqual([]);
  });

  it('knows nothing of what was done on a page before, where the browser has forgotten it', async () => {
    const { mounted } = await opened({ b: 0 });
    leavePage(mounted);
    localStorage.clear();
    await opened();
    expect(textOf(byId('series-sum'))).toBe('0 von 3 erledigt');
  });
});
