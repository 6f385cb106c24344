import { readFileSync } from 'node:fs';
import type { Subject } from '../subject';
import { until, untilUsable, withPage, type Stage } from './stage';

const CLASS = 24;
const BUDGET_S = 5;
const TASK = 'closed-line';

/** How long a class takes that is checked on the page: right programs that differ, of 20 simulated seconds each. */
export const classSubject: Subject<Stage> = {
  budgets: [
    { what: `${CLASS} hand-ins checked on the page, 20 s of a line follower each`, budget: `<= ${BUDGET_S} s` },
  ],
  measure: (stage) =>
    withPage(stage, {}, async ({ page }) => {
      await untilUsable(page);
      await page.goto(`${stage.url}#class`);
      await page.selectOption('[data-testid=class-task]', TASK);
      const solution = readFileSync(`courses/${TASK}/main.py`, 'utf8');
      const files = Array.from({ length: CLASS }, (_, index) => ({
        name: `pupil-${index + 1}.py`,
        mimeType: 'text/x-python',
        buffer: Buffer.from(`# ${index + 1}\npupil = ${index + 1}\n${solution}`),
      }));
      const fromMs = performance.now();
      await page.locator('[data-testid=class-adding] input[multiple]').first().setInputFiles(files);
      await until(page, (count) => document.querySelectorAll('.result--passed').length === count, CLASS);
      const seconds = (performance.now() - fromMs) / 1000;
      return [{ text: `${seconds.toFixed(1)} s`, met: seconds <= BUDGET_S }];
    }),
};

/** Pupils and tasks of the class that is opened. */
const [PUPILS, TASKS] = [300, 30];
const OPEN_BUDGET_S = 1;
const FIRST_ROWS = 40;

/** The time in which the page of classes opens a file, until its first rows are drawn; the others come with scrolling. */
export const openClassSubject: Subject<Stage> = {
  budgets: [{ what: `a class of ${PUPILS} pupils and ${TASKS} tasks opened`, budget: `<= ${OPEN_BUDGET_S} s` }],
  measure: (stage) =>
    withPage(stage, {}, async ({ page }) => {
      await untilUsable(page);
      await page.goto(`${stage.url}#classes`);
      await page.locator('[data-testid=classes-none]').waitFor();
      const file = { name: 'school.json', mimeType: 'application/json', buffer: Buffer.from(classText()) };
      const fromMs = performance.now();
      await page.locator('[data-testid=classes-file]').setInputFiles(file);
      await until(page, (least) => document.querySelectorAll('tbody tr').length >= least, FIRST_ROWS);
      const seconds = (performance.now() - fromMs) / 1000;
      return [{ text: `${seconds.toFixed(2)} s`, met: seconds <= OPEN_BUDGET_S }];
    }),
};

/** The file of a class in which everybody has handed in everything. */
function classText(): string {
  const numbers = (count: number): readonly number[] => Array.from({ length: count }, (_, number) => number);
  const day = '2026-11-02';
  return JSON.stringify({
    ...{ format: 'parcours-class', version: 1, name: 'School' },
    scale: { system: 'ch6', passPercent: null, step: 0.5 },
    pupils: numbers(PUPILS).map((pupil) => ({ id: `p${pupil}`, name: `Pupil ${pupil}` })),
    tasks: numbers(TASKS).map((task) => ({ id: `t${task}`, title: `Task ${task}`, points: 4, since: day })),
    results: numbers(PUPILS * TASKS).map((place) => ({
      ...{ pupil: `p${place % PUPILS}`, task: `t${Math.floor(place / PUPILS)}`, day },
      ...(place % 3 === 0 ? { outcome: 'failed', points: 2 } : { outcome: 'passed', points: 4 }),
    })),
  });
}
