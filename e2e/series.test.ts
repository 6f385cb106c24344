import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { attribute, on, openWork } from './page';
import { by, gone, until } from './parts';
import { dropFile, savedFiles, watchSaving, type SavedFile } from './transfer';

const SCENE = JSON.parse(readFileSync('courses/missions/01-forward/scene.json', 'utf8')) as object;
const PROGRAM = 'from mbrobot import *\n\nforward()\ndelay(2500)\nstop()\n';

/** A task as a teacher has saved it: solution, hidden world and all. Its start program passes. */
const taskFile = (name: string): SavedFile => ({
  name: `${name}.json`,
  text: JSON.stringify({
    format: 'parcours-project',
    version: 4,
    files: [{ name: 'main.py', text: `# ${name}\n${PROGRAM}` }],
    task: {
      version: 1,
      checks: [{ type: 'goals', id: 'goals' }],
      worlds: [{ id: 'secret', hidden: true, seed: 7 }],
      solution: [{ name: 'main.py', text: '# the solution' }],
      locks: { course: true },
    },
    scene: { ...SCENE, name },
  }),
});

/** Chooses files in the page's own field. */
const chooseFiles = (app: App, files: readonly SavedFile[]): Promise<void> =>
  app.evaluate((chosen) => {
    const data = new DataTransfer();
    for (const { name, text } of chosen) data.items.add(new File([text], name));
    const picker = document.querySelector<HTMLInputElement>('[data-testid=series-picker]')!;
    picker.files = data.files;
    picker.dispatchEvent(new Event('change', { bubbles: true }));
  }, files);

const chooseReady = (app: App, course: string): Promise<void> =>
  app.evaluate((wanted) => {
    const list = document.querySelector<HTMLSelectElement>('[data-testid=series-add-ready]')!;
    list.value = wanted;
    list.dispatchEvent(new Event('change', { bubbles: true }));
  }, course);

const rows = (app: App): Promise<readonly string[]> =>
  app.evaluate(() =>
    [...document.querySelectorAll<HTMLInputElement>('[data-testid^=series-row-] input')].map(
      ({ value, placeholder }) => value || placeholder,
    ),
  );

const cards = (app: App): Promise<readonly string[]> =>
  app.evaluate(() => [...document.querySelectorAll('[data-testid=series] h3')].map((one) => one.textContent.trim()));

/** Opens the page in English, at full speed, as a visitor who was here before. */
async function openAt(app: App, address: string): Promise<void> {
  await app.goto('./logo.svg');
  await app.evaluate(() => {
    localStorage.setItem('parcours.settings', JSON.stringify({ language: 'en', speed: 'max', welcomed: true }));
  });
  await app.goto(address);
}

/** A series of two tasks of a teacher and a ready course, and the link to it. */
async function makeSeries(app: App): Promise<string> {
  await openAt(app, './#make-series');
  await until(app, by('series-title'));
  await chooseFiles(app, [taskFile('Second'), taskFile('First')]);
  await expect.poll(() => rows(app)).toEqual(['Second', 'First']);
  await chooseReady(app, 'square');
  await expect.poll(() => rows(app)).toHaveLength(3);
  await app.click(`${by('series-row-2')} [data-way=up]`);
  await expect.poll(async () => (await rows(app)).slice(0, 2)).toEqual(['First', 'Second']);
  await app.fill(by('series-title'), 'Week 3');
  await app.click(by('series-make-link'));
  await until(app, by('series-link'));
  return app.evaluate(() => document.querySelector<HTMLInputElement>('[data-testid=series-link]')?.value ?? '');
}

/** The address behind the app's own, in a visit that has nothing of the series yet. */
async function openLink(app: App, link: string): Promise<void> {
  await app.goto('./logo.svg');
  await app.evaluate(async () => {
    sessionStorage.clear();
    await new Promise((resolve) => {
      const request = indexedDB.deleteDatabase('parcours');
      request.onsuccess = request.onerror = request.onblocked = resolve;
    });
  });
  await openAt(app, `./#${link.split('#')[1] ?? ''}`);
  await until(app, by('series-task-1'));
}

const work = (app: App): Promise<string> => app.evaluate(() => sessionStorage.getItem('parcours.work') ?? '');

test(
  'a series is made from two files and a ready course, solved from its link task by task, and keeps what is done',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    const link = await makeSeries(app);
    await openLink(app, link);
    expect((await cards(app)).slice(0, 2)).toEqual(['First', 'Second']);
    expect(await attribute(app, by('series-task-1'), 'aria-current')).toBe('step');

    await app.click(by('series-open-next'));
    await gone(app, '.gallery');
    await until(app, by('series-way')); // the card of the task
    await expect.poll(() => app.text(by('series-way'))).toContain('Task 1 of 3');
    await expect.poll(() => work(app)).toContain('# First');
    expect(await work(app)).toMatch(/"locks":\{"course":true\},"handedOut":true/);
    expect(await work(app)).not.toMatch(/"solution"|"hidden"|secret/);
    await app.click(on('run'));
    await until(app, `${by('verdict')}[data-state=passed] ${by('step-hand-in')}`);
    await app.click(`${by('series-way')} ${by('series-next')}`); // whoever hands in later goes on from the card
    await expect.poll(() => work(app)).toContain('# Second');
    await expect.poll(() => app.text(by('series-way'))).toContain('Task 2 of 3');

    await app.click(`${by('series-way')} ${by('series-back')}`);
    await until(app, by('series-done-1'));
    expect(await attribute(app, by('series-task-2'), 'aria-current')).toBe('step');
    await app.reload();
    await until(app, by('series-done-1'));
    await expect.poll(() => app.text(by('series-sum'))).toContain('1 of 3 done');
    await until(app, by('series-anew-2')); // it is open
  },
);

test(
  'a link cut short, a foreign address, a page that is no series: each says why and the way out',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const says = async (address: string): Promise<string> => {
      await openAt(app, address);
      await until(app, by('series-problem'));
      return app.text(by('series-problem'));
    };
    expect(await says('./#s=1.AAAAAAAAAAA')).toContain('Copy it again, whole, or ask for the series as a file.');
    expect(await says('./#series=https://school.example/series.json')).toMatch(/school\.example.*the link that holds/);
    expect(await says('./#series=gone/series.json')).toMatch(/not on the web server \(answer 404\)/);
    expect(await says('./#series=logo.svg')).toContain('damaged');
    expect(await says('./#series/unknown')).toContain('Open the link or file again');
  },
);

test(
  'a folder on the page’s own web server is a gallery by address; a task in it that cannot be read says so',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const name = `tried-series-${app.engine}`;
    const folder = `dist/app/${name}`;
    mkdirSync(folder, { recursive: true });
    try {
      const good = taskFile('Beside');
      writeFileSync(`${folder}/a.json`, good.text);
      writeFileSync(`${folder}/b.json`, '{ "format": "parcours-project", "version": 99 }');
      const tasks = [{ file: 'a.json' }, { file: 'b.json', title: 'Later' }, { file: 'c.json' }, { course: 'square' }];
      const head = { format: 'parcours-series', version: 1, title: 'Own gallery' };
      writeFileSync(`${folder}/series.json`, JSON.stringify({ ...head, tasks }));
      await openAt(app, `./#series=${name}/series.json`);
      await until(app, by('series-task-4'));
      expect((await cards(app)).slice(0, 2)).toEqual(['Beside', 'Later']);
      expect(await app.text(by('series-task-2'))).toContain('newer version');
      expect(await app.text(by('series-task-3'))).toContain('answer 404');
      await app.click(`${by('series-task-1')} h3 button`);
      await expect.poll(() => work(app)).toContain('# Beside');
      rmSync(folder, { recursive: true });
      await openAt(app, `./#series=${name}/series.json`); // without the server it is as it was
      await until(app, by('series-task-4'));
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
);

test('the file of a series opens by being dropped onto the page', IN_ONE_ENGINE, async ({ app }) => {
  const head = { format: 'parcours-series', version: 1, title: 'Dropped' };
  const tasks = [{ project: JSON.parse(taskFile('Inside').text) as object }, { project: { ...head, tasks: [] } }];
  await openWork(app, '', './');
  await until(app, on('editor'));
  await dropFile(app, { name: 'series.json', text: JSON.stringify({ ...head, tasks }) });
  await until(app, by('series-task-2'));
  expect((await cards(app))[0]).toBe('Inside');
});

test(
  'the pages of a series bar no screen reader; what is made stays over a reload, and the teacher’s file has all',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await makeSeries(app);
    expect(await violationsOn(app)).toEqual([]);
    await watchSaving(app);
    await app.click(by('series-save'));
    await app.click(by('series-save-file'));
    const [own, given] = await savedFiles(app);
    expect(own?.name).toBe('Week 3.series.json');
    expect(own?.text).toContain('# the solution');
    expect(given?.text).not.toMatch(/solution|secret/);
    await app.click(by('series-view'));
    await until(app, by('series-task-3'));
    expect(await violationsOn(app)).toEqual([]);
    await app.goto('./logo.svg');
    await app.goto('./#make-series');
    await expect.poll(() => rows(app)).toHaveLength(3);
  },
);
