import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { projectOfTask } from './task/write-task';
import { ahead, checked, readyScene, taskWith } from './testing/tasks';

/** A line of nine tiles; there is a gap on the second. */
const line = readyScene('rescue-short');

describe('a rescue line', () => {
  const checks = [
    { id: 'near', type: 'tiles', count: 1, points: 2 },
    { id: 'far', type: 'tiles', count: 2, points: 3, needed: false },
    { id: 'score', type: 'score', least: 15, points: 5, needed: false },
  ];
  const task = taskWith(line, { checks, seconds: 12 });

  it('is in the file of a task of version 2', () => expect(projectOfTask(task).task?.version).toBe(2));

  it('gives points for tiles that are reached, and for points on the score sheet', async () => {
    // The start is no tile that is reached; the gap brings 10 points when the tile behind it is reached.
    const { passed, points, checks: outcome } = await checked(task, ahead(4000));
    expect([passed, points]).toEqual([true, 10]);
    expect(outcome.map(({ reason }) => reason)).toEqual([null, null, null]);
  });

  it('says how many tiles and points there were', async () => {
    const { passed, points, checks: outcome } = await checked(task, ahead(1500));
    expect([passed, points]).toEqual([true, 2]);
    expect(outcome.map(({ reason }) => reason)).toMatchObject([
      null,
      { code: 'tiles', params: { done: 1, of: 2 } },
      { code: 'score', params: { found: 5, least: 15 } },
    ]);
  });

  it('is passed by its solution, all tiles and points', async () => {
    const all = [
      { type: 'tiles', count: 8 },
      { type: 'score', least: 125 },
    ];
    const solution = readFileSync('courses/rescue-short/main.py', 'utf8');
    expect(await checked(taskWith(line, { checks: all }), solution)).toMatchObject({ passed: true });
  });
});

it('a course without a league has neither tiles nor points', async () => {
  const { league: _, ...bare } = line;
  const task = taskWith(bare, { checks: [{ type: 'tiles', count: 1 }], seconds: 5 });
  expect((await checked(task, ahead(3000))).checks).toMatchObject([
    { reason: { code: 'tiles', params: { done: 0, of: 1 } } },
  ]);
});
