// @vitest-environment happy-dom
import { beforeAll, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { defaultScene, sceneDefaults, type Scene } from '#scene/scene';

import { createPage, type TestPage } from '../app/testing/page';
import { startRun } from '../app/testing/run';
import { loadTexts, showLanguage } from '../page/i18n';
import { courses } from '../work/catalogue/courses';
import { useCourses } from '../work/use-courses';

beforeAll(() => loadTexts('de'));

const told = (description: string): Scene => ({ ...defaultScene(), description });

async function open(page: TestPage, scene: Scene): Promise<void> {
  page.work.setScene(scene, null);
  await nextTick();
}

describe('the card of the task', () => {
  it('opens with a course that has a text, and with no other', async () => {
    const page = createPage();
    expect(page.task.isOpen.value).toBe(false); // a first visit begins with the program
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

  it('opens with an address, be it that of the course that is open', async () => {
    const page = createPage();
    page.work.arrivals.value += 1;
    await nextTick();
    expect(page.task.isOpen.value).toBe(true);
  });

  it('stays closed while the course is edited, and goes when a run starts', async () => {
    const page = createPage();
    await open(page, told('Fahr ins Ziel.'));
    await startRun(page);
    expect(page.task.isOpen.value).toBe(false);
    page.task.open();
    expect(page.task.isOpen.value).toBe(true); // asked for, it is there while the robot drives
    page.task.close();
    page.editor.commit({ type: 'course', changes: { description: 'Fahr weiter.' } });
    await nextTick();
    expect(page.task.isOpen.value).toBe(false);
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
