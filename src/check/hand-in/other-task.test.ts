import { describe, expect, it } from 'vitest';
import type { Project } from '#project/project';
import { classResult, otherTasks } from '../report/class-result';
import { htmlOf } from '../report/html';
import { otherTaskTexts } from '../report/say';
import { ahead, checkedProject, projectWith, sceneWith, targetAt, taskWith } from '../testing/tasks';
import { projectForPupils } from '../task/write-task';
import { taskOf } from '../task/read-task';

const open = taskWith(sceneWith([targetAt(600, 450)], { name: 'One second' }));
const garage = sceneWith([targetAt(900, 450)], { name: 'Into the garage' });

/** Statement of a pupil's page that would lead to remarks if it were about this task. */
const said = { version: 1, alias: 'Ada', verdict: 'passed', tries: 2, hash: 'abc', remarks: ['course', 'outside'] };
const handedOut = (): Project => {
  const read = taskOf({ ...projectWith(garage), task: { version: 1, locks: { hand: true, course: true } } });
  if ('problem' in read) throw new Error(read.problem);
  return { ...projectForPupils(read.task), files: [{ name: 'main.py', text: ahead(100) }] };
};
const remarksOf = async (project: Project, task = open) => (await checkedProject(task, project)).remarks;

describe('a hand-in for another task', () => {
  it('is known by the mark of the course that was handed out, and nobody is suspected of anything', async () => {
    const project = { ...handedOut(), handIn: said };
    expect(await remarksOf(project)).toEqual([{ code: 'other-task', params: { task: 'Into the garage' } }]);
  });

  it('is known by its ready course, or else by the name of its course', async () => {
    const ready = { ...projectWith({ ...garage, name: '' }), course: 'garage', handIn: said };
    const other = { ...open, project: { ...open.project, course: 'second' } };
    expect(await remarksOf(ready, other)).toEqual([{ code: 'other-task', params: { task: 'garage' } }]);
    expect(await remarksOf({ ...projectWith(garage), handIn: said })).toMatchObject([{ code: 'other-task' }]);
  });

  it('is none where only the course was changed: that is told', async () => {
    const own = handedOut();
    const task = taskOf(own);
    if ('problem' in task) throw new Error(task.problem);
    const changed = { ...own, scene: sceneWith([targetAt(200, 450)], { name: 'Easy' }), handIn: said };
    const codes = (await remarksOf(changed, task.task)).map(({ code }) => code);
    expect(codes).toContain('course');
    expect(codes).not.toContain('other-task');
  });

  it('is counted, and one sentence says so in the report', async () => {
    const results = await Promise.all(
      ['Ada', 'Ben'].map(async (name) => ({ name, result: await checkedProject(open, handedOut()) })),
    );
    const own = { name: 'Cem', result: await checkedProject(open, open.project) };
    const found = classResult('t', [...results, own], 'de');
    expect(otherTasks(found)).toEqual([{ task: 'Into the garage', count: 2 }]);
    const [sentence = ''] = otherTaskTexts(found, 'de');
    expect(sentence).toContain('2 von 3 Abgaben gehören zu «Into the garage»');
    expect(htmlOf(found, open, 'de')).toContain(sentence);
  });
});
