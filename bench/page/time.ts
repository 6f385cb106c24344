import type { Page } from '@playwright/test';
import type { Subject } from '../subject';
import { closedLine } from './kept-work';
import { chooseMaximumSpeed, until, untilUsable, withPage, type Opened, type Stage } from './stage';
import { smoothness } from './stretch';
import { PLACES } from './watch';

const RAIL = '[data-testid=time-rail]';
const HEAD = '[data-testid=look-back]';
const SCRUBBED_US = 60_000_000;
const SCRUB_MS = 12;
const SCRUBS_MS = 2_000;
const FROM_US = 600_000_000;
const GO_ON_S = 6;
/** Longest wait for ten simulated minutes, in ms. */
const PATIENCE_MS = 180_000;

/** Drives for some simulated time as fast as it can, and looks back. */
async function lookBackAfter({ page }: Opened, us: number): Promise<void> {
  await untilUsable(page);
  await chooseMaximumSpeed(page);
  await page.click(PLACES.run);
  await until(page, (wanted) => window.bench.timeUs >= wanted, us, PATIENCE_MS);
  await page.click(PLACES.lookBack);
  await page.waitForSelector(RAIL);
  await page.waitForTimeout(1_000); // what is fetched and unpacked for it
}

/** In the page: with each frame a finger is elsewhere on the time line, near and far. */
async function scrub({ css, forMs }: { readonly css: string; readonly forMs: number }): Promise<void> {
  const rail = document.querySelector(css);
  if (rail === null) throw new Error('There is no time line.');
  rail.setPointerCapture = () => undefined; // no real pointer is down
  const { left, width, top } = rail.getBoundingClientRect();
  const send = (type: string, share: number): void => {
    const at = {
      clientX: left + share * width,
      clientY: top + 5,
      pointerId: 1,
      isPrimary: true,
      bubbles: true,
      buttons: 1,
    };
    rail.dispatchEvent(new PointerEvent(type, at));
  };
  const startMs = performance.now();
  send('pointerdown', 0.5);
  for (let moves = 1; performance.now() - startMs < forMs; moves++) {
    send('pointermove', moves % 10 === 0 ? (moves * 0.37) % 1 : 0.5 + 0.4 * Math.sin(moves / 40));
    await new Promise(requestAnimationFrame);
  }
  send('pointerup', 0.5);
}

/** How much work a moment of the past is for the page. */
export const scrubSubject: Subject<Stage> = {
  budgets: [{ what: 'a moment of the past, dragged along the time line, throttled 4x', budget: `<= ${SCRUB_MS} ms` }],
  measure: (stage) =>
    withPage(stage, { work: closedLine() }, async (opened) => {
      const { page, tools } = opened;
      await lookBackAfter(opened, SCRUBBED_US);
      await tools.send('Emulation.setCPUThrottlingRate', { rate: 4 });
      await tools.send('Performance.enable');
      const act = (on: Page): Promise<void> => on.evaluate(scrub, { css: RAIL, forMs: SCRUBS_MS });
      await act(page); // compiles it
      const { frames, thread } = await smoothness(opened, act);
      return [{ text: `${thread.text}, ${frames.text} frames a second`, met: thread.taskMs <= SCRUB_MS }];
    }),
};

/** How soon a run goes on from ten minutes back. */
export const goOnSubject: Subject<Stage> = {
  budgets: [{ what: 'going on from 10 simulated minutes', budget: `<= ${GO_ON_S} s` }],
  measure: (stage) =>
    withPage(stage, { work: closedLine() }, async (opened) => {
      const { page } = opened;
      await lookBackAfter(opened, FROM_US);
      const startMs = performance.now();
      await page.click('[data-testid=go-on]');
      await page.waitForSelector(HEAD, { state: 'detached' });
      const seconds = (performance.now() - startMs) / 1000;
      return [{ text: `${seconds.toFixed(1)} s`, met: seconds <= GO_ON_S }];
    }),
};
