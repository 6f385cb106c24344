import { describe, expect, it } from 'vitest';

import { ahead, checked, sceneWith, targetAt, taskWith } from '../testing/tasks';
import { plainWorld } from './task';
import { mainReason, visibleTask } from './visible';

const scene = sceneWith([targetAt(600, 450)]);
const loop = { type: 'loop', id: 'loop' } as const;

describe('what is missing in a hand-in', () => {
  const missing = async (checks: readonly object[], msAhead = 3000) => {
    const task = taskWith(scene, { checks: [{ type: 'goals' }, ...checks] as never });
    return mainReason(task, await checked(task, ahead(msAhead)));
  };

  it('is nothing where all holds, or what does not gives points only', async () => {
    expect(await missing([])).toBeNull();
    expect(await missing([{ ...loop, needed: false }])).toBeNull();
  });

  it('is what the run has shown, and only then what is asked of the program itself', async () => {
    expect(await missing([loop], 100)).toMatchObject({ code: 'open' });
    expect(await missing([loop])).toMatchObject({ code: 'loop' });
  });
});

describe('the task as pupils know it', () => {
  it('has no solution, no hidden world, and does not say how many of those are wanted', () => {
    const hidden = { ...plainWorld, id: 'b', hidden: true };
    const second = { ...plainWorld, id: 'c' };
    const solution = [{ name: 'main.py', text: 'forward()' }];
    const task = { ...taskWith(scene), worlds: [plainWorld, hidden, second] as const, least: 1, solution };
    expect(visibleTask(task)).toMatchObject({ worlds: [plainWorld, second], least: null, solution: null });
  });
});
