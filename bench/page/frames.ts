import type { Subject } from '../subject';
import { untilKept, untilMoving, withPage, type Stage } from './stage';
import { smoothness } from './stretch';

const STRETCH_MS = 3_000;
/** The beginning of a run, in ms, when code is still being compiled: not measured. */
export const WARM_UP_MS = 1_500;

const DRIVING = 'driving, no GPU, throttled 4x';

/** How smoothly the robot drives: while the files for later visits still come, and when all have come. */
export const framesSubject: Subject<Stage> = {
  budgets: [
    { what: `${DRIVING}: frames`, budget: '60 a second' },
    { what: `${DRIVING}: the page's thread per frame`, budget: '<= 10 ms' },
    { what: `${DRIVING}, all files kept: frames`, budget: '60 a second' },
    { what: `${DRIVING}, all files kept: the page's thread per frame`, budget: '<= 10 ms' },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4, pressRun: true, withLine: true }, async (opened) => {
      const { page, tools } = opened;
      await untilMoving(page);
      await tools.send('Performance.enable');
      await page.waitForTimeout(WARM_UP_MS);
      const first = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS));
      await untilKept(page);
      const later = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS));
      return [first, later].flatMap(({ frames, thread }) => {
        const { text, longest, pictures, met } = frames;
        return [{ text: `${text} (${pictures.toFixed(0)} new pictures, ${longest})`, met }, thread];
      });
    }),
};
