import { describe, expect, it } from 'vitest';
import { linkOf, projectOfLink } from '#project/link/link';
import { parseProject, projectToText } from '#project/file';
import type { Project } from '#project/project';
import { handInOf } from '../hand-in/read-hand-in';
import type { WorldResult } from '../result';
import { setupOf } from '../run/setup';
import { ahead, checkedProject, projectWith, sceneWith, targetAt } from '../testing/tasks';
import { taskOf } from '../task/read-task';
import type { ClassTask } from '../task/task';
import { withoutSecrets } from '../task/write-task';
import { feedbackLimits, isAtMoment, readFeedback, type Feedback } from './feedback';
import { hasFeedback } from './has-feedback';
import { feedbackProject, momentOf, runOfFeedback } from './feedback-project';

const goal = sceneWith([targetAt(600, 450)], { name: 'Two starts', task: { seconds: 4, noTouch: false } });
const pressA = { timeUs: 500_000, action: { type: 'button', button: 'a', down: true } };
const task = taskIn({
  ...projectWith(goal, '# start\n'),
  task: {
    version: 1,
    id: 'starts',
    checks: [{ type: 'goals', points: 3 }, { type: 'loop' }],
    worlds: [
      { id: 'visible', hidden: false },
      { id: '2', start: { at: [200, 200], heading: 0 }, seed: 7, reality: 0.5, inputs: [pressA] },
    ],
    solution: [{ name: 'main.py', text: ahead(1000) }],
    locks: { lines: [1] },
  },
});

function taskIn(project: Project): ClassTask {
  const read = taskOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return read.task;
}

/** A pupil's program that reaches the target from the first start alone, with what the check finds. */
async function marked() {
  const read = handInOf({ ...projectWith(goal, `# Ada\n# start\n${ahead(1700)}`) });
  if ('problem' in read) throw new Error(read.problem);
  const { handIn } = read;
  const result = await checkedProject(task, handIn.project);
  return { task, handIn, result, points: 2.5, note: 'Fast! <b>Look</b> "there"\nat 3 s.' };
}

async function givenBack(place: number): Promise<Project> {
  const given = await marked();
  const project = feedbackProject(given, given.result.worlds[place]!);
  if (project === null) throw new Error('no project');
  return project;
}

const throughLink = (project: Project): unknown => {
  const link = linkOf(project, { courses: () => null, program: true });
  return link && projectOfLink(`#${link.fragment}`, () => null);
};

const said = async (place: number): Promise<Feedback> => readFeedback(await givenBack(place)) as Feedback;

describe('a feedback', () => {
  it('comes back from a link and from a file as it was written', async () => {
    const project = await givenBack(0);
    expect(await said(0)).toMatchObject({ note: 'Fast! <b>Look</b> "there"\nat 3 s.', points: [2.5, 4] });
    expect(throughLink(project)).toEqual({ project, isCourseChanged: false });
    expect(parseProject(projectToText(project))).toEqual({ project });
  });

  it('brings the own program into the task as it was handed out: no solution, no hidden world', async () => {
    const { files, task: data } = await givenBack(0);
    expect(files[0]?.text).toContain('# Ada');
    expect(data).toMatchObject({ id: 'starts', handedOut: true, locks: { lines: [2] } });
    expect(JSON.stringify(data)).not.toMatch(/solution|worlds/);
  });

  it('says of each world whether it went wrong there, and which checks do not hold', async () => {
    expect(await said(0)).toMatchObject({ world: 'visible', failed: false, missed: ['goals', 'loop'] });
    expect(await said(1)).toMatchObject({ world: '2', failed: true });
  });

  it('about a hidden world is in its course, and that is still the task when it is handed in again', async () => {
    const project = await givenBack(1);
    expect(project.scene.robot.at).toEqual([200, 200]);
    expect(project.settings).toMatchObject({ seed: 7, reality: 0.5 });
    const again = { ...project, handIn: { version: 1, alias: 'Ada' } };
    const codes = (await checkedProject(task, again)).remarks.map(({ code }) => code);
    expect(codes).not.toContain('course');
    expect(codes).not.toContain('other-task');
  });

  it('is about the very run that was checked', async () => {
    const { handIn, result } = await marked();
    for (const [place, world] of task.worlds.entries()) {
      const run = runOfFeedback(await givenBack(place))!;
      expect(run.setup).toEqual(setupOf(task, handIn.project, world));
      expect(run.atUs).toBe(momentOf(result.worlds[place]!)! * 1000);
    }
  });

  it('goes when the work is handed on, and the rest stays', async () => {
    const project = await givenBack(0);
    expect(hasFeedback(project)).toBe(true);
    expect(withoutSecrets(project).handIn).toBeUndefined();
    const outside = { ...project, handIn: { ...project.handIn, remarks: ['outside'] } };
    expect(withoutSecrets(outside).handIn).toEqual({ version: 1, remarks: ['outside'] });
  });

  it('that is too long, damaged or of a newer version is known as such', async () => {
    const project = await givenBack(0);
    const changed = (change: object): unknown =>
      readFeedback({
        handIn: { ...project.handIn, feedback: { ...(project.handIn!['feedback'] as object), ...change } },
      });
    expect(changed({ note: 'x'.repeat(feedbackLimits.noteCharacters) })).toMatchObject({ world: 'visible' });
    expect(changed({ note: 'x'.repeat(feedbackLimits.noteCharacters + 1) })).toBe('damaged');
    expect(changed({ atMs: -1 })).toBe('damaged');
    expect(changed({ html: '<p>' })).toBe('damaged');
    expect(changed({ version: 2 })).toBe('newer');
    expect(readFeedback({ handIn: { feedback: 'Fast!' } })).toBe('damaged');
    expect(readFeedback(projectWith(goal))).toBeNull();
  });
});

describe('the moment of a feedback', () => {
  const world = (change: Partial<WorldResult>): WorldResult =>
    ({
      atMs: null,
      reason: { code: 'open', params: {} },
      trailMs: [
        [0, 20],
        [40, 2500.4],
      ],
      ...change,
    }) as WorldResult;

  it('is when it was decided, else when the robot moved last, but of an error the end of the program', () => {
    expect(momentOf(world({ atMs: 3210.4 }))).toBe(3210);
    expect(momentOf(world({}))).toBe(2500);
    expect(momentOf(world({ trailMs: [] }))).toBeNull();
    expect(momentOf(world({ reason: { code: 'exception', params: {} } }))).toBeNull();
  });

  it('is looked at as long as no other one is: moments are some ms apart', () => {
    const feedback = { atMs: 3200 } as Feedback;
    expect(isAtMoment(feedback, 3_190_000, 9_000_000)).toBe(true);
    expect(isAtMoment(feedback, 2_000_000, 9_000_000)).toBe(false);
    expect(isAtMoment({ ...feedback, atMs: null }, 9_000_000, 9_000_000)).toBe(true);
  });
});
