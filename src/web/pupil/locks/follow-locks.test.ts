// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { defaultScene } from '#scene/scene';
import { createPage } from '../../app/testing/page';
import { lostLocks } from './follow-locks';

const PROGRAM = 'import robot\n\ndef turn():\n    robot.left(90)\n';

/** The page of somebody who makes a task and has locked these lines. */
async function maker(lines: readonly number[]) {
  const page = createPage();
  const task = { version: 1, checks: [{ type: 'loop', id: 'loop' }], locks: { lines } };
  page.work.openProject(
    { files: [{ name: 'main.py', text: PROGRAM }], scene: defaultScene(), course: null, task },
    null,
  );
  await vi.dynamicImportSettled();
  const locked = (): unknown =>
    (page.work.work.value.project.task?.['locks'] as { lines?: unknown } | undefined)?.lines;
  const write = (text: string): void => page.work.setText('main.py', text, true);
  const said = (): unknown => page.notices.current.value?.values?.['text'];
  return { page, work: page.work, locked, write, said };
}
beforeEach(() => sessionStorage.clear());

describe('the start program of a task that is being made', () => {
  it('takes the locks of its lines along, and nothing of it is locked', async () => {
    const { work, locked, write } = await maker([3, 4]);
    expect(work.locks.task.value).toBeNull();
    write(`# a task\n${PROGRAM}`);
    expect(locked()).toEqual([4, 5]);
    write(`# a task\n${PROGRAM.replace('90', '45')}`);
    expect(locked()).toEqual([4, 5]);
  });

  it('says which lock has lost its line, until it is back', async () => {
    const { page, locked, write, said } = await maker([3, 4]);
    write(PROGRAM.replace('    robot.left(90)\n', ''));
    expect([locked(), lostLocks(page).value]).toEqual([[3], ['    robot.left(90)']]);
    expect(said()).toContain('robot.left(90)');
    write(PROGRAM);
    expect([locked(), lostLocks(page).value, said()]).toEqual([[3, 4], [], undefined]);
  });

  it('has no locks left when all lines are gone, and forgets what was lost with another task', async () => {
    const { page, work, locked, write } = await maker([3]);
    write('');
    expect([locked(), lostLocks(page).value]).toEqual([undefined, ['def turn():']]);
    work.openProject({ ...work.work.value.project, task: { version: 1, locks: { lines: [1] } } }, null);
    expect(lostLocks(page).value).toEqual([]);
    write(PROGRAM);
    expect(locked()).toEqual([5]);
  });
});
