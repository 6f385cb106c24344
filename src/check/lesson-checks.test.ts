import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { SceneObject } from '#scene/scene';
import { parseProject } from '#project/file';
import { draftOf, taskOf } from './task/read-task';
import { mostPoints } from './task/task';
import { projectOfTask } from './task/write-task';
import { ahead, checked, checkpointAt, projectWith, sceneWith, targetAt, taskWith } from './testing/tasks';

/** A field that is `width` mm wide and 140 mm high. */
const bay = (x: number, width: number, id: string): SceneObject => ({
  ...targetAt(x, 450, id),
  ...{ size: [width, 200], round: false },
});

const block = (x: number, id = 'box'): SceneObject => ({
  ...{ type: 'block', id, at: [x, 450], size: [60, 60], angle: 0 },
});

/** The first world's result of a program in a course with these things, checked for one thing. */
async function resultOf(objects: readonly SceneObject[], asked: Record<string, unknown>, program: string) {
  const task = taskWith(sceneWith(objects), { checks: [asked] as unknown, seconds: 20 });
  const { passed, points, worlds } = await checked(task, program);
  return { passed, points, reason: worlds[0]?.reason ?? null, atMs: worlds[0]?.atMs ?? null };
}

const turning = (ms: number): string =>
  `from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(2000)\nleft()\ndelay(${String(ms)})\nstop()\n`;

describe('any of several targets', () => {
  const bays = [bay(500, 200, 'a'), bay(900, 200, 'b')];

  it('is reached with the first one, whichever it is', async () => {
    const { passed, atMs } = await resultOf(bays, { type: 'reach' }, ahead(9000));
    expect(passed).toBe(true);
    expect(atMs).toBeLessThan(2500);
    const other = await resultOf(bays, { type: 'reach', zones: ['b'] }, ahead(9000));
    expect(other.passed).toBe(true);
    expect(other.atMs).toBeGreaterThan(2500);
  });

  it('says that none is reached', async () =>
    expect(await resultOf(bays, { type: 'reach' }, ahead(500))).toMatchObject({
      passed: false,
      reason: { code: 'reach' },
    }));
});

describe('standing in a field', () => {
  const stop = { type: 'stop', seconds: 1 };

  it('counts with the middle of the axle, or only with the whole robot', async () => {
    const narrow = [bay(400, 100, 'a')];
    expect(await resultOf(narrow, stop, ahead(1400))).toMatchObject({ passed: true });
    expect(await resultOf(narrow, { ...stop, whole: true }, ahead(1400))).toMatchObject({
      passed: false,
      reason: { code: 'whole' },
    });
    expect(await resultOf([bay(400, 300, 'a')], { ...stop, whole: true }, ahead(1400))).toMatchObject({ passed: true });
  });

  it('counts only in the direction that is asked for, within so many degrees', async () => {
    const wide = [bay(500, 500, 'a')];
    const facing = (heading: number, within = 15) => ({ ...stop, heading, within });
    expect(await resultOf(wide, facing(0), ahead(1400))).toMatchObject({ passed: true });
    expect(await resultOf(wide, facing(360, 1), ahead(1400))).toMatchObject({ passed: true });
    expect(await resultOf(wide, facing(90), ahead(1400))).toMatchObject({
      passed: false,
      reason: { code: 'heading', params: { heading: 90 } },
    });
    expect(await resultOf(wide, facing(-90, 95), ahead(1400))).toMatchObject({ passed: true });
    expect(await resultOf(wide, facing(90, 45), turning(450))).toMatchObject({ passed: true });
  });
});

describe('time in a field', () => {
  it('goes on while the robot stands there after the end of its program', async () => {
    const field = [bay(420, 300, 'a')];
    expect(await resultOf(field, { type: 'stay', seconds: 4, zone: 'a' }, ahead(1400))).toMatchObject({ passed: true });
  });

  it('is that of all visits together', async () => {
    const stay = { type: 'stay', seconds: 1, zone: 'a' };
    const there =
      'from mbrobot import *\nsetSpeed(50)\nfor _ in range(2):\n    forward()\n    delay(1800)\n    backward()\n    delay(1800)\nstop()\n';
    const once = ahead(4000);
    const field = [bay(380, 120, 'a')];
    const [short, twice] = [await resultOf(field, stay, once), await resultOf(field, stay, there)];
    expect([short.passed, twice.passed]).toEqual([false, true]);
    expect(short.reason).toMatchObject({ code: 'stay', params: { seconds: 1 } });
    expect(short.reason?.params['found']).toBeGreaterThan(0.3);
  });
});

describe('a thing in its place', () => {
  const belongs = { type: 'belongs', object: 'box', zone: 'a' };

  it('lies there wholly once the robot has pushed it in', async () => {
    const objects = [block(400), bay(600, 160, 'a'), bay(900, 160, 'b')];
    expect(await resultOf(objects, belongs, ahead(3600))).toMatchObject({ passed: true });
    expect(await resultOf(objects, { ...belongs, zone: 'b' }, ahead(3600))).toMatchObject({
      passed: false,
      reason: { code: 'belongs', params: { object: 'box', zone: 'b' } },
    });
  });

  it('must be there at the same time as all the others', async () => {
    const objects = [block(400), block(1000, 'other'), bay(600, 160, 'a'), bay(1000, 160, 'b')];
    const checks = [belongs, { ...belongs, object: 'other', zone: 'b', id: 'second' }];
    const task = taskWith(sceneWith(objects), { checks, seconds: 20 });
    expect((await checked(task, ahead(3600))).passed).toBe(true);
    expect((await checked(task, ahead(700))).passed).toBe(false);
  });
});

describe('floor driven over', () => {
  it('grows with the way, and counts in one field alone if one is named', async () => {
    const lane = [bay(500, 200, 'lane')];
    const covered = (percent: number) => ({ type: 'covered', percent, zone: 'lane' });
    expect(await resultOf(lane, covered(30), ahead(5000))).toMatchObject({ passed: true });
    const { passed, reason } = await resultOf(lane, covered(95), ahead(5000));
    expect(passed).toBe(false);
    expect(reason).toMatchObject({ code: 'covered', params: { percent: 95 } });
    expect(reason?.params['found']).toBeGreaterThan(30);
    expect(reason?.params['found']).toBeLessThan(60);
  });

  it('is that of the whole arena without a field', async () => {
    const { passed, reason } = await resultOf([], { type: 'covered', percent: 50, zone: undefined }, ahead(3000));
    expect(passed).toBe(false);
    expect(reason?.params['found']).toBeLessThan(15);
  });
});

describe('not too early', () => {
  it('fails what is reached before the time', async () => {
    const task = (seconds: number) =>
      taskWith(sceneWith([targetAt(700, 450)]), { checks: [{ type: 'goals' }, { type: 'later', seconds }] });
    expect((await checked(task(1), ahead(4000))).passed).toBe(true);
    const early = await checked(task(20), ahead(4000));
    expect(early.passed).toBe(false);
    expect(early.worlds[0]?.reason).toEqual({ code: 'early', params: { seconds: 20 } });
  });
});

describe('points for each checkpoint', () => {
  const course = sceneWith([checkpointAt(400, 450, 1), checkpointAt(700, 450, 2), checkpointAt(700, 800, 3)]);
  const task = taskWith(course, { checks: [{ type: 'checkpoints', each: 2, points: 4 }], seconds: 12 });

  it('are given for those that were reached, and more for all', async () => {
    expect(mostPoints(task)).toBe(10);
    expect((await checked(task, ahead(1800))).points).toBe(2);
    expect((await checked(task, ahead(4000))).points).toBe(4);
    expect((await checked(task, 'x = 1')).points).toBe(0);
  });

  it('count in a hidden world, too: the fewest', async () => {
    const worlds = [{ id: 'far', start: { at: [200, 100], heading: 0 } }];
    const hidden = taskWith(course, { checks: [{ type: 'checkpoints', each: 2 }], worlds, seconds: 12 });
    expect((await checked(hidden, ahead(4000))).points).toBe(0);
  });
});

describe('the data of these checks', () => {
  it('are version 2 of a task; one without them stays version 1', () => {
    const versionOf = (checks: unknown): unknown =>
      projectOfTask(taskWith(sceneWith([bay(500, 200, 'a')]), { checks })).task?.version;
    expect(versionOf([{ type: 'goals' }, { type: 'stop', seconds: 1, zone: 'a' }, { type: 'checkpoints' }])).toBe(1);
    for (const check of [
      { type: 'stop', seconds: 1, whole: true },
      { type: 'stop', seconds: 1, heading: 90 },
      { type: 'checkpoints', each: 1 },
      { type: 'reach' },
      { type: 'later', seconds: 1 },
    ])
      expect([check, versionOf([check])]).toEqual([check, 2]);
  });

  it('are read from a kept file as they were written', () => {
    const kept = parseProject(readFileSync(new URL('task/kept/v2.json', import.meta.url), 'utf8'));
    const read = 'project' in kept ? taskOf(kept.project) : kept;
    if (!('task' in read)) throw new Error(read.problem);
    const { checks } = read.task;
    expect(checks.map(({ type }) => type)).toEqual(
      ['reach', 'stop', 'stay', 'checkpoints', 'belongs', 'covered', 'later'], // prettier-ignore
    );
    expect(checks[1]).toMatchObject({ seconds: 2, zone: 'a', whole: true, heading: 90, within: 10 });
    expect(checks.at(-1)).toMatchObject({ seconds: 10, points: 2, needed: false });
  });

  it('name what the course has, or the task says what there is', () => {
    const problemOf = (check: Record<string, unknown>): unknown => {
      const project = { ...projectWith(sceneWith([bay(500, 200, 'a'), block(400)])) };
      const read = taskOf({ ...project, task: { version: 2, checks: [check] } });
      return 'problem' in read ? read.problem : null;
    };
    expect(problemOf({ type: 'belongs', object: 'box', zone: 'a' })).toBeNull();
    expect(problemOf({ type: 'belongs', object: 'boks', zone: 'a' })).toBe(
      'task.checks[0].object: the course has no movable block "boks". It has: box.',
    );
    expect(problemOf({ type: 'reach', zones: ['a', 'c'] })).toBe(
      'task.checks[0].zones: the course has no zone "c". It has: a.',
    );
    expect(problemOf({ type: 'covered', percent: 140 })).toMatch(/percent/);
  });

  it('may name what is not there while the task is being made', () => {
    const project = projectWith(sceneWith([bay(500, 200, 'a')]));
    const draft = draftOf({ ...project, task: { version: 2, checks: [{ type: 'stay', seconds: 1, zone: 'gone' }] } });
    expect('task' in draft).toBe(true);
  });
});
