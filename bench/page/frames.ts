import type { Subject } from '../subject';
import { untilMoving, withPage, type Stage } from './stage';
import { smoothness } from './stretch';

const STRETCH_MS = 3_000;
/** The beginning of a run, in ms, when code is still being compiled: not measured. */
export const WARM_UP_MS = 1_500;

/** How smoothly the robot drives. */
export const framesSubject: Subject<Stage> = {
  budgets: [
    { what: 'driving, no GPU, throttled 4x: frames', budget: '60 a second' },
    { what: "driving, no GPU, throttled 4x: the page's thread per frame", budget: '<= 13 ms' },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4, pressRun: true }, async (opened) => {
      await untilMoving(opened.page);
      await opened.tools.send('Performance.enable');
      await opened.page.waitForTimeout(WARM_UP_MS);
      const { frames, thread } = await smoothness(opened, (page) => page.waitForTimeout(STRETCH_MS));
      const { text, longest, pictures, met } = frames;
      return [{ text: `${text} (${pictures.toFixed(0)} new pictures, ${longest})`, met }, thread];
    }),
};
