import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { parseProject } from '#project/file';
import type { Project } from '#project/project';
import { handInOf, handInOfFiles } from '../hand-in/read-hand-in';
import { check } from '../check';
import { ahead, firmware, projectWith, sceneWith, targetAt } from '../testing/tasks';
import { chosenLevel, hintsAllowed } from './chosen-level';
import { taskOf } from './read-task';
import type { ClassTask } from './task';
import { projectForPupils, projectOfTask, withoutSecrets } from './write-task';

const levels = [
  { name: 'leer', text: '' },
  { name: 'Lücken', text: 'from mbrobot import *\n# hier\nstop()\n', lines: [1] },
  { name: 'fast fertig', text: ahead(900), lines: [1, 2] },
];
const withLevels = (given: unknown): Project => ({
  ...projectWith(sceneWith([targetAt(600, 450)]), ''),
  task: { version: 1, levels: given },
});
function taskIn(project: Project): ClassTask {
  const read = taskOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return read.task;
}
const task = taskIn(withLevels(levels));
const given = projectForPupils(task);

describe('a task with levels', () => {
  it('is written and read as it was, by teachers and by pupils; the kept one of version 1, too', () => {
    expect(taskOf(projectOfTask(task))).toEqual({ task });
    expect(given.task?.['levels']).toEqual(levels);
    const kept = parseProject(readFileSync(new URL('kept/levels-v1.json', import.meta.url), 'utf8'));
    if ('problem' in kept) throw new Error(kept.problem);
    expect(taskIn(kept.project)).toMatchObject({
      levels: [
        { name: 'leer', lines: [] },
        { name: 'Lücken', lines: [1] },
      ],
      about: { level: 'Klasse 7', licence: 'CC-BY-4.0' },
    });
  });

  it.each([
    [[], 'task.levels: 0 entries; there may be 1 … 3.'],
    [Array(4).fill(levels[0]), 'task.levels: 4 entries'],
    [[levels[0], levels[0]], 'task.levels[1].name: another level is called "leer".'],
    [[{ name: '', text: '' }], 'task.levels[0].name: must not be empty.'],
    [[{ name: 'leer' }], 'task.levels[0].text: is missing'],
    [[{ name: 'leer', text: '', hints: 6 }], 'task.levels[0].hints: 6 is not within 0 … 5.'],
    [[{ name: 'leer', text: '', lines: [0] }], 'task.levels[0].lines[0]: 0 is not within'],
  ])('%# says what is wrong with them', (wrong, problem) => {
    expect(taskOf(withLevels(wrong))).toMatchObject({ problem: expect.stringContaining(problem) as string });
  });

  it('may allow fewer of the card’s hints, once one is chosen', () => {
    const few = taskIn(withLevels([levels[0], { ...levels[0], name: 'ohne Tipps', hints: 0 }]));
    const pupils = projectForPupils(few).task;
    expect(taskOf(projectOfTask(few))).toEqual({ task: few });
    expect(hintsAllowed(pupils)).toBe(Infinity);
    expect(hintsAllowed({ ...pupils!, level: 0 })).toBe(Infinity);
    expect(hintsAllowed({ ...pupils!, level: 1 })).toBe(0);
  });

  it('goes with the choice of the pupil into the hand-in, and into a link to it', () => {
    const chosen = withoutSecrets({ ...given, task: { ...given.task, level: 1 } });
    expect(chosenLevel(chosen.task)).toBe(1);
    expect(handInOf(chosen)).toMatchObject({ handIn: { level: 1 } });
    expect(withoutSecrets(projectOfTask(task)).task).not.toHaveProperty('level');
    for (const wrong of [-1, 3, 0.5, '1', null]) expect(chosenLevel({ level: wrong })).toBeNull();
  });

  it('is checked for the locked lines of the level that was chosen; a program alone may come from any', async () => {
    const remarks = async (text: string, level?: number): Promise<readonly string[]> => {
      const alone = handInOfFiles([{ name: 'main.py', text }]);
      const handIn = level === undefined ? alone : { ...alone, level };
      return (await check(task, handIn, { firmware: firmware() })).remarks.map(({ code }) => code);
    };
    const own = `${ahead(900)}# mein\n`;
    expect(await remarks(own, 2)).toEqual([]);
    expect(await remarks(own.replace('setSpeed(50)', 'setSpeed(90)'), 2)).toEqual(['outside']);
    expect(await remarks('x = 1\n', 0)).toEqual([]);
    expect(await remarks('x = 1\n', 1)).toEqual(['outside']);
    expect(await remarks('x = 1\n')).toEqual([]);
    expect(await remarks(levels[2]!.text)).toEqual(['unchanged']);
  });
});
