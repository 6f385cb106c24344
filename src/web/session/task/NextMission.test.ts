// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it } from 'vitest';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { courses } from '#catalogue/courses';
import { ladderOf } from '#catalogue/missions';
import '../work/catalogue/ready-courses';
import { useCourses } from '../work/use-courses';
import NextMission from './NextMission.vue';

beforeAll(() => loadTexts('de'));

async function after(course: Parameters<ReturnType<typeof useCourses>['openWhole']>[0]): Promise<TestPage> {
  const page = createPage();
  useCourses(page).openWhole(course);
  mountOn(page, NextMission);
  await flushPromises();
  return page;
}

describe('after a mission that was passed', () => {
  it('the next one is offered, for the same robot', async () => {
    const page = await after(ladderOf('callibot')[0]!);
    expect(textOf(byId('next-mission'))).toBe('Nächste Mission');
    await tap('next-mission');
    expect(page.work.work.value.project.course).toBe('corner-callibot');
    expect(page.work.find('main.py')?.text).toContain('from callibot import *');
  });

  it('the last one leads to all of them', async () => {
    const page = await after(ladderOf('maqueen-plus-v2').at(-1)!);
    await tap('next-mission');
    expect(page.router.page.value).toEqual({ name: 'missions', id: 'maqueen-plus-v2' });
    page.router.close();
  });

  it('nothing is offered after another course', async () => {
    await after(courses.find(({ id }) => id === 'square')!);
    expect(isThere('next-mission')).toBe(false);
  });
});
