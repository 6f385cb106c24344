import { describe, expect, it } from 'vitest';

import { ahead, checked, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { seenRun, verdictOf } from './use-hand-in';

describe('what a pupil is told before handing in', () => {
  it('is the verdict of the run, and also what is asked of the program itself', async () => {
    const checks = [{ type: 'goals' }, { type: 'loop', id: 'loop' }];
    const task = taskWith(sceneWith([targetAt(600, 450)]), { checks });
    const seen = seenRun(task, await checked(task, ahead(3000)));
    expect(seen).toMatchObject({ passed: false, reason: { code: 'loop' }, held: ['goals'] });
    expect(verdictOf(seen)).toBe('failed');
  });

  it.each([
    [{ type: 'console', text: 'ok' }, 'open'],
    [{ type: 'stop', seconds: 60 }, 'open'],
    [{ type: 'checkpoints' }, 'open'],
    [{ type: 'display', image: '99999:99999:99999:99999:99999' }, 'open'],
    [{ type: 'faster', seconds: 1 }, 'failed'],
    [{ type: 'touches', most: 0 }, 'failed'],
  ])('is “not yet” for what may still come, and “missed” for what cannot: %j', async (check, verdict) => {
    const wall = { type: 'wall', id: 'w', from: [700, 200], to: [700, 700], thickness: 10 } as const;
    const far = { ...targetAt(100, 100, 'c'), type: 'checkpoint', number: 1 } as const;
    const task = taskWith(sceneWith([targetAt(660, 450), wall, far]), { checks: [check], seconds: 6 });
    expect(verdictOf(seenRun(task, await checked(task, ahead(5000))))).toBe(verdict);
  });
});
