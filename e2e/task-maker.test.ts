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

/** Something in the second world, which is hidden. */
const inHidden = (id: string): string => `${by('maker-world')}:nth-child(2) ${by(id)}`;

/** The course of the open work, and the start of the hidden world's robot, in mm and degrees. */
async function startAndCourse(app: App): Promise<{ x: number; y: number; heading: number; course: string }> {
  type Start = { readonly at: readonly [number, number]; readonly heading: number };
  const { task, scene } = JSON.parse(await projectOf(app)) as {
    readonly scene: object;
    readonly task?: { readonly worlds?: readonly { readonly start?: Start }[] };
  };
  const { at, heading } = task?.worlds?.[1]?.start ?? { at: [0, 0], heading: 0 };
  return { x: at[0], y: at[1], heading, course: JSON.stringify(scene) };
}

/** A place of the hidden world's arena in the window, from its middle, in px. */
const placeInHidden = (app: App, dx: number, dy: number): Promise<{ readonly x: number; readonly y: number }> =>
  app.evaluate(
    ({ css, by: [x, y] }) => {
      const box = document.querySelector(css)!.getBoundingClientRect();
      return { x: box.left + box.width / 2 + x!, y: box.top + box.height / 2 + y! };
    },
    { css: `${inHidden('maker-arena')} ${by('maker-frame')}`, by: [dx, dy] },
  );

/** Writes a model solution: it begins as the start program. */
async function writeSolution(app: App): Promise<void> {
  await app.click(by('maker-solution'));
  await until(app, by('maker-code'));
  await app.click(by('maker-code'));
  await app.press('Control', 'End');
  await app.type('# mine');
}

test(
  'a task is made of the open course: its solution passes in all worlds, and the class gets neither',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(90_000);
    await openMaker(app);
    await writeSolution(app);
    await expect.poll(() => app.text(by('maker-step')), { timeout: 20_000 }).toMatch(/passes|besteht/);
    await addCheck(app, 'loop');
    await app.click(by('maker-add-world'));
    await expect.poll(() => app.text(by('maker-step')), { timeout: 20_000 }).toMatch(/ 2 (worlds|Welten)/);
    await app.click(by('maker-act')); // nothing is left to do: it is handed out
    await until(app, by('maker-link'));
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
    expect(await projectOf(app)).not.toMatch(/"solution"|"hidden"|"worlds"|# mine/);
  },
);

test('the robot of a hidden world is dragged, and moved by keys; the course stays', IN_ONE_ENGINE, async ({ app }) => {
  await openMaker(app);
  await app.click(by('maker-add-world'));
  await until(app, `${inHidden('maker-arena')} ${by('maker-frame')}`); // the new one has the keyboard
  await expect.poll(async () => (await startAndCourse(app)).x).toBeGreaterThan(0);
  const before = await startAndCourse(app);
  await app.press('ArrowUp');
  await app.press('r');
  await expect.poll(async () => (await startAndCourse(app)).heading - before.heading).toBe(-5);
  const moved = await startAndCourse(app);
  expect(moved.y - before.y).toBe(10);
  await app.draw([await placeInHidden(app, 0, 0), await placeInHidden(app, 20, 0), await placeInHidden(app, 40, 0)]);
  await expect.poll(async () => (await startAndCourse(app)).x - moved.x).toBeGreaterThan(50);
  expect((await startAndCourse(app)).course).toBe(before.course);
});

test('the page of a task bars no screen reader, and stays over a reload', IN_ONE_ENGINE, async ({ app }) => {
  await openMaker(app);
  await addCheck(app, 'display');
  await app.click(by('maker-add-world'));
  await until(app, by('maker-leds'));
  await app.click(`${by('maker-leds')} button`);
  expect(await violationsOn(app)).toEqual([]);
  await app.click(inHidden('maker-world-more'));
  for (const [list, chosen] of Object.entries({ object: '', sensor: 'lightLevel', input: 'button a' }))
    await app.evaluate(
      (wish) => {
        const select = document.querySelector<HTMLSelectElement>(`[data-testid=maker-add-${wish.list}]`)!;
        select.value = wish.chosen === '' ? select.options[1]!.value : wish.chosen;
        select.dispatchEvent(new Event('change', { bubbles: true }));
      },
      { list, chosen },
    );
  await until(app, by('maker-input'));
  expect(await violationsOn(app)).toEqual([]);
  await app.click(by('maker-world-close'));
  await app.click(by('maker-menu'));
  await app.click(by('maker-locks-open'));
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
  'the card that the class reads is written in its place, and the worksheet is behind the three dots',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openMaker(app);
    await app.fill(by('maker-title'), 'Einmal rundherum');
    await app.press('Tab');
    await expect.poll(() => projectOf(app)).toContain('Einmal rundherum');
    await app.click(by('maker-text'));
    await until(app, `textarea${by('maker-text')}`);
    await app.fill(by('maker-text'), 'Folge der Linie.');
    await app.press('Tab');
    await app.click(by('maker-add-hint'));
    await until(app, `textarea${by('maker-hint')}`);
    await app.type('Langsam.');
    await app.press('Escape'); // ends the hint, and not the page
    await expect.poll(() => projectOf(app)).toMatch(/Folge der Linie.*Langsam/);
    await app.click(by('maker-menu'));
    await app.click(by('maker-sheet'));
    await until(app, `${by('print-sheet')}[aria-pressed=true]`);
    await until(app, by('sheet-page'));
    await app.press('Escape');
    await gone(app, by('print-dialog'));
    expect(await app.text(by('maker'))).not.toBe('');
  },
);
