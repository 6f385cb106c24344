// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { draftOf } from '#check/task/read-task';
import { projectOfTask } from '#check/task/write-task';
import { checkTypes, type Check } from '#check/task/task';
import { teachersTask } from '#check/series/testing/series';

import { fieldsOf, freshCheck } from './check-fields';

describe('a check that is added to a task', () => {
  it.each(checkTypes)('has a value for each field of its form for kind %s, and can be read again', (type) => {
    const check: Check = freshCheck(type, [], teachersTask().scene);
    expect(Object.keys(check)).toEqual(expect.arrayContaining(fieldsOf[type].map(({ name }) => name)));
    const read = draftOf(teachersTask());
    if (!('task' in read)) throw new Error(read.problem);
    expect(draftOf(projectOfTask({ ...read.task, checks: [check] }))).toMatchObject({ task: { checks: [check] } });
  });

  it('has an id that no other check of the task has', () => {
    const all: Check[] = [];
    for (let count = 0; count < 3; count++) all.push(freshCheck('stop', all, teachersTask().scene));
    expect(new Set(all.map(({ id }) => id)).size).toBe(3);
  });
});
