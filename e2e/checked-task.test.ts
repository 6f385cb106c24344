import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { violationsOn } from './axe';
import { openedCourse } from './opened-course';
import { on, openWork, pasteProgram } from './page';
import { by, until } from './parts';

/** A target ahead of the robot, in a task that asks for a loop, too, and gives a point more for a heart. */
function task(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: { scene: { objects: object[] } } };
  const { scene } = work.project;
  scene.objects.push({ type: 'target', id: 't', at: [900, 450], size: [200, 200] });
  const checks = [
    { type: 'goals', id: 'goals' },
    { type: 'loop', id: 'loop' },
    { type: 'display', id: 'heart', image: '09090:99999:99999:09990:00900', needed: false },
  ];
  const data = { version: 1, handedOut: true, checks };
  return JSON.stringify({ ...work, project: { ...work.project, scene, course: null, task: data } });
}
const drive = (first: string): string => `from mbrobot import *
${first}
forward()
delay(3000)
stop()
`;

test(
  'a pupil reaches the goal, is told what else is asked for, and is praised when all holds',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openWork(app, task());
    await until(app, by('verdict'));
    await pasteProgram(app, drive('setSpeed(50)'));
    await app.click(on('run'));
    await until(app, '[data-testid="verdict"][data-state="lacking"]');
    expect(await app.text(by('verdict'))).toMatch(/has no loop|keine Schleife/);
    await until(app, by('task-checks'));
    expect(await app.text(by('task-checks'))).toMatch(/missing|fehlt/);
    await expect.poll(() => violationsOn(app)).toEqual([]); // the buttons of the run fade when it ends
    await app.click(by('task-close'));
    await pasteProgram(app, drive('for i in range(2):\n    setSpeed(50)'));
    await app.click(on('run'));
    await until(app, '[data-testid="verdict"][data-state="passed"]');
    expect(await app.text(by('verdict'))).toMatch(/2 (of|von) 3/);
  },
);
