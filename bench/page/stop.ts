import type { Page } from '@playwright/test';
import { median, repeat, type Figure, type Subject } from '../subject';
import { pasteProgram, until, untilUsable, withPage, type Stage } from './stage';
import { PLACES } from './watch';

const ROUNDS = 3;
/** How long each program runs before Stop, in ms. */
const RUNNING_MS = 1_000;
/** A page whose frames are further apart than this feels stuck; the limit for feeling an answer as immediate. */
const RESPONSIVE_MS = 100;

const ENDLESS = [
  { program: 'while True: pass', budgetMs: 100, budget: '<= 100 ms' },
  { program: 'while True: print(1)', budgetMs: 100, budget: '<= 100 ms' },
  { program: 'sum(range(10**9))', budgetMs: 100, budget: '<= 100 ms' },
] as const;

/** True if Stop works on everything. */
export const stopSubject: Subject<Stage> = {
  budgets: [
    ...ENDLESS.map(({ program, budget }) => ({ what: `Stop in ${program}`, budget })),
    { what: 'meanwhile: longest gap between two frames', budget: `responsive (<= ${RESPONSIVE_MS} ms)` },
  ],
  measure: (stage) =>
    withPage(stage, {}, async ({ page }) => {
      await untilUsable(page);
      const figures: Figure[] = [];
      const gapsMs: number[] = [];
      for (const { program, budgetMs } of ENDLESS) {
        await pasteProgram(page, program);
        const stops = await repeat(ROUNDS, () => runAndStop(page));
        const stopMs = median(stops.map((stop) => stop.stopMs));
        figures.push({ text: `${stopMs.toFixed(0)} ms`, met: stopMs <= budgetMs });
        gapsMs.push(median(stops.map((stop) => stop.gapMs)));
      }
      const text = `${gapsMs.map((ms) => ms.toFixed(0)).join(', ')} ms`;
      return [...figures, { text, met: Math.max(...gapsMs) <= RESPONSIVE_MS }];
    }),
};

/** Runs what is in the editor, presses Stop, and says how long the page took to show that all is over. */
async function runAndStop(page: Page): Promise<{ stopMs: number; gapMs: number }> {
  const started = await page.evaluate(() => window.bench.started);
  await page.evaluate(() => (window.bench.frames = []));
  await page.click(PLACES.run);
  await until(page, (before) => window.bench.started > before, started);
  await page.waitForTimeout(RUNNING_MS);
  const stopped = page.evaluate(timeToStopped, PLACES.stop);
  await page.click(PLACES.stop);
  const stopMs = await stopped;
  await page.waitForTimeout(RESPONSIVE_MS);
  const frames = await page.evaluate(() => window.bench.frames);
  return { stopMs, gapMs: Math.max(...frames.slice(1).map((ms, place) => ms - (frames[place] ?? ms))) };
}

/** In the page: from the click, as the system stamped it, until Stop cannot be pressed any more. */
function timeToStopped(css: string): Promise<number> {
  return new Promise((resolve, reject) => {
    const button = document.querySelector<HTMLButtonElement>(css);
    if (button === null) {
      reject(new Error(`No ${css} on the page.`));
      return;
    }
    let clickedMs = NaN;
    button.addEventListener('click', (event) => (clickedMs = event.timeStamp), { capture: true, once: true });
    const observer = new MutationObserver(() => {
      if (!button.disabled || Number.isNaN(clickedMs)) return;
      observer.disconnect();
      resolve(performance.now() - clickedMs);
    });
    observer.observe(button, { attributes: true });
  });
}
