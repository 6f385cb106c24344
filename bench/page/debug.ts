import { median, type Subject } from '../subject';
import { closedLine } from './kept-work';
import { chooseMaximumSpeed, until, untilUsable, withPage, type Stage } from './stage';
import { PLACES } from './watch';

/** As many steps back are made; the middle one counts. */
const STEPS = 5;
const DRIVEN_US = 60_000_000;
const BUDGET_MS = 300;
const BACK = '[data-testid=step-back]';

/** How soon the page shows the line before, after a minute of driving. */
export const debugSubject: Subject<Stage> = {
  budgets: [{ what: 'one line back, after 60 simulated seconds', budget: `<= ${BUDGET_MS} ms` }],
  measure: (stage) =>
    withPage(stage, { work: closedLine() }, async ({ page }) => {
      await untilUsable(page);
      await chooseMaximumSpeed(page);
      await page.click(PLACES.run);
      await until(page, (us) => window.bench.timeUs >= us, DRIVEN_US);
      await page.click('[data-testid=pause]');
      await page.waitForSelector(BACK);
      await page.click(BACK); // brings the worker that looks into the past
      await page.waitForSelector(`${PLACES.lookBack}[aria-checked=true]`);
      await page.waitForTimeout(2_000);
      const times: number[] = [];
      while (times.length < STEPS) times.push(await page.evaluate(timeToLineBefore, BACK));
      const ms = median(times);
      return [{ text: `${ms.toFixed(0)} ms (longest ${Math.max(...times).toFixed(0)} ms)`, met: ms <= BUDGET_MS }];
    }),
};

/** In the page: presses, and waits until another line is marked. */
async function timeToLineBefore(css: string): Promise<number> {
  const marked = (): string => document.querySelector('.cm-standingLine')?.textContent ?? '';
  const before = marked();
  const startMs = performance.now();
  document.querySelector<HTMLElement>(css)?.click();
  while (marked() === before && performance.now() - startMs < 5_000) await new Promise(requestAnimationFrame);
  return performance.now() - startMs;
}
