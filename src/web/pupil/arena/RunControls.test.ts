// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';

import { editingPage, press } from '../../app/testing/editing';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import RunControls from './RunControls.vue';

describe('the buttons of a run', () => {
  const disabled = (name: string) => (named(name) as HTMLButtonElement).disabled;

  it('can start at first, and neither stop nor pause', async () => {
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    const off = () => mounted.findAll('button').filter((it) => (it.element as HTMLButtonElement).disabled).map((it) => it.attributes('data-testid')); // prettier-ignore
    expect(off()).toEqual(['stop', 'pause']);
    await startRun(page);
    await show(page);
    expect(off()).not.toContain('stop');
  });

  it('stop the run that is under way', async () => {
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    await startRun(page);
    await show(page);
    await mounted.get('[data-testid="stop"]').trigger('click');
    expect(page.sent.at(-1)?.type).toBe('stop');
  });

  it('are fewer on a phone: stop shows only while there is something to stop', async () => {
    setWindow(400);
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    const ids = () => mounted.findAll('button').map((it) => it.attributes('data-testid'));
    expect(ids()).toEqual(['run', 'reset']);
    await startRun(page);
    await show(page);
    expect(ids()).toEqual(['run', 'stop', 'reset']);
  });
});
