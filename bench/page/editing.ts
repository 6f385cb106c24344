import type { Page } from '@playwright/test';
import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { FULL, fullCourse } from '../full-course';
import type { Subject } from '../subject';
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
