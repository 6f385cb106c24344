// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { defaultProjectSettings, type Project } from '#project/project';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { isThere } from '../../app/testing/find';
import { mountOn } from '../../app/testing/mount-on';
import { mispluggedNotice } from '../../session/work/hardware/misplugged';
import MispluggedBar from '../../session/work/hardware/MispluggedBar.vue';
import { fittedNow } from '../../session/work/hardware/use-hardware';
import { useOpenings } from '../../session/work/use-openings';
import { BLOCK, givenTask } from './testing/given';

const PROGRAM = 'import robot\n\ndef turn():\n    robot.left(90)\n';
const given = (locks: object): Project =>
  givenTask(PROGRAM, locks, { ...defaultProjectSettings, robot: 'maqueen-lite', reality: 0.5 });

/** A page on which a task was opened, and something is done before what keeps it has come. */
async function hasty(locks: object, act: (page: TestPage) => unknown) {
  const page = createPage();
  useOpenings(page).open(given(locks), 'Task', true);
  expect(page.work.locks.task.value).toBeNull();
  page.mode.enter('build');
  await act(page);
  await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
  return { ...page, said: () => page.notices.current.value?.values?.['text'] };
}
beforeAll(() => import('./lock-task')); // its first coming takes a while on a busy machine
beforeEach(() => {
  sessionStorage.clear();
  localStorage.clear();
});

describe('what is done between the opening of a task and the coming of what keeps it', () => {
  it('is undone in a locked course, and said; a free one keeps it', async () => {
    const twice = (page: TestPage) => {
      page.editor.commit(BLOCK);
      page.editor.commit({ type: 'remove', ids: ['b'] });
      page.editor.commit(BLOCK);
    };
    const locked = await hasty({ course: true }, twice);
    expect(locked.work.scene.value.objects).toEqual([]);
    expect(locked.said()).toMatch(/course|Parcours/);
    expect((await hasty({}, twice)).work.scene.value.objects).toHaveLength(1);
  });

  it('moves the locks of lines along, and a line that is gone comes back', async () => {
    const moved = await hasty({ lines: [3] }, ({ work }) => work.setText('main.py', `# Anna\n${PROGRAM}`, true));
    expect(moved.work.locks.task.value?.locks.lines).toEqual([4]);
    const gone = await hasty({ lines: [3] }, ({ work }) => work.setText('main.py', 'forward()\n', true));
    expect(gone.work.files.value[0]?.text).toBe(PROGRAM);
    expect(gone.said()).toMatch(/lines|Zeilen/);
  });

  it('is told of a hand-in: a run that began with the hand', async () => {
    const page = await hasty({}, async (early) => {
      early.sensors.set('lightLevel', 3);
      await startRun(early);
    });
    expect(page.work.locks.noticed()).toEqual(['hand']);
  });
});

describe('a task that locks the robot', () => {
  it('holds the one it came with against an address, another tab and what was chosen in between', async () => {
    const page = await hasty({ robot: true }, ({ settings }) => settings.change({ robot: 'callibot', reality: 0 }));
    const now = (): unknown => [page.settings.current.value.robot, page.settings.current.value.reality];
    expect(now()).toEqual(['maqueen-lite', 0.5]);
    page.settings.hold({ robot: 'callibot' });
    expect(now()).toEqual(['maqueen-lite', 0.5]);
  });

  it('can be followed by another one, each with its own', async () => {
    const page = await hasty({ robot: true }, () => undefined);
    const next = given({ robot: true });
    useOpenings(page).open({ ...next, settings: { ...defaultProjectSettings, robot: 'callibot' } }, 'Next', true);
    expect(page.settings.current.value.robot).toBe('callibot');
    useOpenings(page).open({ ...next, settings: { ...defaultProjectSettings, robot: 'maqueen-lite' } }, 'Next', true);
    expect(page.settings.current.value.robot).toBe('maqueen-lite');
  });
});

it('a task that locks the hand holds whether sensors feel the arena', async () => {
  const page = await hasty({ hand: true }, ({ settings }) =>
    settings.change({ arenaSenses: !defaultProjectSettings.arenaSenses }),
  );
  expect(page.settings.current.value.arenaSenses).toBe(defaultProjectSettings.arenaSenses);
});

describe('a message that offers what is locked', () => {
  const POSE = { xMm: 1, yMm: 2, headingDeg: 0 };
  it('offers no other start where the course is locked', async () => {
    const page = await hasty({ course: true }, () => undefined);
    page.hand.pose.value = POSE;
    await vi.waitFor(() => expect(page.notices.current.value).toMatchObject({ key: 'notice.handRobot' }));
    expect(page.notices.current.value?.action).toBeUndefined();
  });

  it('names no tool that is not there', async () => {
    const page = await hasty({ tools: ['pen'] }, () => undefined);
    page.hand.blocks.value = { b: POSE };
    await vi.waitFor(() => expect(page.said()).toMatch(/next start|Start/));
    expect(page.said()).not.toMatch(/Select|Auswählen/);
    page.hand.reset();
    await vi.waitFor(() => expect(page.notices.current.value).toBeNull());
  });

  it('offers no other robot where the robot is locked', async () => {
    const page = await hasty({ robot: true }, () => undefined);
    page.work.setText('main.py', 'from callibot import *\n');
    const notice = mispluggedNotice(fittedNow(page), () => undefined)!;
    expect(notice.key).toBe('arena.otherRobotKept');
    const bar = mountOn(page, MispluggedBar, { notice });
    expect([bar.text() !== '', isThere('plug-in')]).toEqual([true, false]);
  });

  it('stays as it is where nothing of that is locked', async () => {
    const page = await hasty({ hand: false }, () => undefined);
    page.hand.pose.value = POSE;
    await vi.waitFor(() => expect(page.notices.current.value?.action).toBeDefined());
  });
});
