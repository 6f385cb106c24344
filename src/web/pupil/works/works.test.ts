// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { ladderOf } from '#catalogue/missions';
import { courses } from '#catalogue/courses';
import { MAIN } from '#project/project';

import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import AppDialog from '../../app/AppDialog.vue';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { keepBest } from '../../session/work/programs/own-programs';
import { DELETED_MS, type Previous } from '../../session/work/storage/history';
import { useCourses } from '../../session/work/use-courses';
import { setUp } from './set-up';
import WorksPage from './WorksPage.vue';

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  localStorage.clear();
  setWindow(1366, 768);
});

const ladder = ladderOf('maqueen-lite');
const mission = (number: number) => ladder[number - 1]!;
const course = courses.find(({ id }) => id === 'slalom')!;

/** A pupil who has done three missions, a task of the class and a course of the gallery; the page of works is open. */
async function pupil(): Promise<TestPage> {
  const page = createPage();
  const { openAgain } = useCourses(page);
  for (const number of [1, 2, 3]) {
    openAgain(mission(number));
    page.work.setText(MAIN, `mission = ${String(number)}`, true);
  }
  openAgain(course);
  page.work.setText(MAIN, 'round = "the poles"', true);
  const { project } = page.work.work.value;
  page.work.openProject({ ...project, task: { id: 'garage', version: 1 } }, 'Slalom');
  page.work.setText(MAIN, 'garage = 1', true);
  openAgain(mission(4));
  const files = [[{ name: MAIN, text: 'best = 2' }]];
  keepBest(page.work, mission(2).id, { atMs: 1, files, stars: 3, timeMs: 4200 });
  await shown(page);
  return page;
}
async function shown(page: TestPage): Promise<void> {
  page.router.open('works');
  mountOn(page, WorksPage);
  await nextTick();
  await nextTick();
}
const counted = (which: string): string => textOf(byId(`works-${which}`));
const others = (): readonly string[] =>
  [...document.querySelectorAll('[data-testid="work-other"] .name')].map((it) => textOf(it));
const missions = (): readonly string[] => [...document.querySelectorAll('.mission .name')].map((it) => textOf(it));
const choose = (id: string): Promise<void> => tap(byId(`work-${id}`).querySelector('button')!);
const program = (): string => textOf(byId('work-program'));
const text = (page: TestPage): string | undefined => page.work.find(MAIN)?.text;

describe('the page of the pupil’s works', () => {
  it('lists the missions of the robot, the tasks of the class and own courses, and counts each sort', async () => {
    await pupil();
    expect(missions()).toHaveLength(12);
    expect(others()).toEqual(['Slalom', 'Slalom']);
    expect(['all', 'missions', 'class', 'own'].map(counted)).toEqual([
      ...['Alle 14', 'Missionen 12', 'Von der Klasse 1', 'Eigene 1'],
    ]);
    expect(isThere('works-tabs')).toBe(false);
    await tap('works-class');
    expect([missions(), others()]).toEqual([[], ['Slalom']]);
  });

  it('finds works by their names, and by what stands in their programs', async () => {
    await pupil();
    await write(byId('works-search'), 'QUADRAT');
    expect([missions(), others()]).toEqual([['3 · Ein Quadrat'], []]);
    await write(byId('works-search'), 'the poles');
    expect([missions(), others()]).toEqual([[], ['Slalom']]);
    await write(byId('works-search'), 'nobody wrote this');
    expect(textOf(document.querySelector('.list [role="status"]'))).toBe('Nichts gefunden.');
  });

  it('opens the last program of a mission; the best and the start program are the other choices', async () => {
    const page = await pupil();
    await choose(mission(2).id);
    expect(program()).toBe('mission = 2');
    await tap('work-best');
    expect(program()).toBe('best = 2');
    await tap('work-open');
    expect([text(page), page.router.page.value]).toEqual(['best = 2', null]);
    await shown(page);
    await choose(mission(3).id);
    await tap('work-open');
    expect([text(page), page.work.work.value.project.course]).toEqual(['mission = 3', mission(3).id]);
    await shown(page);
    await choose(mission(1).id);
    await tap('work-start');
    expect(text(page)).toBe(mission(1).program.de);
  });

  it('brings a task of the class back as it was left', async () => {
    const page = await pupil();
    await tap('works-class');
    await tap(byId('work-other').querySelector('button')!);
    await tap('work-open');
    expect([text(page), page.work.work.value.project.task]).toEqual(['garage = 1', { id: 'garage', version: 1 }]);
  });

  it('deletes at once, undoes that, and brings back for 30 days what was deleted', async () => {
    const page = await pupil();
    const remove = async (): Promise<void> => {
      await tap('works-class');
      await tap(byId('work-other').querySelector('button')!);
      await tap('work-more');
      await tap('work-remove');
    };
    await remove();
    expect([isThere('work-other'), counted('deleted')]).toEqual([false, 'Gelöscht 1']);
    page.notices.current.value?.action?.run();
    await nextTick();
    expect([counted('class'), isThere('works-deleted')]).toEqual(['Von der Klasse 1', false]);
    await remove();
    await tap('works-deleted');
    await tap(byId('work-deleted').querySelector('button')!);
    await tap('works-all');
    expect(counted('class')).toBe('Von der Klasse 1');
    await remove();
    const [garage] = page.work.work.value.deleted ?? [];
    page.work.work.value = { ...page.work.work.value, deleted: [{ ...garage!, deletedMs: Date.now() - DELETED_MS }] };
    await tap('works-deleted');
    expect(isThere('work-deleted')).toBe(false);
  });

  it('asks what may go when works need much room, names the largest first, and drops none by itself', async () => {
    const page = await pupil();
    setUp(page);
    const before = page.work.work.value.previous;
    const { project } = page.work.work.value;
    const large = (name: string, size: number, atMs: number): Previous => ({
      ...{ name, atMs, project: { ...project, course: null, files: [{ name: MAIN, text: name.repeat(size) }] } },
    });
    const works = [large('a', 1_000_000, 9), large('b', 2_000_000, 8), large('c', 10, 7)];
    page.work.work.value = { ...page.work.work.value, previous: [...works, ...before] };
    await nextTick();
    expect(page.notices.current.value?.values).toEqual({ text: expect.stringContaining('Was darf weg?') });
    expect(textOf(byId('works-crowded'))).toContain(`${String(before.length + 3)} Arbeiten mit 3 MB`);
    expect(others().slice(0, 2)).toEqual(['b', 'a']);
    await tap(byId('work-other').querySelector('button')!);
    await tap('work-more');
    await tap('work-remove');
    expect(others()[0]).toBe('a');
    await tap('works-deleted');
    await tap('works-forget');
    mountOn(page, AppDialog);
    await nextTick();
    await tap(named('Jetzt ganz löschen', '.dialog-card button'));
    expect([page.work.work.value.deleted, page.work.work.value.previous.length]).toEqual([
      ...[undefined, before.length + 2],
    ]);
  });

  it('shows the missions that were begun on a phone, and a work in the place of the list', async () => {
    setWindow(390, 844);
    const page = await pupil();
    expect(missions().map((name) => name.split(' ')[0])).toEqual(['3', '2', '1']);
    expect(isThere('work-detail')).toBe(false);
    await choose(mission(2).id);
    expect([program(), isThere('works-all'), location.hash]).toEqual([
      ...['mission = 2', false, `#works/${mission(2).id}`],
    ]);
    page.router.close();
  });
});
