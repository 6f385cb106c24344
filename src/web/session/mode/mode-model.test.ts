// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { noLocks } from '#check/task/task';
import { defaultScene } from '#scene/scene';
import { createPage } from '../../app/testing/page';
import { startRun, show } from '../../app/testing/run';
import { useModeKeys } from './mode-keys';

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

  it('is new to look back until somebody has done it', async () => {
    const page = createPage();
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    page.settings.change({ lookedBack: false });
    expect(page.settings.current.value.lookedBack).toBe(false);
    page.mode.enter('lookBack');
    expect(page.settings.current.value.lookedBack).toBe(true);
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

  it('pauses a run when building begins, and drives with the next start', async () => {
    const page = createPage();
    await startRun(page);
    page.mode.enter('build');
    expect([page.mode.current.value, page.run.phase.value]).toEqual(['build', 'paused']);
    await startRun(page);
    expect(page.mode.current.value).toBe('drive');
  });

  it('drives when a run starts out of the past, whatever was built before', async () => {
    const page = createPage();
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    page.mode.enter('build');
    page.mode.enter('lookBack');
    await startRun(page);
    expect(page.mode.current.value).toBe('drive');
  });

  it('drives on another course, unless the address wants it built', () => {
    for (const [mode, then] of [
      [null, 'drive'],
      ['build', 'build'],
    ] as const) {
      const page = createPage({ mode });
      page.mode.enter('build');
      page.work.setScene(defaultScene(), null);
      expect(page.mode.current.value).toBe(then);
    }
  });

  it('is building from the start for a host that shows the tools and no program, and never where it shows none', () => {
    expect(createPage({ settings: { parts: ['arena', 'tools'] } }).mode.current.value).toBe('build');
    const without = createPage({ settings: { parts: ['code', 'arena'] } });
    without.mode.enter('build');
    expect([without.mode.current.value, without.mode.offered.value]).toEqual(['drive', ['drive']]);
  });

  it('has keys anywhere on the page', async () => {
    const page = createPage();
    page.scope.run(() => useModeKeys(page));
    const press = (init: KeyboardEventInit): boolean =>
      document.body.dispatchEvent(new KeyboardEvent('keydown', { bubbles: true, cancelable: true, ...init }));
    press({ altKey: true, code: 'Digit2', key: '“' });
    expect(page.mode.current.value).toBe('build');
    press({ altKey: true, code: 'Digit3' });
    expect(page.mode.current.value).toBe('build'); // nothing has run yet
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    press({ altKey: true, code: 'Digit3' });
    expect(page.mode.current.value).toBe('lookBack');
    page.scope.stop();
  });
});
