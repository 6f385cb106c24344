import type { Page } from '@playwright/test';
import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { fitView } from '../../src/web/pupil/arena/view/view-transform';
import { aThingAt, FULL, fullCourse, SIZE } from '../full-course';
import { median, repeat, type Subject } from '../subject';
import { WARM_UP_MS } from './frames';
import { pasteProgram, until, untilMoving, untilUsable, withPage, type Stage } from './stage';
import { smoothness } from './stretch';
import { PLACES } from './watch';

const DRIVE_MS = 3_000;
/** Interval at which a pen reports its place, in ms. */
const PEN_MS = 8;
const PEN_STEPS = 375; // 3 s

/** The page shows it when the course is open. */
const NAME = 'Full to the brim';

const CIRCLE = 'from mbrobot import *\nwhile True:\n    rightArc(0.2)\n    delay(100)';

const MUCH = `${String(FULL.objects)} objects and ${FULL.points.toLocaleString('en')} points, no GPU, throttled 4x`;

/** How smoothly one draws in a full course, and the robot drives in it. */
export const editingSubject: Subject<Stage> = {
  budgets: [
    { what: `drawing, ${MUCH}: frames`, budget: '60 a second' },
    { what: `drawing, ${MUCH}: the page's thread per frame`, budget: '<= 10 ms' },
    { what: `driving, ${MUCH}: frames`, budget: '60 a second' },
    { what: `driving, ${MUCH}: the page's thread per frame`, budget: '<= 10 ms' },
  ],
  measure: (stage) =>
    withPage(stage, { throttle: 4 }, async (opened) => {
      const { page, tools } = opened;
      await untilUsable(page);
      await pasteProgram(page, CIRCLE);
      await openCourse(page, { ...fullCourse(defaultScene()), name: NAME });
      await page.click(PLACES.build);
      await page.click(PLACES.pen);
      await tools.send('Performance.enable');
      await scribble(page); // the tools' code comes with the first stroke
      const drawing = await smoothness(opened, scribble);
      await page.click(PLACES.run);
      await untilMoving(page);
      await page.waitForTimeout(WARM_UP_MS);
      const driving = await smoothness(opened, () => page.waitForTimeout(DRIVE_MS));
      return [drawing, driving].flatMap(({ frames, thread }) => [
        { text: `${frames.text} (${frames.longest})`, met: frames.met },
        thread,
      ]);
    }),
};

/** Drops a course file onto the page, as out of a folder. */
async function openCourse(page: Page, course: Scene): Promise<void> {
  await page.evaluate((file) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([file], 'full.json'));
    for (const type of ['dragenter', 'dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
  }, serializeScene(course));
  await until(page, (name) => document.body.innerText.includes(name), NAME);
}

/** One long stroke all over the arena. */
async function scribble(page: Page): Promise<void> {
  const box = await page.locator(PLACES.arena).boundingBox();
  if (box === null) throw new Error('There is no arena.');
  const at = (i: number): readonly [number, number] => [
    box.x + box.width * (0.5 + 0.38 * Math.cos(i * 0.11)),
    box.y + box.height * (0.5 + 0.38 * Math.sin(i * 0.143)),
  ];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let i = 1; i < PEN_STEPS; i += 1) await Promise.all([page.mouse.move(...at(i)), page.waitForTimeout(PEN_MS)]);
  await page.mouse.up();
}

const ALL_OF = 'all of 500 objects and 5,000 points selected, no GPU';

/** How smoothly everything in a full course is moved: by arrow keys, by dragging, and back. */
const movingAt = (throttle: number, budgetMs: number): Subject<Stage> => {
  const where = throttle === 1 ? ALL_OF : `${ALL_OF}, throttled ${String(throttle)}x`;
  return {
    budgets: [
      { what: `arrow keys, ${where}: a picture`, budget: `<= ${String(budgetMs)} ms` },
      { what: `dragging, ${where}: a picture`, budget: `<= ${String(budgetMs)} ms` },
      ...(throttle === 1 ? [{ what: `undo, ${where}`, budget: `<= ${String(UNDO_MS)} ms` }] : []),
    ],
    measure: (stage) =>
      withPage(stage, { throttle }, async (opened) => {
        const { page, tools } = opened;
        await untilUsable(page);
        await openCourse(page, { ...fullCourse(defaultScene(), FEWER_POINTS), name: NAME });
        await tools.send('Performance.enable');
        await selectAll(page);
        await nudge(page); // the first picture of all is painted
        const figures = [await smoothness(opened, nudge), await smoothness(opened, dragAll)].map(
          ({ thread, frames }) => ({
            text: `${thread.text}, ${frames.text} a second (${frames.longest})`,
            met: thread.taskMs <= budgetMs,
          }),
        );
        if (throttle > 1) return figures;
        const undoMs = median(await repeat(UNDOS, () => undoTime(page)));
        return [...figures, { text: `${undoMs.toFixed(0)} ms to the picture`, met: undoMs <= UNDO_MS }];
      }),
  };
};

const FEWER_POINTS = 5_000;
const UNDO_MS = 50;
const UNDOS = 5;

/** The same at normal speed, and on a weak tablet. */
export const movingSubject = movingAt(1, 16);
export const slowMovingSubject = movingAt(4, 33);

/** Selects everything, as soon as the tools have come. */
async function selectAll(page: Page): Promise<void> {
  await page.click(PLACES.build);
  await page.click(PLACES.select);
  await until(page, (arena) => document.querySelector<HTMLElement>(arena)?.style.cursor !== 'progress', PLACES.arena);
  await page.focus(PLACES.arena);
  await page.keyboard.press('Control+a');
  await until(page, (bin) => document.querySelector(bin) !== null, PLACES.bin);
}

/** An arrow key that is held for a second, and another one back. */
async function nudge(page: Page): Promise<void> {
  for (const key of ['ArrowRight', 'ArrowLeft']) {
    for (let i = 0; i < 30; i += 1) {
      await page.keyboard.down(key);
      await page.waitForTimeout(33); // as fast as a held key repeats
    }
    await page.keyboard.up(key);
  }
}

/** Everything is dragged to and fro; it begins on one of the things. */
async function dragAll(page: Page): Promise<void> {
  const box = await page.locator(PLACES.arena).boundingBox();
  if (box === null) throw new Error('There is no arena.');
  const { pxPerMm, leftPx, bottomPx } = fitView(SIZE, { widthPx: box.width, heightPx: box.height });
  const [x, y] = [box.x + leftPx + aThingAt[0] * pxPerMm, box.y + bottomPx - aThingAt[1] * pxPerMm];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 120; i += 1) {
    const far = 60 * Math.sin(i * 0.1);
    await Promise.all([page.mouse.move(x + far, y + far / 2), page.waitForTimeout(PEN_MS)]);
  }
  await page.mouse.up();
}

/** From the key until the next frame has been painted. */
const undoTime = (page: Page): Promise<number> =>
  page.evaluate(
    (arena) =>
      new Promise<number>((done) => {
        const from = performance.now();
        const key = { key: 'z', ctrlKey: true, bubbles: true, cancelable: true };
        document.querySelector(arena)?.dispatchEvent(new KeyboardEvent('keydown', key));
        requestAnimationFrame(() => setTimeout(() => done(performance.now() - from)));
      }),
    PLACES.arena,
  );
