import { describe, expect, it } from 'vitest';

import { projectWith, sceneWith, targetAt, taskWith } from '../testing/tasks';
import { draftOf } from './read-task';
import { projectForPupils, projectOfTask } from './write-task';

const scene = sceneWith([targetAt(600, 450)]);

describe('the most that hints to a program tell', () => {
  it('goes into the file, and to the class, only where it is not the usual', () => {
    const lines = taskWith(scene, { hint: 'lines' });
    expect(lines.hint).toBe('lines');
    expect(projectOfTask(lines).task).toMatchObject({ hint: 'lines' });
    expect(projectForPupils(lines).task).toMatchObject({ hint: 'lines' });
    for (const usual of [taskWith(scene), taskWith(scene, { hint: 'kind' })]) {
      expect(usual).not.toHaveProperty('hint');
      expect(projectOfTask(usual).task).not.toHaveProperty('hint');
    }
  });

  it('is one of five words', () =>
    expect(draftOf({ ...projectWith(scene), task: { version: 1, hint: 'all' } })).toMatchObject({
      problems: [{ path: 'task.hint' }],
    }));
});
