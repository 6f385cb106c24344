import { shallowRef } from 'vue';
import { describe, expect, it } from 'vitest';

import { ownLevels } from './own-levels';

/** Number of levels of the hint after so many runs in a task with these data. */
const levels = (fails: number, task: object | undefined, most = 4): number =>
  ownLevels({ fails: shallowRef(fails), level: shallowRef(0), most: shallowRef(most) }, {
    work: { work: shallowRef({ project: { task } }) },
  } as never);

describe('the levels of the hint to a program', () => {
  it('are there after the second run without success: up to the kind of change', () => {
    expect([0, 1, 2].map((fails) => levels(fails, undefined))).toEqual([0, 0, 3]);
  });

  it('are as many as the task says, and none in an exam', () => {
    const told = ['off', 'moment', 'lines', 'kind', 'change'].map((hint) => levels(2, { version: 2, hint }));
    expect(told).toEqual([0, 1, 2, 3, 4]);
    expect(levels(2, { version: 2, exam: { minutes: 45 } })).toBe(0);
  });

  it('are two where no change was found', () => expect(levels(3, { version: 2, hint: 'change' }, 2)).toBe(2));
});
