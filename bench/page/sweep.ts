import { openedCourse } from '../../e2e/opened-course';
import type { Subject } from '../subject';
import { until, untilUsable, withPage, type Stage } from './stage';
import { FRAMES_PER_SECOND, stretch } from './stretch';

const RUNS = 200;
const BUDGET_S = 12;

/** Reads a sensor and decides twenty times a second, for ten seconds. Its second line is what varies. */
const PROGRAM = `from mbrobot import *
number = 1
setSpeed(30)
for _ in range(200):
    if irLeft.read_digital() == 1: forward()
    else: left()
    delay(50)
stop()
`;

/** How long a sweep takes in the page, and whether the page is smooth meanwhile. */
export const sweepSubject: Subject<Stage> = {
  budgets: [
    { what: `a sweep of ${RUNS} runs of 10 s on the page`, budget: `<= ${BUDGET_S} s` },
    { what: 'pictures a second of the page during a sweep', budget: `>= ${FRAMES_PER_SECOND}` },
  ],
  measure: (stage) =>
    withPage(stage, { work: work() }, async (opened) => {
      const { page } = opened;
      await untilUsable(page);
      await page.goto(`${stage.url}#lab/main.py:2`);
      for (const [field, value] of [
        ['from', 1],
        ['to', RUNS],
        ['step', 1],
      ] as const) {
        const input = page.locator(`[data-testid=lab-${field}] input`).first();
        await input.fill(String(value));
        await input.press('Tab');
      }
      const go = page.locator('[data-testid=lab-go]');
      if (!(await go.innerText()).includes(String(RUNS))) throw new Error(`The form says "${await go.innerText()}".`);
      let seconds = 0;
      const { framesPerSecond, gapMs } = await stretch(opened, async () => {
        const fromMs = performance.now();
        await go.click();
        await until(page, () => document.querySelector('[data-testid=lab-again]') !== null, null);
        seconds = (performance.now() - fromMs) / 1000;
      });
      return [
        { text: `${seconds.toFixed(1)} s`, met: seconds <= BUDGET_S },
        {
          text: `${framesPerSecond.toFixed(1)}, longest gap ${gapMs.toFixed(0)} ms`,
          met: framesPerSecond >= FRAMES_PER_SECOND,
        },
      ];
    }),
};

function work(): string {
  const opened = JSON.parse(openedCourse('empty')) as { project: object };
  return JSON.stringify({ ...opened, project: { ...opened.project, files: [{ name: 'main.py', text: PROGRAM }] } });
}
