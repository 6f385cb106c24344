// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import RunControls from './RunControls.vue';

const failed = {
  kind: 'exception',
  exception: { type: 'NameError', message: 'x', line: null, traceback: '' },
  timeUs: 1000,
} as const;

function controls() {
  const page = createPage();
  const mounted = mountOn(page, RunControls);
  const ids = () => mounted.findAll('button').map((it) => it.attributes('data-testid'));
  return { page, mounted, ids };
}

describe('the buttons of a run', () => {
  it('are Run alone at first, and each other one while it can be used', async () => {
    const { page, ids } = controls();
    expect(ids()).toEqual(['run']);
    await startRun(page);
    await show(page);
    expect(ids()).toEqual(['run', 'stop', 'pause', 'reset']);
  });

  it('stop the run that is under way', async () => {
    const { page, mounted } = controls();
    await startRun(page);
    await show(page);
    await mounted.get('[data-testid="stop"]').trigger('click');
    expect(page.sent.at(-1)?.type).toBe('stop');
  });

  it('leave time to the other modes: looking back has its own way through it, building has none', async () => {
    const { page, ids } = controls();
    await startRun(page);
    await show(page);
    page.mode.enter('lookBack');
    await nextTick();
    expect(ids()).toEqual(['run', 'reset']);
    page.mode.enter('build');
    await nextTick();
    expect(ids()).toEqual(['run']);
  });

  it('stop nothing where an error has ended a program and nothing moves, until somebody turns to its device', async () => {
    const { page, ids } = controls();
    await startRun(page);
    await show(page, { motors: [1, 1] });
    page.say({ type: 'program-ended', device: 0, ended: failed });
    await nextTick();
    expect(ids()).toEqual(['run', 'stop', 'reset']);
    await show(page, { motors: [0, 0] });
    expect(ids()).toEqual(['run', 'reset']);
    page.console.visitRepl();
    await nextTick();
    expect(ids()).toEqual(['run', 'stop', 'reset']);
  });

  it('are fewer on a phone: run or stop', async () => {
    setWindow(400);
    const { page, ids } = controls();
    expect(ids()).toEqual(['run']);
    await startRun(page);
    await show(page);
    expect(ids()).toEqual(['stop', 'pause']);
  });
});
