import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { closedLine, openWork } from './page';
import { by, gone, until } from './parts';

const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');

async function openMaker(app: App): Promise<void> {
  await openWork(app, closedLine(), './#task');
  await until(app, by('maker-add-check'));
}

/** Chooses a type of check from the list. */
const addCheck = (app: App, type: string): Promise<void> =>
  app.evaluate((wanted) => {
    const list = document.querySelector<HTMLSelectElement>('[data-testid=maker-add-check]')!;
    list.value = wanted;
    list.dispatchEvent(new Event('change', { bubbles: true }));
  }, type);

/** The open work as a project file has it. */
const projectOf = (app: App): Promise<string> =>
  app.evaluate(() => {
    const { project } = JSON.parse(sessionStorage.getItem('parcours.work') ?? '{}') as { readonly project: object };
    return JSON.stringify({ format: 'parcours-project', version: 4, ...project });
  });

/** The command line's results for programs handed in for a task. */
function checkedByCommandLine(task: string, programs: Readonly<Record<string, string>>) {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-task-'));
  try {
    const file = join(folder, 'task.json');
    writeFileSync(file, task);
    const names = Object.entries(programs).map(([name, text]) => {
      const path = join(folder, `${name}.py`);
      writeFileSync(path, text);
      return path;
    });
    const run = (): string => {
      try {
        return execFileSync('node', ['bin/parcours.mjs', 'check', file, ...names, '--json'], { encoding: 'utf8' });
      } catch (error) {
        return (error as { readonly stdout: string }).stdout; // exit code 3: not all have passed
      }
    };
    const lines = run().trim().split('\n');
    const { handIns } = JSON.parse(lines.at(-1) ?? '{}') as {
      readonly handIns: readonly {
        readonly name: string;
        readonly passed: boolean;
        readonly worlds: readonly object[];
      }[];
    };
    return Object.fromEntries(handIns.map(({ name, passed, worlds }) => [name, [passed, worlds.length]]));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

test(
  'a task is made of the open course: its solution passes in all worlds, and the class gets neither',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(90_000);
    await openMaker(app);
    await app.click(by('maker-take'));
    await expect.poll(() => app.text(by('maker-verdict')), { timeout: 20_000 }).toMatch(/passes|besteht/);
    await addCheck(app, 'loop');
    await app.click(by('maker-add-world'));
    await expect.poll(() => app.text(by('maker-solution')), { timeout: 20_000 }).toMatch(/ 2 (worlds|Welten)/);
    await until(app, by('maker-same')); // the class would get the solution: it is told
    await app.click(by('maker-save-for-class'));
    const link = await app.evaluate(
      () => document.querySelector<HTMLInputElement>('[data-testid=maker-link]')?.value ?? '',
    );
    await expect.poll(() => projectOf(app)).toContain('"id":"2"'); // it is kept a moment later
    const task = await projectOf(app);
    expect(JSON.parse(task)).toMatchObject({ task: { solution: [{ name: 'main.py' }], worlds: [{}, { id: '2' }] } });
    expect(checkedByCommandLine(task, { Ada: RIGHT, Ben: 'from mbrobot import *\nforward()\n' })).toEqual({
      Ada: [true, 2],
      Ben: [false, 2],
    });
    await app.evaluate(() => sessionStorage.clear());
    await app.goto('./logo.svg');
    await app.goto(`./#${link.split('#')[1] ?? ''}`);
    await expect.poll(() => projectOf(app)).toContain('"loop"');
    expect(await projectOf(app)).not.toMatch(/"solution"|"hidden"|"worlds"/);
  },
);

test('the page of a task bars no screen reader, and stays over a reload', IN_ONE_ENGINE, async ({ app }) => {
  await openMaker(app);
  await addCheck(app, 'display');
  await app.click(by('maker-add-world'));
  await until(app, by('maker-leds'));
  await app.click(`${by('maker-leds')} button`);
  for (const [list, chosen] of Object.entries({ object: '', sensor: 'lightLevel', input: 'button a' }))
    await app.evaluate(
      (wish) => {
        const lists = document.querySelectorAll<HTMLSelectElement>(`[data-testid=maker-add-${wish.list}]`);
        const select = lists[lists.length - 1]!; // of the hidden world
        select.value = wish.chosen === '' ? select.options[1]!.value : wish.chosen;
        select.dispatchEvent(new Event('change', { bubbles: true }));
      },
      { list, chosen },
    );
  await until(app, by('maker-input'));
  await app.click(by('maker-lock-tools'));
  await app.click(by('maker-tool-pen'));
  await app.click(by('maker-line-2'));
  expect(await violationsOn(app)).toEqual([]);
  await expect.poll(() => projectOf(app)).toContain('"image":"99090:99999:99999:09990:00900"');
  expect(await projectOf(app)).toMatch(/"edits":\[.*"sensors":\{"lightLevel":127\},"inputs":\[.*"button":"a"/);
  expect(await projectOf(app)).toContain('"locks":{"tools":["pen"],"lines":[2]}');
  await app.goto('./logo.svg');
  await app.goto('./#task');
  await until(app, by('maker-leds'));
});

test(
  'the page of a task leads to the text that the class reads, and to the worksheet',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openMaker(app);
    await app.click(by('maker-card'));
    await until(app, by('task-title'));
    await app.fill(by('task-title'), 'Einmal rundherum');
    await app.press('Tab');
    await expect.poll(() => projectOf(app)).toContain('Einmal rundherum');
    expect(await violationsOn(app)).toEqual([]);
    await app.press('Escape');
    await gone(app, by('maker-card-window'));
    await app.click(by('maker-sheet'));
    await until(app, `${by('print-sheet')}[aria-pressed=true]`);
    await until(app, by('sheet-page'));
    await app.press('Escape');
    await gone(app, by('print-dialog'));
    expect(await app.text(by('maker'))).not.toBe('');
  },
);
