import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { openedCourse } from './opened-course';
import { on, openWork, pasteProgram } from './page';
import { by, until } from './parts';

/** A target ahead of the robot, in a task whose hints tell the lines at most. */
function task(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: { scene: { objects: object[] } } };
  const { scene } = work.project;
  scene.objects.push({ type: 'target', id: 't', at: [900, 450], size: [200, 200] });
  const data = { version: 2, handedOut: true, hint: 'lines' };
  return JSON.stringify({ ...work, project: { ...work.project, scene, course: null, task: data } });
}
const DRIVE = 'from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(500)\nstop()\n';

test(
  'a pupil who twice did not get there is told the moment, then the lines, and no more',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openWork(app, task());
    await until(app, by('verdict'));
    await pasteProgram(app, DRIVE);
    for (let runs = 0; runs < 2; runs += 1) {
      await app.click(on('run'));
      await until(app, '[data-testid="next-step"][data-step="notYet"]');
    }
    await app.click(by('step-own-hint'));
    await until(app, by('own-hint-still'));
    await until(app, by('hint-ring'));
    expect(await app.text(by('own-hint-text'))).toMatch(/program was over|Programm zu Ende/);
    // A second press within a second does nothing.
    await new Promise((later) => setTimeout(later, 1200));
    await app.click(by('step-own-hint'));
    await until(app, '[data-testid="own-hint"][data-phase="told"] p + [data-testid="own-hint-text"]');
    expect(await app.text(by('own-hint'))).toMatch(/line 4|Zeile 4/);
    await until(app, '.cm-changedLine');
    expect(await app.evaluate(() => document.querySelector('[data-testid="step-own-hint"]') === null)).toBe(true);
    await pasteProgram(app, DRIVE.replace('500', '600'));
    await expect.poll(() => app.evaluate(() => document.querySelector('[data-testid="own-hint"]') === null)).toBe(true);
  },
);
