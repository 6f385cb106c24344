import type { Page } from '@playwright/test';
import type { Subject } from '../subject';
import { closedLine, fourRobots, lidarRobot } from './kept-work';
import { untilKept, untilMoving, withPage, type Stage } from './stage';
import { FRAME_MS, smoothness } from './stretch';

const STRETCH_MS = 3_000;
/** The beginning of a run, in ms, when code is still being compiled: not measured. */
export const WARM_UP_MS = 1_500;

const DRIVING = 'driving, no GPU, throttled 4x';
/** A plain drive leaves half of a frame to a slow device. */
const DRIVING_MS = 8;

/** How smoothly the robot drives: while the files for later visits still come, and when all have come. */
export const framesSubject: Subject<Stage> = {
  budgets: [
    { what: `${DRIVING}: frames`, budget: '60 a second' },
    { what: `${DRIVING}: the page's thread per frame`, budget: `<= ${DRIVING_MS} ms` },
    { what: `${DRIVING}, all files kept: frames`, budget: '60 a second' },
    { what: `${DRIVING}, all files kept: the page's thread per frame`, budget: `<= ${DRIVING_MS} ms` },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4, pressRun: true, work: closedLine() }, async (opened) => {
      const { page, tools } = opened;
      await untilMoving(page);
      await tools.send('Performance.enable');
      await page.waitForTimeout(WARM_UP_MS);
      const first = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS), DRIVING_MS);
      await untilKept(page);
      const later = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS), DRIVING_MS);
      return [first, later].flatMap(({ frames, thread }) => {
        const { text, longest, pictures, met } = frames;
        return [{ text: `${text} (${pictures.toFixed(0)} new pictures, ${longest})`, met }, thread];
      });
    }),
};

const FAN = 'driving with the fan of a lidar shown, no GPU, throttled 4x';

/** How smoothly a robot drives whose lidar's fan is shown, with a number at each ray. */
export const fanSubject: Subject<Stage> = {
  budgets: [
    { what: `${FAN}: frames`, budget: '60 a second' },
    { what: `${FAN}: the page's thread per frame`, budget: `<= ${FRAME_MS} ms` },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4, pressRun: true, work: lidarRobot() }, async (opened) => {
      const { page, tools } = opened;
      await untilMoving(page);
      await tools.send('Performance.enable');
      await page.waitForTimeout(WARM_UP_MS);
      const { frames, thread } = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS));
      return [{ text: `${frames.text} (${frames.longest})`, met: frames.met }, thread];
    }),
};

const FOUR = 'four robots driving, no GPU, throttled 4x';

/** How smoothly four robots drive, and whether their time is that of the clock on the wall. */
export const fourRobotsSubject: Subject<Stage> = {
  budgets: [
    { what: `${FOUR}: frames`, budget: '60 a second' },
    { what: `${FOUR}: simulated time`, budget: '>= 0.99 of real time' },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4, pressRun: true, work: fourRobots() }, async (opened) => {
      const { page, tools } = opened;
      await untilMoving(page);
      await tools.send('Performance.enable');
      await page.waitForTimeout(WARM_UP_MS);
      const [from, fromMs] = [await simulatedMs(page), performance.now()];
      const { frames, thread } = await smoothness(opened, () => page.waitForTimeout(STRETCH_MS));
      const factor = ((await simulatedMs(page)) - from) / (performance.now() - fromMs);
      return [
        { text: `${frames.text} (${frames.longest}; ${thread.text})`, met: frames.met },
        { text: factor.toFixed(2), met: factor >= 0.99 },
      ];
    }),
};

/** Simulated time of the run, as the console's clock shows it to a tenth of a second. */
async function simulatedMs(page: Page): Promise<number> {
  const text = await page.locator('.pane-console .clock').innerText();
  const [, minutes = '', seconds = ''] = /(\d+):(\d+[.,]\d)/.exec(text) ?? [];
  return 60_000 * Number(minutes) + 1000 * Number(seconds.replace(',', '.'));
}
