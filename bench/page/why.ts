import { type Subject } from '../subject';
import { closedLine } from './kept-work';
import { chooseMaximumSpeed, until, untilUsable, withPage, type Stage } from './stage';
import { PLACES } from './watch';

const DRIVEN_US = 60_000_000;
/** Chosen: the first one has to run it again, the next ones know. */
const [FIRST_MS, NEXT_MS] = [500, 300];

/** How soon the page knows which line did it, after a minute of driving. */
export const whySubject: Subject<Stage> = {
  budgets: [
    { what: 'why? asked for the first time, after 60 simulated seconds', budget: `<= ${FIRST_MS} ms` },
    { what: 'why? asked again', budget: `<= ${NEXT_MS} ms` },
  ],
  measure: (stage) =>
    withPage(stage, { work: closedLine() }, async ({ page }) => {
      await untilUsable(page);
      await chooseMaximumSpeed(page);
      await page.click(PLACES.run);
      await until(page, (us) => window.bench.timeUs >= us, DRIVEN_US);
      await page.click(PLACES.lookBack);
      await page.waitForSelector('[data-testid=why-open]');
      await page.waitForTimeout(1_000);
      const first = await page.evaluate(timeToAnswer);
      await page.click('[data-testid=why-close]');
      const next = await page.evaluate(timeToAnswer);
      return [
        { text: `${first.toFixed(0)} ms`, met: first <= FIRST_MS },
        { text: `${next.toFixed(0)} ms`, met: next <= NEXT_MS },
      ];
    }),
};

/** In the page: asks, and waits until a line is named. */
async function timeToAnswer(): Promise<number> {
  const startMs = performance.now();
  document.querySelector<HTMLElement>('[data-testid=why-open]')?.click();
  while (document.querySelector('[data-testid=why-go]') === null && performance.now() - startMs < 20_000)
    await new Promise(requestAnimationFrame);
  return performance.now() - startMs;
}
