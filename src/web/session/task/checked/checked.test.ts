// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';

import type { StartThread } from '#check/lane';
import type { CheckResult, WorldResult } from '#check/result';
import type { Verdict } from '#simulation/task/verdict';

import { editingPage, samples } from '../../../app/testing/editing';
import { show, startRun } from '../../../app/testing/run';
import { createChecked } from './checked';

const reason = { code: 'loop', params: {} } as const;
const passed: CheckResult = {
  ...{ passed: true, points: 2, stars: null, remarks: [], twin: '' },
  checks: [
    { id: 'goals', passed: true, reason: null },
    { id: 'loop', passed: true, reason: null },
  ],
  worlds: [{ id: 'visible', passed: true, reason: null, atMs: 2000 } as unknown as WorldResult],
};
const lacking: CheckResult = {
  ...passed,
  passed: false,
  checks: [
    { id: 'goals', passed: true, reason: null },
    { id: 'loop', passed: false, reason },
  ],
};

/** A page with a task; `answer` gives what the check of the program finds. */
async function pupil(checks: readonly string[], objects = [samples.target]) {
  const page = await editingPage(objects);
  const { project } = page.work.work.value;
  const asked = checks.map((type) => ({ type, id: type }));
  page.work.openProject({ ...project, task: { version: 1, checks: asked } }, 'Ada');
  let heard: Parameters<StartThread>[0] = () => undefined;
  const start: StartThread = (hear) => {
    heard = hear;
    return { ask: () => undefined, pulse: () => ({ beat: 0, world: 0 }), stop: () => undefined };
  };
  const ports = { starter: () => Promise.resolve(start), every: () => () => undefined };
  const checked = createChecked(page, ports);
  const tell = (state: Verdict['state'], timeUs: number) =>
    show(page, { timeUs, verdict: { state, stars: null } as unknown as Verdict });
  const answer = async (result: CheckResult) => {
    heard({ result });
    await flushPromises();
  };
  return { ...page, checked, tell, answer };
}

describe('a task that asks for more than the goals of its course', () => {
  it('is passed when the goals are reached and all the rest holds', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await answer(passed);
    await tell('open', 1_000_000);
    expect(checked.state.value).toBe('live');
    await tell('passed', 2_000_000);
    expect([checked.state.value, checked.reason.value]).toEqual(['passed', null]);
  });

  it('lacks what does not hold, though the goals are reached', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await answer(lacking);
    await tell('passed', 2_000_000);
    expect([checked.state.value, checked.reason.value]).toEqual(['lacking', reason]);
  });

  it('praises no moment of the past that was long before', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await answer(passed);
    await tell('passed', 2_000_000);
    page.say({
      type: 'program-ended',
      ended: { kind: 'finished', exception: null, timeUs: 2_000_000 } as never,
      device: 0,
    });
    page.run.look.back();
    expect(checked.state.value).toBe('passed');
    page.run.look.show({
      ...page.run.present.value!,
      timeUs: 380_000,
      verdict: { state: 'open', stars: null } as never,
    });
    expect(checked.state.value).toBe('live');
  });

  it('praises nobody before the check is over', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await tell('passed', 2_000_000);
    expect(checked.state.value).toBe('checking');
    await answer(lacking);
    expect(checked.state.value).toBe('lacking');
  });

  it('is passed in its own time where one of several targets will do, whatever the run says of the others', async () => {
    const { checked, tell, answer, ...page } = await pupil(['reach', 'loop']);
    await startRun(page);
    await answer(passed);
    await tell('open', 1_000_000);
    expect(checked.state.value).toBe('live');
    await tell('open', 2_100_000);
    expect(checked.state.value).toBe('passed');
    await tell('failed', 2_200_000);
    expect(checked.state.value).toBe('passed');
  });

  it('leaves it to the run to say that it has failed, or that the hand has helped', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await answer(passed);
    await tell('failed', 2_000_000);
    expect(checked.state.value).toBe('live');
    await tell('helped', 2_000_000);
    expect(checked.state.value).toBe('live');
  });

  it('forgets what was found with the next run, and when all is put back', async () => {
    const { checked, tell, answer, ...page } = await pupil(['goals', 'loop']);
    await startRun(page);
    await answer(lacking);
    await tell('passed', 2_000_000);
    await startRun(page);
    await tell('passed', 2_000_000);
    expect(checked.state.value).toBe('checking');
    await answer(passed);
    const isBack = page.run.reset();
    page.say({ type: 'stopped' });
    await isBack;
    expect([checked.state.value, checked.result.value]).toEqual(['live', null]);
  });
});

describe('a task whose course has no goals', () => {
  it('is passed at the moment at which its check was', async () => {
    const { checked, tell, answer, ...page } = await pupil(['loop'], []);
    await startRun(page);
    await answer(passed);
    await tell('open', 1_900_000);
    expect(checked.state.value).toBe('live');
    await tell('open', 2_000_000);
    expect(checked.state.value).toBe('passed');
  });
});

describe('a task of goals alone', () => {
  it('is not checked a second time', async () => {
    const { checked, tell, ...page } = await pupil(['goals']);
    await startRun(page);
    await tell('passed', 2_000_000);
    expect([checked.task.value, checked.state.value]).toEqual([null, 'live']);
  });
});
