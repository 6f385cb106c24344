// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { ladderOf } from '#catalogue/missions';
import { MAIN } from '#project/project';

import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import '../work/catalogue/ready-courses';
import { keepBest } from '../work/programs/own-programs';
import { useCourses } from '../work/use-courses';
import TaskCard from './TaskCard.vue';

beforeAll(() => loadTexts('de'));
beforeEach(() => localStorage.clear());

const mission = ladderOf('maqueen-lite')[0]!;

function card() {
  const page = createPage();
  useCourses(page).openAgain(mission);
  page.task.open();
  const mounted = mountOn(page, TaskCard);
  const buttons = () => mounted.findAll('[data-testid="task-programs"] button');
  const choices = async () => {
    await vi.dynamicImportSettled();
    await nextTick();
    return buttons().map((it) => textOf(it.element));
  };
  const take = async (name: string) => {
    await buttons()
      .find((it) => textOf(it.element).startsWith(name))!
      .trigger('click');
    return page.work.find(MAIN)?.text;
  };
  return { page, choices, take };
}

describe('the card of a mission', () => {
  it('offers the start program and the pupil’s own ones, but for the one that is open', async () => {
    const { page, choices, take } = card();
    expect(await choices()).toEqual([]);
    page.work.setText(MAIN, 'mine = 1\n', true);
    const files = [[{ name: MAIN, text: 'best = 1\n' }]];
    keepBest(page.work, mission.id, { atMs: 1, files, stars: 2, timeMs: 4200 });
    useCourses(page).openWhole(mission);
    expect(await choices()).toEqual(['Dein bestes Programm★★ · 4.2 s', 'Dein letztes Programm']);
    expect(await take('Dein letztes')).toBe('mine = 1\n');
    expect(await choices()).toEqual(['Startprogramm', 'Dein bestes Programm★★ · 4.2 s']);
    expect(await take('Dein bestes')).toBe('best = 1\n');
    expect(await take('Startprogramm')).toBe(mission.program.de);
  });

  it('offers none of them in a task that a teacher has handed out', async () => {
    const { page, choices } = card();
    page.work.setText(MAIN, 'mine = 1\n', true);
    useCourses(page).openWhole(mission);
    page.work.openProject({ ...page.work.work.value.project, task: { version: 1, id: 'A' } }, null);
    expect(await choices()).toEqual([]);
  });
});
