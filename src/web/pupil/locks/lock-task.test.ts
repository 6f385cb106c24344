// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';
import { handInOf } from '#check/hand-in/read-hand-in';
import { projectOf } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { noLocks } from '#check/task/task';
import { withoutSecrets } from '#check/task/write-task';
import { defaultScene } from '#scene/scene';
import type { SceneEdit } from '#scene/edit';
import { addedDevice } from '#project/devices';
import type { Project } from '#project/project';
import { createPage, type TestPage } from '../../app/testing/page';
import { inputsOf, show, startRun } from '../../app/testing/run';
import { appSimulator } from '../../exchange/host/app-simulator';
import { useTaskMaker } from '../../teacher/task-maker/use-task-maker';
import { useDevice } from '../../session/work/hardware/use-device';
import { clearAll } from '../../course/editor/state/clear-all';
import { useSelectionActs } from '../../course/editor/state/use-selection-acts';
import type { BoardProgram } from '../../session/work/catalogue/board-programs';
import { useCourses } from '../../session/work/use-courses';
import { knownCourses } from '../../session/work/catalogue/known-courses';
import { BLOCK, givenTask } from './testing/given';

const PROGRAM = 'import robot\n\ndef turn():\n    robot.left(90)\n\n# mine\n';
const given = (locks: object): Project => givenTask(PROGRAM, locks);

/** A pupil's page on which it is open. */
async function pupil(
  locks: object,
  change: (project: Project) => Project = (project) => project,
): Promise<TestPage & { readonly said: () => string | undefined }> {
  const page = createPage();
  page.work.openProject(change(given(locks)), null);
  await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
  page.mode.enter('build');
  const said = (): string | undefined => page.notices.current.value?.values?.['text'] as string | undefined;
  return { ...page, said };
}
const program = ({ work }: TestPage): string | undefined => work.files.value[0]?.text;
const linesOf = ({ work }: TestPage): unknown => (work.work.value.project.task?.['locks'] as { lines?: unknown }).lines;

beforeAll(() => import('./lock-task')); // its first coming takes a while on a busy machine
beforeEach(() => {
  sessionStorage.clear();
  localStorage.clear();
});

describe('a task with a locked course', () => {
  it('is not changed by tools, undo or a host, and says so; nothing is built', async () => {
    const page = await pupil({ course: true });
    const { scene } = page.work;
    const before = scene.value;
    expect(page.editor.commit(BLOCK)).toBe(false);
    expect(appSimulator(page).edit(BLOCK)).toMatch(/keeps this as it is/);
    page.editor.choose('pen');
    expect([scene.value === before, page.editor.tool.value]).toEqual([true, 'hand']);
    expect(page.said()).toMatch(/course|Parcours/);
    expect(page.mode.offered.value).toEqual(['drive']);
  });

  it('opens no window in which it would be built: not for a picture that is dropped, nor for the list; printing goes', async () => {
    const page = await pupil({ course: true });
    expect(page.panels.offer(new Blob())).toBe(true);
    expect([page.panels.shown.value, page.panels.picture.value, page.said()]).toEqual([
      null,
      null,
      expect.stringMatching(/course|Parcours/),
    ]);
    page.panels.open('list');
    expect(page.panels.shown.value).toBeNull();
    page.panels.open('print');
    expect(page.panels.shown.value).toBe('print');
  });

  it('puts the tool away that was in the hand when it was opened', async () => {
    const page = createPage();
    page.mode.enter('build');
    page.editor.choose('eraser');
    page.work.openProject(given({ course: true }), null);
    await vi.waitFor(() => expect(page.editor.tool.value).toBe('hand'));
  });
});

describe('a task that leaves the pen alone', () => {
  const LINE = {
    type: 'add',
    objects: [{ type: 'stroke', id: 's', points: [[0, 0], [100, 100]], width: 10, color: 'black' }], // prettier-ignore
  } as const satisfies SceneEdit;
  it('has no eraser, and what is drawn can be taken back', async () => {
    const page = await pupil({ tools: ['pen'] });
    page.editor.choose('pen');
    page.editor.choose('eraser');
    expect([page.editor.tool.value, page.editor.commit(LINE)]).toEqual(['pen', true]);
    page.editor.undo();
    expect(page.work.scene.value.objects).toEqual([]);
  });

  it('has no other way to build, erase or move: keys, lists, menus and hosts go by the tools', async () => {
    const page = await pupil({ tools: ['pen'] });
    page.editor.commit(LINE);
    page.editor.select({ ids: ['s'], robot: true });
    useSelectionActs(page).remove();
    useSelectionActs(page).turn(1);
    expect(page.editor.commit(clearAll(false))).toBe(false);
    expect(page.editor.commit({ type: 'course', changes: { size: [500, 500] } })).toBe(false);
    expect(appSimulator(page).edit(BLOCK)).toMatch(/keeps this/);
    expect(page.work.scene.value).toEqual({ ...defaultScene(), objects: LINE.objects });
    expect(page.said()).toMatch(/tool|Werkzeug/);
  });
});

it('a task that locks the hand keeps robot, blocks, sensors, lamps and barriers from it, by whatever way', async () => {
  const page = createPage();
  page.sensors.set('lightLevel', 3);
  page.hand.pose.value = { xMm: 1, yMm: 2, headingDeg: 0 };
  page.work.openProject(given({ hand: true }), null);
  await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
  expect([page.sensors.wishes.value, page.hand.pose.value]).toEqual([{}, null]);
  await startRun(page);
  await show(page);
  const host = appSimulator(page);
  page.sensors.set('lightLevel', 7);
  page.sensors.gesture('shake');
  page.run.input({ type: 'place', pose: { xMm: 1, yMm: 2, headingDeg: 0 } });
  page.run.input({ type: 'switch', id: 'lamp-1', on: true });
  expect(host.input({ type: 'sensor', id: 'lightLevel', value: 9 })).toMatch(/without the hand/);
  page.run.input({ type: 'button', button: 'a', down: true });
  expect(inputsOf(page)).toEqual([{ type: 'button', button: 'a', down: true }]);
  expect(page.sensors.wishes.value).toEqual({});
});

it('a task that locks the speed runs at 1×, and gives the pupil’s own back afterwards', async () => {
  const page = createPage();
  const speed = (): unknown => page.settings.current.value.speed;
  page.settings.change({ speed: 4 });
  page.work.openProject(given({ speed: true }), null);
  await vi.waitFor(() => expect(speed()).toBe(1));
  page.settings.change({ speed: 'max' });
  expect(appSimulator(page).change({ speed: 8 })).toMatch(/keeps this/);
  expect(speed()).toBe(1);
  page.work.openProject({ ...given({}), task: { version: 1 } }, null);
  expect(speed()).toBe(4);
});

it('a task that locks the robot keeps it and the board, but not the look of the page', async () => {
  const page = await pupil({ robot: true });
  const before = page.settings.current.value;
  const device = useDevice(page);
  device.chooseRobot('callibot');
  device.chooseDevice('calliope-mini-3');
  device.chooseReality(1);
  expect(appSimulator(page).change({ robot: 'callibot' })).toMatch(/keeps this/);
  expect(page.settings.current.value).toEqual(before);
  page.settings.change({ theme: 'dark' });
  expect(page.settings.current.value.theme).toBe('dark');
  page.work.addDevice({ name: 'B', files: [], sameAs: '', device: 'auto', firmware: '', robot: 'auto', robotOptions: {} }, 'A'); // prettier-ignore
  expect(page.work.hasSeveral.value).toBe(false);
});

it('a task that locks the robot keeps its further devices, and puts no work aside for them', async () => {
  const second = {
    name: 'B',
    files: [],
    sameAs: '',
    device: 'auto',
    firmware: '',
    robot: 'auto',
    robotOptions: {},
  } as const;
  const page = await pupil({ robot: true }, (project) => addedDevice(project, second, 'A'));
  const before = page.work.work.value;
  expect(page.work.removeDevice(1, 'before')).toBe(false);
  expect(page.work.work.value).toEqual(before);
  expect(page.said()).toBeDefined();
});

it.each([0.5, 4, 'max'] as const)(
  'a task that locks the speed at %s runs at that, whatever else is wished',
  async (kept) => {
    const page = await pupil({ speed: kept });
    const speed = (): unknown => page.settings.current.value.speed;
    expect(speed()).toBe(kept);
    page.settings.change({ speed: 1 });
    page.settings.hold({ speed: 2 }); // what an address wishes
    expect(speed()).toBe(kept);
  },
);

describe('a task with locked lines', () => {
  it('lets the pupil write around them, and knows after a reload where they are', async () => {
    const page = await pupil({ lines: [3, 4] });
    page.work.setText('main.py', `# Anna\n${PROGRAM}`, true);
    expect(linesOf(page)).toEqual([4, 5]);
    page.work.setText('main.py', `# Anna\n${PROGRAM}turn()\n`, true);
    expect([program(page), linesOf(page)]).toEqual([`# Anna\n${PROGRAM}turn()\n`, [4, 5]]);
  });

  it('takes no program that lacks them: not typed, not from a file, not from a host', async () => {
    const page = await pupil({ lines: [3, 4] });
    const other = PROGRAM.replace('left', 'right');
    page.work.setText('main.py', other, true);
    page.work.replace({ name: 'main.py', text: other }, 'old');
    expect(appSimulator(page).setFiles([{ name: 'main.py', text: other }])).toMatch(/keeps this/);
    expect([program(page), linesOf(page)]).toEqual([PROGRAM, [3, 4]]);
    expect(page.said()).toMatch(/lines|Zeilen/);
    expect(appSimulator(page).setFiles([{ name: 'main.py', text: `${PROGRAM}turn()` }])).toBeNull();
    expect(program(page)).toBe(`${PROGRAM}turn()`);
  });
});

it('a task that was handed out is not made over: it stays as it is until somebody begins anew, which is put aside', async () => {
  const page = await pupil({ hand: true });
  const made = useTaskMaker(page);
  const { task } = page.work.work.value.project;
  made.change({ locks: noLocks });
  expect([page.work.work.value.project.task, made.isGiven.value]).toEqual([task, true]);
  expect(page.said()).toMatch(/handed out|ausgeteilt/);
  made.clear();
  expect([page.work.work.value.project.task, made.isGiven.value]).toEqual([undefined, false]);
  expect(page.work.work.value.previous[0]?.project.task).toEqual(task);
});

describe('what is not the task', () => {
  it('is free: the teacher’s own copy of it, and what is opened after it', async () => {
    const page = await pupil({ course: true });
    page.work.openProject({ ...given({}), task: { version: 1, locks: { course: true } } }, null);
    page.mode.enter('build');
    expect(page.editor.commit(BLOCK)).toBe(true);
  });

  it('is a program for the microcomputer alone, which chooses its own', async () => {
    const page = await pupil({ robot: true });
    page.settings.bring({ device: 'calliope-mini-3' });
    const program = { title: {}, source: {}, board: 'microbit-v2' } as unknown as BoardProgram;
    useCourses(page).openBoardProgram(program);
    const { device, robot } = page.settings.current.value;
    expect([device, robot, page.said()]).toEqual(['auto', 'none', undefined]);
  });

  it('is a course from the gallery, into which the program is taken along', async () => {
    const page = await pupil({ course: true });
    const course = knownCourses.value?.[0];
    if (course !== undefined) useCourses(page).openScene(course);
    else page.work.setScene({ ...defaultScene(), name: 'Other' }, null);
    expect([page.work.locks.task.value, page.work.work.value.project.task]).toEqual([null, undefined]);
    page.mode.enter('build');
    expect(page.editor.commit(BLOCK)).toBe(true);
  });
});

describe('a task that is left before anything was written', () => {
  const ready = courses.find(({ id }) => id === 'square')!;
  const sample = { title: {}, source: {}, board: 'microbit-v2' } as unknown as BoardProgram;
  it.each([
    ['a sample for the microcomputer', (page: TestPage) => useCourses(page).openBoardProgram(sample)],
    ['a course', (page: TestPage) => useCourses(page).openWhole(ready)],
    ['the arena of a course', (page: TestPage) => useCourses(page).openScene(ready)],
  ])('can be taken back from %s: by the message, and among the earlier works', async (_, leave) => {
    const page = createPage();
    const lent = { ...projectOf(ready, 'de'), task: { version: 1, handedOut: true } };
    page.work.openProject(lent, null);
    await nextTick();
    leave(page);
    expect(page.work.work.value.project.task).toBeUndefined();
    expect(page.work.work.value.previous[0]?.project.task).toEqual(lent.task);
    expect(page.notices.current.value?.action?.key).toBe('course.restore');
    page.notices.current.value?.action?.run();
    expect(page.work.work.value.project.task).toEqual(lent.task);
  });
});

describe('what is told of a hand-in', () => {
  const told = (page: TestPage): unknown => page.work.locks.noticed();

  it('is nothing, if the program was typed here and the run left to itself', async () => {
    const page = await pupil({});
    page.work.setText('main.py', `${PROGRAM}turn()\n`, true);
    page.work.create('more.py');
    page.work.rename('more.py', 'most.py');
    await startRun(page);
    await show(page);
    expect(told(page)).toEqual([]);
  });

  it.each<[string, (page: TestPage) => void]>([
    ['a file that takes its place', ({ work }) => work.replace({ name: 'main.py', text: 'forward()' }, 'old')],
    ['a file beside it', ({ work }) => void work.takeIn({ name: 'more.py', text: 'forward()' })],
    ['a host', (page) => void appSimulator(page).setFiles([{ name: 'main.py', text: 'forward()' }])],
  ])('is that the program came from elsewhere: from %s; also after it was typed on', async (_, bring) => {
    const page = await pupil({});
    bring(page);
    page.work.setText('main.py', 'forward() # mine', true);
    expect(told(page)).toEqual(['outside']);
    const kept = page.work.work.value.project;
    expect(handInOf(kept)).toMatchObject({ handIn: { said: { remarks: ['outside'] } } });
  });

  it('is another course than the one handed out, also after a reload, and not when it is as it was', async () => {
    const page = await pupil({});
    expect(told(page)).toEqual([]);
    page.editor.commit(BLOCK);
    expect(told(page)).toEqual(['course']);
    const again = createPage();
    again.work.openProject(page.work.work.value.project, null);
    await vi.waitFor(() => expect(told(again)).toEqual(['course']));
    expect(withoutSecrets(page.work.work.value.project).task).toEqual(page.work.work.value.project.task);
    page.editor.undo();
    expect(told(page)).toEqual([]);
  });

  it('is no other course where a task came without knowing its own, as they did before', async () => {
    const page = createPage();
    const { task: { course: _, ...task } = { version: 1 }, ...project } = given({});
    page.work.openProject({ ...project, task }, null);
    await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
    page.editor.commit(BLOCK);
    expect(told(page)).toEqual([]);
    expect(withoutSecrets(page.work.work.value.project).task).toEqual(task);
  });

  it('is the hand in the last run, but not in those before it', async () => {
    const page = await pupil({});
    page.run.input({ type: 'button', button: 'a', down: true });
    await startRun(page);
    await show(page);
    expect(told(page)).toEqual([]);
    page.run.input({ type: 'button', button: 'a', down: true });
    expect(told(page)).toEqual(['hand']);
    await page.run.reset();
    expect(told(page)).toEqual(['hand']);
    await startRun(page);
    expect(told(page)).toEqual([]);
  });

  it('is a sensor that was set before the run began', async () => {
    const page = await pupil({});
    page.sensors.set('lightLevel', 3);
    await startRun(page);
    expect(told(page)).toEqual(['hand']);
  });

  it('is a lamp or a barrier that was switched', async () => {
    const page = await pupil({});
    await startRun(page);
    page.run.input({ type: 'switch', id: 'lamp-1', on: true });
    expect(told(page)).toEqual(['hand']);
  });

  it('is not what the task itself does in its visible world', async () => {
    const page = createPage();
    const inputs = [{ timeUs: 500_000, action: { type: 'button', button: 'a', down: true } }];
    const project = given({});
    const worlds = [{ id: 'visible', hidden: false, inputs, sensors: { lightLevel: 9 } }];
    page.work.openProject({ ...project, task: { ...project.task, worlds } }, null);
    await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
    await startRun(page);
    page.run.input({ type: 'button', button: 'a', down: true });
    page.sensors.set('lightLevel', 9);
    expect(told(page)).toEqual([]);
    page.run.input({ type: 'button', button: 'b', down: true });
    expect(told(page)).toEqual(['hand']);
  });
});
