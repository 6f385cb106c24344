import { median, repeat, type Subject } from '../subject';
import { untilMoving, withPage, type Stage } from './stage';

const ROUNDS = 3;
const BUDGET_MS = { usable: 1_300, moving: 1_800 };

/** How soon a first visit gets somewhere. */
export const startSubject: Subject<Stage> = {
  budgets: [
    { what: 'page, cold cache, throttled 4x: editor usable', budget: '<= 1.3 s' },
    { what: 'page, cold cache, throttled 4x: first run moving', budget: '<= 1.8 s' },
  ],
  async measure(stage) {
    await visit(stage, 1); // the server compresses each file once, as a host does long before
    const visits = await repeat(ROUNDS, () => visit(stage, 4));
    const usableMs = median(visits.map((it) => it.usableMs));
    const movingMs = median(visits.map((it) => it.movingMs));
    return [
      { text: seconds(usableMs), met: usableMs <= BUDGET_MS.usable },
      { text: `${seconds(movingMs)} (Run pressed at once)`, met: movingMs <= BUDGET_MS.moving },
    ];
  },
};

const seconds = (ms: number): string => `${(ms / 1000).toFixed(2)} s`;

/** A first visit that presses Run as soon as the editor is usable; both times count from asking for the page. */
function visit(stage: Stage, throttle: number): Promise<{ usableMs: number; movingMs: number }> {
  return withPage(stage, { throttle, pressRun: true }, async ({ page }) => {
    await untilMoving(page);
    await page.waitForTimeout(200); // the frame with the move in it has been drawn
    return page.evaluate(() => ({
      usableMs: window.bench.usableMs ?? NaN,
      movingMs: window.bench.movingMs ?? NaN,
    }));
  });
}
