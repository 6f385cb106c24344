// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { aSeries, teachersTask } from '#check/series/testing/series';
import { withAbout, type ShelfWork } from '#check/shelf/shelf';
import { shelfToFolder, workToText } from '#check/shelf/write-shelf';
import { noAbout } from '#check/task/about';
import { projectForPupils } from '#check/task/write-task';
import { taskOf } from '#check/task/read-task';

import { downloads } from '../../app/testing/downloads';
import { byId, idsShown, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { stubDatabase } from '../../session/work/storage/testing/memory-database';
import { seriesDraft } from '../series/series-draft';
import { shelfOf } from '../shelf/use-shelf';
import TasksPage from './TasksPage.vue';
import { addFiles, worksIn } from './use-own-tasks';

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  document.body.innerHTML = '<div id="menus"></div>';
  stubDatabase();
});
afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const about = {
  ...noAbout,
  level: 'Klasse 8',
  topic: 'Linien',
  minutes: 45,
  author: 'Ada',
  licence: 'CC-BY-4.0',
} as const;
const named = (name: string): ShelfWork => ({
  kind: 'task',
  project: { ...teachersTask(), scene: { ...teachersTask().scene, name } },
});
const series: ShelfWork = { kind: 'series', series: aSeries() };
const rows = (): readonly string[] =>
  [...document.querySelectorAll('[data-testid=tasks-row] .names')].map((row) => textOf(row));
const file = (path: string, text: string) => ({ path, file: new File([text], path) });

async function opened(page = createPage()): Promise<TestPage> {
  page.router.open('tasks');
  mountOn(page, TasksPage);
  await vi.waitFor(() => expect(isThere('tasks-page')).toBe(true));
  return page;
}
async function withThree(): Promise<TestPage> {
  const page = createPage();
  for (const work of [
    series,
    withAbout(named('Wand'), { ...about, topic: 'Wände', minutes: 20 }),
    withAbout(named('Linie'), about),
  ])
    await shelfOf(page).keep(work);
  return opened(page);
}
const choose = async (id: string, value: string): Promise<void> => {
  const field = byId(id) as HTMLSelectElement;
  field.value = value;
  field.dispatchEvent(new Event('change'));
  await flushPromises();
};

const more = async (): Promise<void> => {
  await tap('tasks-more');
  await vi.waitFor(() => expect(isThere('tasks-about')).toBe(true));
};

describe('the page with the own tasks', () => {
  it('shows each with level, topic, duration, author and licence, and finds them by all of that', async () => {
    await withThree();
    expect(rows()).toEqual([
      'LinieKlasse 8 · Linien · 45 min · Welten: 2 · Ada, CC BY 4.0',
      'WandKlasse 8 · Wände · 20 min · Welten: 2 · Ada, CC BY 4.0',
      'Woche 3: LinienAufgaben: 3',
    ]);
    await write(byId('tasks-search'), 'linien');
    expect(rows()).toHaveLength(2);
    await choose('tasks-minutes', '45');
    expect(rows()).toEqual([expect.stringContaining('Linie')]);
    await choose('tasks-topic', 'Wände');
    expect(document.body.textContent).toContain('Nichts gefunden.');
  });

  it('opens a task with its solution on its own page, and a series that can be taken back', async () => {
    const page = await withThree();
    await tap('tasks-open');
    expect([page.router.page.value?.name, page.work.work.value.project.scene.name]).toEqual(['task', 'Linie']);
    expect(page.work.work.value.project.task?.['solution']).toBeDefined();
    page.router.open('tasks');
    seriesDraft(page).change({ title: 'Alte', tasks: aSeries().tasks });
    await flushPromises();
    document.querySelectorAll<HTMLElement>('[data-testid=tasks-open]')[2]!.click();
    expect([page.router.page.value?.name, seriesDraft(page).series.value.title]).toEqual([
      'make-series',
      'Woche 3: Linien',
    ]);
    page.notices.current.value?.action?.run();
    expect(seriesDraft(page).series.value.title).toBe('Alte');
  });

  it('hands out the link without solution and hidden worlds', async () => {
    const saved = downloads();
    await withThree();
    await tap('tasks-hand-out');
    expect((byId('tasks-link') as HTMLInputElement).value).toContain('#p=');
    await tap('tasks-given-file');
    expect(saved[0]!.name).toBe('Linie – Klasse.parcours.json');
    expect(await saved[0]!.blob.text()).not.toMatch(/Musterlösung|geheim/);
  });

  it('changes what is said of a task, saves it, and deletes it with a way back', async () => {
    const saved = downloads();
    const page = await withThree();
    await more();
    await tap('tasks-about');
    await write(byId('about-level'), ' Klasse 9 ');
    await choose('about-licence', 'CC0-1.0');
    await tap('about-done');
    await vi.waitFor(() => expect(rows()[0]).toContain('Klasse 9 · Linien · 45 min · Welten: 2 · Ada, CC0 1.0'));
    await more();
    await tap('tasks-save');
    expect([saved[0]!.name, await saved[0]!.blob.text()]).toEqual(['Linie.parcours.json', expect.stringContaining('"Klasse 9"')]); // prettier-ignore
    await more();
    await tap('tasks-remove');
    await vi.waitFor(() => expect(rows()).toHaveLength(2));
    page.notices.current.value?.action?.run();
    await vi.waitFor(() => expect(rows()[0]).toContain('Klasse 9'));
  });

  it('takes a folder back that was saved of it, its list included, and says what it cannot read', async () => {
    const page = await opened();
    const folder = shelfToFolder('', [
      { work: named('Linie'), name: 'Linie', text: '' },
      { work: series, name: 'Woche 3', text: '' },
    ]);
    const refusals = await addFiles(page, [
      ...folder.map(({ name, text }) => file(`meine/${name}`, text)),
      file('foto.png', ''),
    ]);
    await flushPromises();
    expect(rows().map((row) => row.slice(0, 5))).toEqual(['Linie', 'Woche']);
    expect(refusals).toEqual([expect.stringContaining('foto.png')]);
    page.notices.current.value?.action?.run();
    await vi.waitFor(() => expect(rows()).toEqual([]));
  });

  it('has a task that a class was given as one that can be changed, and one without a name by its file', () => {
    const read = taskOf(teachersTask());
    if ('problem' in read) throw new Error(read.problem);
    const given = { ...projectForPupils(read.task), handIn: { version: 1 } };
    const [work] = worksIn({ tasks: [{ title: 'datei', from: { kind: 'project', project: given } }], series: [] });
    expect(work).toMatchObject({ kind: 'task', project: { scene: { name: 'datei' } } });
    expect(workToText(work!)).not.toMatch(/handedOut|handIn/);
  });
});

describe('the shelf of a school', () => {
  const folder = shelfToFolder('Schule am See', [
    { work: withAbout(named('Linie'), about), name: 'Linie', text: 'Fahr.' },
  ]);
  const serve = (answer: (path: string) => string | null): void => {
    vi.stubGlobal('fetch', (url: URL) => {
      const text = answer(url.pathname);
      return Promise.resolve(new Response(text ?? '', { status: text === null ? 404 : 200 }));
    });
  };
  async function shown(address: string): Promise<TestPage> {
    const page = createPage();
    page.router.open('tasks', `shelf=${address}`);
    mountOn(page, TasksPage);
    await vi.waitFor(() => expect(idsShown().some((id) => id === 'tasks-row' || id === 'school-problem')).toBe(true));
    return page;
  }

  it('shows what its list says, and opens or takes what is wanted', async () => {
    serve((path) => folder.find(({ name }) => path.endsWith(`/aufgaben/${name}`))?.text ?? null);
    const page = await shown('aufgaben/shelf.json');
    expect(document.querySelector('h2')?.textContent).toContain('Schule am See');
    expect(rows()).toEqual(['LinieKlasse 8 · Linien · 45 min · Ada, CC BY 4.0']);
    await tap('school-keep');
    await vi.waitFor(() => expect(shelfOf(page).items.value).toHaveLength(1));
    await tap('school-open');
    await vi.waitFor(() => expect(page.router.page.value?.name).toBe('task'));
    expect(page.work.work.value.project.scene.name).toBe('Linie');
  });

  it.each([
    ['https://[', '«https://[» ist keine Adresse.'],
    ['https://anderswo.example/shelf.json', 'Von anderswo.example wird nichts geholt'],
    ['fehlt.json', '/fehlt.json gibt es auf dem Server nicht (Antwort 404).'],
    ['seite.html', 'Unter seite.html liegt keine Ablage.'],
    ['neuer.json', 'stimmt etwas nicht: Shelf version 9'],
    ['gross.json', '/gross.json ist zu gross'],
  ])('at %s says why there is none', async (address, problem) => {
    const texts: Readonly<Record<string, string>> = {
      '/seite.html': '<!doctype html>',
      '/neuer.json': '{"format":"parcours-shelf","version":9}',
      '/gross.json': 'x'.repeat(2_000_001),
    };
    serve((path) => texts[path] ?? null);
    await shown(address);
    expect(textOf(byId('school-problem'))).toContain(problem);
  });
});
