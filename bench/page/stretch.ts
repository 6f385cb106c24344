import type { CDPSession, Page } from '@playwright/test';
import { median, repeat } from '../subject';
import type { Opened } from './stage';

const ROUNDS = 3;
/** Half a frame a second is measuring error. */
export const FRAMES_PER_SECOND = 59.5;
/** Most of a frame that may be the page's own work, in ms. */
export const FRAME_MS = 10;

/** Counts over a stretch of time. */
export interface Stretch {
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

/** Measures three times while something goes on; the middle ones count. Returns figures for frames a second and ms a frame. */
export async function smoothness(opened: Opened, act: (page: Page) => Promise<void>, mostMs = FRAME_MS) {
  const stretches = await repeat(ROUNDS, () => stretch(opened, act));
  const of = (key: keyof Stretch): number => median(stretches.map((measured) => measured[key]));
  const rate = of('framesPerSecond');
  const taskMs = of('taskMs');
  const longest = `longest gap ${of('gapMs').toFixed(0)} ms`;
  return {
    frames: { text: rate.toFixed(1), longest, pictures: of('pictures'), met: rate >= FRAMES_PER_SECOND },
    thread: {
      text: `${taskMs.toFixed(1)} ms in tasks (TaskDuration; ThreadTime ${of('threadMs').toFixed(1)} ms)`,
      taskMs,
      met: taskMs <= mostMs,
    },
  };
}

/** Counts while something goes on. */
export async function stretch({ page, tools }: Opened, act: (page: Page) => Promise<void>): Promise<Stretch> {
  const first = await state(page, tools);
  await page.evaluate(() => (window.bench.frames = []));
  await act(page);
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
