// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { noLocks } from '#check/task/task';
import { createPage } from '../../app/testing/page';
import { startRun, show } from '../../app/testing/run';

beforeEach(() => localStorage.clear());

describe('the mode of the arena', () => {
  it('is driving on a first visit, and offers building', () => {
    const { mode } = createPage();
    expect(mode.current.value).toBe('drive');
    expect(mode.offered.value).toEqual(['drive', 'build']);
  });

  it('offers to look back with the first run, and driving returns to the present', async () => {
    const page = createPage();
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    expect(page.mode.offered.value).toEqual(['drive', 'build', 'lookBack']);
    page.mode.enter('lookBack');
    expect(page.mode.current.value).toBe('lookBack');
    page.mode.enter('drive');
    expect([page.mode.current.value, page.run.past.value]).toEqual(['drive', null]);
  });

  it('never builds where a task locks the course, whatever was unfolded before', () => {
    const page = createPage();
    page.mode.enter('build');
    expect(page.mode.current.value).toBe('build');
    page.work.locks.task.value = { locks: { ...noLocks, course: true } } as never;
    expect([page.mode.current.value, page.mode.offered.value]).toEqual(['drive', ['drive']]);
    page.mode.enter('build');
    expect(page.mode.current.value).toBe('drive');
  });
});
