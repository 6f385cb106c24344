// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { checkTypes, worldName, type ClassTask } from '#check/task/task';
import { draftOf, taskOf } from '#check/task/read-task';
import { withoutSecrets } from '#check/task/write-task';
import { createPage } from '../../app/testing/page';
import { isHandedOut } from '../../session/work/model/task-locks';
import { freshCheck } from './check-fields';
import { useTaskMaker } from './use-task-maker';
import { freshWorld, startOf } from './worlds/fresh-world';

const FILES = [{ name: 'main.py', text: 'forward()\n' }];

function maker() {
  const page = createPage();
  const made = useTaskMaker(page);
  const task = (): ClassTask => {
    if (made.task.value === null) throw new Error(made.problem.value ?? 'There is no task.');
    return made.task.value;
  };
  return { page, made, task };
}

beforeEach(() => sessionStorage.clear());

describe('the task of the open work', () => {
  it('asks for the goals of the course until something else is said, and the project carries nothing', () => {
    const { page, task } = maker();
    expect(task().checks).toEqual([{ type: 'goals', id: 'goals', points: 1, needed: true }]);
    expect(page.work.work.value.project.task).toBeUndefined();
  });

  it.each(checkTypes)('can ask for “%s”, twice, and is read again as it was made', (type) => {
    const { page, made, task } = maker();
    const add = (): void =>
      made.change({ checks: [...task().checks, freshCheck(type, task().checks, task().project.scene)] });
    add();
    add();
    const { checks } = task();
    expect(checks).toHaveLength(3);
    expect(new Set(checks.map(({ id }) => id)).size).toBe(3);
    expect(draftOf(page.work.work.value.project)).toMatchObject({ task: { checks } });
  });

  it('gets hidden worlds, each with a name and a chance of its own', () => {
    const { made, task } = maker();
    const add = (): void => made.change({ worlds: [...task().worlds, freshWorld(task())] });
    add();
    add();
    expect(task().worlds.map((world) => [worldName(world), world.hidden, world.seed])).toEqual([
      ['1', false, null],
      ['2', true, 1],
      ['3', true, 2],
    ]);
  });

  it('gets hidden worlds that hide something: another start and heading, a robot with some play', () => {
    const { page, made, task } = maker();
    const robot = { ...page.work.scene.value.robot, at: [300, 200], heading: 358 } as const;
    page.work.edit({ type: 'robot', robot });
    const add = (): void => made.change({ worlds: [...task().worlds, freshWorld(task())] });
    add();
    add();
    expect(task().worlds.map(({ start, reality }) => [start, reality])).toEqual([
      [null, null],
      [{ at: [320, 199], heading: 3 }, 0.2],
      [{ at: [280, 201], heading: 353 }, 0.2],
    ]);
  });

  it('has a robot that starts where the course has it, or where a world says', () => {
    const { page, task } = maker();
    const world = { ...freshWorld(task()), start: null };
    expect(startOf(task(), world)).toMatchObject({ at: page.work.scene.value.robot.at });
    expect(startOf(task(), { ...world, start: { at: [10, 20], heading: 90 } }).at).toEqual([10, 20]);
  });

  it('is told when its course has no goal, and may still be made', () => {
    const { page, made } = maker();
    expect(made.lacksGoals.value).toBe(false);
    page.work.edit({ type: 'remove', ids: page.work.scene.value.objects.map(({ id }) => id) });
    expect(made.lacksGoals.value).toBe(true);
    expect(made.task.value).not.toBeNull();
    expect(taskOf(page.work.work.value.project)).toHaveProperty('problem');
  });

  it('has locks, which are made for the class and hold in its copy alone', () => {
    const { page, made, task } = maker();
    const locks = { ...task().locks, course: true, hand: true, tools: ['pen'], lines: [1] };
    made.change({ locks });
    expect(task().locks).toEqual(locks);
    const own = page.work.work.value.project;
    const given = withoutSecrets(own);
    expect([isHandedOut(own), isHandedOut(given)]).toEqual([false, true]);
    expect(draftOf(given)).toMatchObject({ task: { locks } });
    made.change({ locks: { ...locks, speed: 1 } });
    expect(withoutSecrets(page.work.work.value.project).task).toMatchObject({ locks: { speed: true } });
    made.change({ locks: { ...locks, speed: 'max' } });
    expect(draftOf(withoutSecrets(page.work.work.value.project))).toMatchObject({ task: { locks: { speed: 'max' } } });
    made.change({ locks: { ...locks, tools: [] } });
    expect(draftOf(withoutSecrets(page.work.work.value.project))).toMatchObject({ task: { locks: { tools: [] } } });
  });

  it('is reported if it cannot be read, and can be begun anew', () => {
    const { page, made } = maker();
    page.work.setTask({ version: 1, checks: [{ type: 'fly' }] });
    expect(made.task.value).toBeNull();
    expect(made.problem.value).toContain('task.checks[0].type');
    made.clear();
    expect(made.task.value).not.toBeNull();
  });
});

describe('what the class gets', () => {
  it('has neither the solution nor hidden worlds', () => {
    const { page, made, task } = maker();
    made.change({ id: 'A', solution: FILES, worlds: [...task().worlds, freshWorld(task())] });
    const given = withoutSecrets(page.work.work.value.project);
    expect(given.task).toMatchObject({ id: 'A' });
    expect(JSON.stringify(given.task)).not.toMatch(/solution|hidden|seed/);
  });

  it('leaves behind what cannot be read: it may hold both', () => {
    const { page } = maker();
    page.work.setTask({ version: 99, solution: FILES });
    expect(withoutSecrets(page.work.work.value.project).task).toBeUndefined();
  });

  it('is the same project where no task was made', () => {
    const { page } = maker();
    const { project } = page.work.work.value;
    expect(withoutSecrets(project)).toBe(project);
  });
});
