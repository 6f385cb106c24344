// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h } from 'vue';

import { handInCode } from '#check/hand-in/hand-in-code';
import { handInOf } from '#check/hand-in/read-hand-in';
import { taskOf } from '#check/task/read-task';
import { projectOfTask, withoutSecrets } from '#check/task/write-task';
import { MAIN, type Project } from '#project/project';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { givenTask } from '../../pupil/locks/testing/given';
import TaskChecks from './TaskChecks.vue';

const START = 'forward()\n';
const BEGUN = 1_800_000_000_000;
const levels = [
  { name: 'leer', text: '' },
  { name: 'Lücken', text: START },
];
const given = (): Project => {
  const project = givenTask(START, {});
  return { ...project, task: { ...project.task, version: 1, exam: { minutes: 45 }, levels } };
};

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  vi.useFakeTimers({ toFake: ['Date', 'setInterval', 'clearInterval'], now: BEGUN });
});
afterEach(() => vi.useRealTimers());

async function opened(project = given()): Promise<TestPage> {
  const page = createPage();
  page.work.openProject(project, null);
  await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
  mountOn(page, defineComponent({ setup: () => () => h(TaskChecks, { project: page.work.work.value.project }) }));
  await flushPromises();
  return page;
}
const write = (page: TestPage, text: string): string | undefined => {
  page.work.setText(MAIN, text, true);
  return page.work.find(MAIN)?.text;
};
const after = async (minutes: number): Promise<void> => {
  vi.advanceTimersByTime(minutes * 60_000);
  await flushPromises();
};

describe('an exam on the page of a pupil', () => {
  it('begins by its button: before that nothing is written, then the time runs', async () => {
    const page = await opened();
    expect(textOf(byId('task-exam'))).toContain('Prüfung: 45 Minuten');
    expect(write(page, 'x = 1\n')).toBe(START);
    await tap('exam-begin');
    expect(write(page, 'x = 1\n')).toBe('x = 1\n');
    await after(15.5);
    expect(textOf(byId('exam-left'))).toBe('Noch 29:30');
  });

  it('is over when its time is: the program stays, its code is shown, and the hand-in opens', async () => {
    const page = await opened();
    await tap('exam-begin');
    write(page, 'mine()\n');
    await after(45);
    expect(write(page, 'late()\n')).toBe('mine()\n');
    expect(textOf(byId('exam-code'))).toBe(handInCode(page.work.work.value.project));
    expect([page.task.handIn.isOpen.value, isThere('task-levels')]).toEqual([true, false]);
  });

  it('goes on after a reload, and with another level, from the same begin', async () => {
    const page = await opened();
    await tap('exam-begin');
    await after(10);
    await tap('task-level-0');
    expect(textOf(byId('exam-left'))).toBe('Noch 35:00');
    const again = page.work.work.value.project;
    document.body.replaceChildren();
    await opened(again);
    expect(textOf(byId('exam-left'))).toBe('Noch 35:00');
  });

  it('closes pages that lie over the work while it runs', async () => {
    const page = await opened();
    page.router.open('missions');
    await flushPromises();
    expect(page.router.page.value?.name).toBe('missions');
    await tap('exam-begin');
    await vi.waitFor(() => expect(page.router.page.value).toBeNull());
  });
});

describe('an exam in its file', () => {
  const task = { version: 2, checks: [{ type: 'loop', id: 'l' }], exam: { minutes: 45 } };
  const card = { language: 'de', title: 'A', hints: ['Tipp'], translations: [], picture: '', solution: true };
  const { scene, files } = givenTask(START, {});
  const project: Project = { files, scene: { ...scene, task: { ...scene.task, card } }, course: 'slalom', task };

  it('is written and read, and handed out without hints and ready solutions', () => {
    const read = taskOf(project);
    if ('problem' in read) throw new Error(read.problem);
    expect(taskOf(projectOfTask(read.task))).toEqual(read);
    const forClass = withoutSecrets(project);
    expect([forClass.course, forClass.scene.task.card]).toEqual([null, { ...card, hints: [], solution: false }]);
    expect(withoutSecrets({ ...project, task: { ...task, exam: undefined } }).scene.task.card).toEqual(card);
    expect(taskOf({ ...project, task: { ...task, exam: { minutes: 0 } } })).toMatchObject({
      problem: 'task.exam.minutes: 0 is not within 1 … 480.',
    });
  });

  it('has a hand-in with the code that the pupil has shown, as long as nobody changes it', () => {
    const handedIn = { ...given(), handIn: { version: 1, begunMs: BEGUN, alias: 'Ada' } };
    const read = handInOf(handedIn);
    if ('problem' in read) throw new Error(read.problem);
    expect(handInCode(read.handIn.project)).toBe(handInCode(handedIn));
    expect(handInCode(handedIn)).toMatch(/^[A-HJ-NP-Z2-9]{6}$/);
    const main = (text: string): Project => ({ ...handedIn, files: [{ name: MAIN, text }] });
    expect(handInCode(main('forward()\r\n'))).toBe(handInCode(handedIn));
    expect(handInCode(main('forward() \n'))).not.toBe(handInCode(handedIn));
  });
});
