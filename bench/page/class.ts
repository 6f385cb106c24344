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
