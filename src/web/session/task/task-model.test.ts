// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import type { RobotSnapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';
import { defaultScene, sceneDefaults, type Scene } from '#scene/scene';

import { setWindow } from '../../app/testing/mount-on';
import { samples } from '../../app/testing/editing';
import { createPage, type TestPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { loadTexts, showLanguage } from '../../kit/i18n';
import { courses } from '#catalogue/courses';
import { ladderOf } from '#catalogue/missions';
import { readyCourse } from '../work/catalogue/ready-courses';
import { useCourses } from '../work/use-courses';

beforeAll(() => loadTexts('de'));
beforeEach(() => localStorage.clear());

const told = (description: string): Scene => ({ ...defaultScene(), description });

async function open(page: TestPage, scene: Scene): Promise<void> {
  page.work.setScene(scene, null);
  await nextTick();
}

describe('the card of the task', () => {
  it('opens with a course that has a text, and with no other', async () => {
    const page = createPage();
    expect(page.task.card.value).toBe('open'); // the first mission
    await open(page, told('Fahr ins Ziel.'));
    expect([page.task.hasText.value, page.task.isOpen.value]).toEqual([true, true]);
    await open(page, told(''));
    expect([page.task.hasText.value, page.task.isOpen.value]).toEqual([false, false]);
  });

  it('opens with a ready course, in the language of the page', async () => {
    const page = createPage();
    const slalom = courses.find(({ id }) => id === 'slalom')!;
    useCourses(page).openWhole(slalom);
    await nextTick();
    expect(page.task.isOpen.value).toBe(true);
    expect(page.task.text.value).toMatchObject({ title: slalom.texts.de.name, text: slalom.texts.de.task });
    await loadTexts('fr');
    showLanguage('fr');
    expect(page.task.text.value.text).toBe(slalom.texts.fr.task);
    showLanguage('de');
  });

  it('is its title line in a very low window until it is asked for, with the course in front', async () => {
    setWindow(683, 312);
    const page = createPage();
    useCourses(page).openWhole(ladderOf('maqueen-lite')[1]!);
    await nextTick();
    expect([page.task.card.value, page.layout.tab.value]).toEqual(['folded', 'arena']);
    page.task.open();
    expect(page.task.card.value).toBe('open');
    page.task.close();
    expect([page.task.card.value, page.settings.current.value.showCard]).toEqual(['folded', true]);
    setWindow(1024, 768);
  });

  it('opens with an address, be it that of the course that is open', async () => {
    const page = createPage();
    page.work.arrivals.value += 1;
    await nextTick();
    expect(page.task.isOpen.value).toBe(true);
  });

  it('stays while the robot drives, and folded while the course is edited', async () => {
    const page = createPage();
    await open(page, told('Fahr ins Ziel.'));
    await startRun(page);
    expect(page.task.card.value).toBe('open');
    page.task.close();
    page.editor.commit({ type: 'course', changes: { description: 'Fahr weiter.' } });
    await nextTick();
    expect(page.task.card.value).toBe('folded');
  });

  it('is there on request alone where a ready course has no goals', async () => {
    const page = createPage();
    useCourses(page).openWhole(readyCourse('empty')!);
    await nextTick();
    expect([page.task.hasText.value, page.task.card.value]).toEqual([true, null]);
    page.task.open();
    expect(page.task.card.value).toBe('open');
    page.task.close();
    expect(page.task.card.value).toBeNull();
  });

  it('has no words of the empty floor for a course that was drawn on it', async () => {
    const page = createPage();
    useCourses(page).openWhole(readyCourse('empty')!);
    await nextTick();
    expect(page.task.text.value.text).not.toBe('');
    page.mode.enter('build');
    page.editor.commit({ type: 'add', objects: [samples.target] });
    expect(page.task.text.value).toMatchObject({ title: '', text: '' });
  });

  it('has its place beside the program while the robot drives, and none while something is built', () => {
    const page = createPage();
    expect(page.layout.card.value).toBe('open');
    page.mode.enter('build');
    expect(page.layout.card.value).toBeNull();
    page.mode.enter('drive');
    page.task.close();
    expect(page.layout.card.value).toBe('folded');
  });

  it('has its hints closed again in each other course', async () => {
    const page = createPage();
    const card = { ...sceneDefaults.card, hints: ['a', 'b'] };
    await open(page, { ...told('x'), task: { ...sceneDefaults.task, card } });
    page.task.hints.value = 2;
    await open(page, { ...told('y'), task: { ...sceneDefaults.task, card } });
    expect(page.task.hints.value).toBe(0);
  });
});

describe('the stars of a mission', () => {
  const [mission] = ladderOf('callibot');
  const passed = (page: TestPage, type = 'callibot'): Promise<void> => {
    const verdict = { state: 'passed', stars: 2 } as Verdict; // what keeping them looks at
    return show(page, { verdict, robot: { type } as RobotSnapshot });
  };
  async function pageWithMission(): Promise<TestPage> {
    const page = createPage();
    useCourses(page).openWhole(mission!);
    await nextTick();
    await startRun(page);
    return page;
  }

  it('are kept when it is passed', async () => {
    const page = await pageWithMission();
    await passed(page);
    expect(page.task.stars.all.value).toMatchObject({ [mission!.id]: 2 });
  });

  it('are not kept in a course that was changed, nor with another robot', async () => {
    const page = await pageWithMission();
    await passed(page, 'maqueen-lite');
    expect(page.task.stars.all.value).toEqual({});
    await show(page);
    page.mode.enter('build');
    page.editor.commit({ type: 'course', changes: { size: [500, 500] } });
    await passed(page);
    expect(page.task.stars.all.value).toEqual({});
  });
});
