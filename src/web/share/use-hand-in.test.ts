import { describe, expect, it } from 'vitest';

import { ahead, checked, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { seenRun } from './use-hand-in';

describe('what a pupil is told before handing in', () => {
  const scene = sceneWith([targetAt(600, 450)]);
  const told = async (checks: readonly object[]) => {
    const task = taskWith(scene, { checks: [{ type: 'goals' }, ...checks] as never });
    return seenRun(task, await checked(task, ahead(3000)));
  };

  it('is the verdict of the run', async () => expect(await told([])).toMatchObject({ passed: true, reason: null }));

  it('is also what is asked of the program itself', async () => {
    const asked = { type: 'loop', id: 'loop' };
    expect(await told([asked])).toMatchObject({ passed: false, reason: { code: 'loop' } });
    expect(await told([{ ...asked, needed: false }])).toMatchObject({ passed: true, reason: null });
  });
});
