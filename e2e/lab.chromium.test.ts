import { expect, test } from './app';
import { openedCourse } from './opened-course';
import { isThere, on, openWork, pasteProgram, programIn } from './page';
import { by, gone, until } from './parts';

/** A target ahead of the robot, which only some times reach. */
function task(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: { scene: { objects: object[] } } };
  const { scene } = work.project;
  scene.objects.push({ type: 'target', id: 't', at: [900, 450], size: [200, 200] });
  return JSON.stringify({ ...work, project: { ...work.project, scene, course: null } });
}
const drive = (ms: number): string => `from mbrobot import *
forward()
delay(${ms})
stop()`;

test('a number is tuned by the curve, and taken into the program, where it can be undone', async ({ app }) => {
  await openWork(app, task());
  await until(app, on('editor'));
  await pasteProgram(app, drive(1000));
  for (const key of ['ArrowUp', 'End', 'ArrowLeft']) await app.press(key);
  // The help of the editor, of which it is a part, comes with its first use.
  await expect
    .poll(async () => {
      await app.press('Alt', 'Enter');
      return isThere(app, by('try-card'));
    })
    .toBe(true);
  await app.type('500');
  for (const text of ['4500', '1000']) {
    await app.press('Tab');
    await app.press('Control', 'a');
    await app.type(text);
  }
  await app.click(by('lab-go'));
  await until(app, by('lab-again'));
  expect(await app.text(by('lab-result'))).toMatch(/^[1-4] /);
  await app.click(by('lab-curve'));
  await app.press('End');
  await expect.poll(() => app.text(by('lab-chosen'))).toContain('4500');
  await app.click(by('lab-take'));
  await gone(app, by('lab-curve'));
  await expect.poll(() => programIn(app)).toBe(drive(4500));
  await app.press('Control', 'z');
  await expect.poll(() => programIn(app)).toBe(drive(1000));
});
