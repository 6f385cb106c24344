// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { ClassTask } from '#check/task/task';
import type { Hint } from '#hint/hint';

import { createPage } from '../../../app/testing/page';
import { startRun } from '../../../app/testing/run';
import { createOwnHint } from './own-hint';

beforeEach(() => localStorage.clear());

const HINT = { moment: null, change: null, tried: 0, program: '', happened: { fact: 'unmoved' } } as unknown as Hint;

/** A page with a search that answers at once, or at its second request never, and the tasks it was started for. */
function opened() {
  const page = createPage();
  const tasks: ClassTask[] = [];
  const own = createOwnHint(page, {
    starter: (task) => {
      tasks.push(task);
      return Promise.resolve((heard) => ({
        ask: ({ budget }) => budget === 0 && queueMicrotask(() => heard({ result: HINT })),
        pulse: () => ({ beat: 0, world: 0 }),
        stop: () => undefined,
      }));
    },
    every: () => () => undefined,
  });
  const told = async (): Promise<void> => {
    page.task.own.level.value = 1;
    await vi.waitFor(() => expect(own.phase.value).toBe('told'));
  };
  return { page, own, tasks, told };
}
const change = (page: ReturnType<typeof createPage>, task?: object): void => {
  const { work } = page.work;
  const { task: _, ...project } = work.value.project;
  work.value = { ...work.value, project: task === undefined ? project : { ...project, task: task as never } };
};

describe('the hint to the own program', () => {
  it('is searched with the robot that the pupil has, and with the teacher’s in a task that was handed out', async () => {
    const { page, tasks, told } = opened();
    change(page);
    page.settings.change({ reality: 0.5, seed: 7 });
    await nextTick();
    await told();
    expect(tasks[0]?.project.settings).toMatchObject({ reality: 0.5, seed: 7, arenaSenses: true });
    page.task.own.level.value = 0;
    change(page, { version: 2, handedOut: true });
    await nextTick();
    await told();
    expect(tasks[1]?.project.settings?.reality ?? 0).toBe(0);
  });

  it('goes with another program or another robot, and stays when another file is looked at', async () => {
    const { page, own, told } = opened();
    await told();
    page.work.work.value = { ...page.work.work.value };
    await nextTick();
    expect(own.phase.value).toBe('told');
    page.settings.change({ reality: 1 });
    await nextTick();
    expect([own.hint.value, page.task.own.level.value]).toEqual([null, 0]);
  });

  it('is not searched on while a new run drives: the moment stays', async () => {
    const { page, own, told } = opened();
    await told();
    page.task.own.level.value = 2;
    await nextTick();
    expect(own.phase.value).toBe('tries');
    await startRun(page);
    await nextTick();
    expect([own.phase.value, page.task.own.level.value]).toEqual(['told', 1]);
  });
});
