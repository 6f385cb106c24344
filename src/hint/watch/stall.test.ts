import { describe, expect, it } from 'vitest';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { runWorld } from '#check/run/run-world';
import type { ClassTask } from '#check/task/task';
import { firmware, readyScene, sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { PATIENCE, Stall } from './stall';

/** Simulated seconds after which nothing more was expected of a program. */
async function givenUpAfter(task: ClassTask, lines: string, patience = 1): Promise<number> {
  const { project } = handInOfFiles([{ name: 'main.py', text: `from mbrobot import *\nsetSpeed(50)\n${lines}\n` }]);
  const stall = new Stall(task, patience);
  await runWorld(task, project, task.worlds[0], { firmware: firmware(), beat: () => undefined, onlooker: stall });
  expect(stall.hasEnough).toBe(true);
  return Math.round(stall.seconds);
}

const field = taskWith(sceneWith([targetAt(1100, 100)]));

describe('a run of which nothing more is expected', () => {
  it('is that of a robot which pushes or turns for 5 s without coming to a new place', async () => {
    expect(await givenUpAfter(field, 'left()\nwhile True:\n    delay(10)')).toBe(5);
    expect(await givenUpAfter(field, 'backward()\nwhile True:\n    delay(10)')).toBeLessThan(8);
  });

  it('is that of a robot which stands for 10 s with its motors off: it may wait for something', async () => {
    expect(await givenUpAfter(field, 'while True:\n    delay(10)')).toBe(10);
    expect(await givenUpAfter(field, 'forward()\ndelay(1000)\nstop()\nwhile True:\n    delay(10)')).toBeGreaterThan(10);
  });

  it('is that of a robot which left its line 5 s ago where nothing stands that it could drive round', async () => {
    const line = taskWith(readyScene('closed-line'));
    const ahead = 'forward()\nwhile True:\n    delay(10)';
    expect(await givenUpAfter(line, ahead)).toBeLessThan(10);
  });

  it('is looked at twice as long where it is told about', async () => {
    expect(await givenUpAfter(field, 'left()\nwhile True:\n    delay(10)', PATIENCE)).toBe(10);
  });
});
