import { describe, expect, it } from 'vitest';

import { ahead, checked, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { seenRun } from './use-hand-in';

describe('what a pupil is told before handing in', () => {
  it('is the verdict of the run, and also what is asked of the program itself', async () => {
    const checks = [{ type: 'goals' }, { type: 'loop', id: 'loop' }];
    const task = taskWith(sceneWith([targetAt(600, 450)]), { checks });
    const seen = seenRun(task, await checked(task, ahead(3000)));
    expect(seen).toMatchObject({ passed: false, reason: { code: 'loop' }, held: ['goals'] });
  });
});
