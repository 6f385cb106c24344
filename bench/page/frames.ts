import type { CDPSession, Page } from '@playwright/test';
import { median, repeat, type Subject } from '../subject';
import { untilMoving, withPage, type Opened, type Stage } from './stage';

const ROUNDS = 3;
const STRETCH_MS = 3_000;
/** The beginning of a run, in ms, when code is still being compiled: not measured. */
const WARM_UP_MS = 1_500;
/** Half a frame a second is measuring error. */
const BUDGET = { framesPerSecond: 59.5, msPerFrame: 13 };

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
      const stretches = await repeat(ROUNDS, () => drive(opened));
      const of = (key: keyof Stretch): number => median(stretches.map((stretch) => stretch[key]));
      const rate = of('framesPerSecond');
      const taskMs = of('taskMs');
      return [
        {
          text: `${rate.toFixed(1)} (${of('pictures').toFixed(0)} new pictures, longest gap ${of('gapMs').toFixed(0)} ms)`,
          met: rate >= BUDGET.framesPerSecond,
        },
        {
          text: `${taskMs.toFixed(1)} ms in tasks (TaskDuration; ThreadTime ${of('threadMs').toFixed(1)} ms)`,
          met: taskMs <= BUDGET.msPerFrame,
        },
      ];
    }),
};

interface Stretch {
  readonly framesPerSecond: number;
  /** Different pictures of the run that came, a second. */
  readonly pictures: number;
  /** Longest time between two frames, in ms. */
  readonly gapMs: number;
  /** Wall time in tasks of the page's thread, in ms a frame. */
  readonly taskMs: number;
  /** Processor time of the whole thread, in ms a frame: without what other programs took, with the throttle's own waiting. */
  readonly threadMs: number;
}

async function drive({ page, tools }: Opened): Promise<Stretch> {
  const first = await state(page, tools);
  await page.evaluate(() => (window.bench.frames = []));
  await page.waitForTimeout(STRETCH_MS);
  const frames = await page.evaluate(() => window.bench.frames);
  const last = await state(page, tools);
  const seconds = ((frames.at(-1) ?? NaN) - (frames[0] ?? NaN)) / 1000;
  const gaps = frames.slice(1).map((ms, place) => ms - (frames[place] ?? ms));
  return {
    framesPerSecond: (frames.length - 1) / seconds,
    pictures: (last.snapshots - first.snapshots) / (last.timestampS - first.timestampS),
    gapMs: Math.max(...gaps),
    taskMs: (1000 * (last.taskS - first.taskS)) / frames.length,
    threadMs: (1000 * (last.threadS - first.threadS)) / frames.length,
  };
}

async function state(page: Page, tools: CDPSession) {
  const snapshots = await page.evaluate(() => window.bench.snapshots);
  const { metrics } = await tools.send('Performance.getMetrics');
  const metric = (wanted: string): number => metrics.find(({ name }) => name === wanted)?.value ?? NaN;
  return {
    snapshots,
    timestampS: metric('Timestamp'),
    taskS: metric('TaskDuration'),
    threadS: metric('ThreadTime'),
  };
}
