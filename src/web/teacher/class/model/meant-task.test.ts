import { describe, expect, it } from 'vitest';

import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import type { HandIn } from '#check/hand-in/hand-in';
import { taskOf } from '#check/task/read-task';
import { projectForPupils } from '#check/task/write-task';
import { projectWith, sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { meantTask } from './meant-task';

const [garage, second] = ['Into the garage', 'One second'].map((name, place) => sceneWith([targetAt(600 + 100 * place, 450)], { name })) as [ReturnType<typeof sceneWith>, ReturnType<typeof sceneWith>]; // prettier-ignore
/** The hand-in of a pupil for a course that was handed out as a task. */
function handedIn(scene: typeof garage): HandIn {
  const read = taskOf({ ...projectWith(scene), task: { version: 1 } });
  const made = 'task' in read ? handInOf(projectForPupils(read.task)) : null;
  if (made === null || 'problem' in made) throw new Error('no hand-in');
  return made.handIn;
}

describe('the task that hand-ins were made for', () => {
  it('is that of more than half of them, known by its mark', () => {
    const meant = meantTask([handedIn(garage), handedIn(garage), handedIn(second)]);
    expect(meant).toMatchObject({ name: 'Into the garage', course: null, count: 2, of: 3 });
    expect([taskWith(garage), taskWith(second)].map((task) => meant?.isIt(task))).toEqual([true, false]);
    expect(meantTask([handedIn(garage), handedIn(second)])).toBeNull();
  });

  it('is unknown where programs alone were handed in', () => {
    expect(meantTask([handInOfFiles([{ name: 'main.py', text: '' }])])).toBeNull();
    expect(meantTask([])).toBeNull();
  });
});
