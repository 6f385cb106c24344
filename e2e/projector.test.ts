import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { withKeys } from './keys';
import { openApp } from './page';
import { by, gone, until } from './parts';
import { mainMenu } from './pupil';

/** True if task and timer lie on the course. */
const coversCourse = (app: App): Promise<boolean> =>
  app.evaluate(
    ([side = '', floor = '']) => {
      const [a, b] = [side, floor].map((css) => document.querySelector(css)?.getBoundingClientRect());
      if (a === undefined || b === undefined) return true;
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      return width > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
    },
    [by('projector'), '.pane-arena .floor'],
  );

/** Opens the view out of the page for teachers. */
async function openProjector(app: App): Promise<void> {
  await mainMenu(app, 'teachers');
  await until(app, by('menu-projector'));
  await app.click(by('menu-projector'));
}

/** Seconds that the timer shows. */
async function secondsLeft(app: App): Promise<number> {
  const [minutes = NaN, seconds = NaN] = (await app.text(by('timer'))).split(':').map(Number);
  return 60 * minutes + seconds;
}

test(
  'a teacher shows a task on the projector without a mouse, with timer and verdict',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { welcomed: true, language: 'de', speed: 'max' });
    const keys = withKeys(app).app;
    await openProjector(keys);
    await until(app, by('projector'));

    expect(await app.text(`${by('projector')} h2`)).toBe('Geschlossene Linie');
    expect(await app.text(by('projector-text'))).toContain('Folge der Linie');
    expect(await app.text(`${by('projector')} .goals`)).toContain('Fahr dann ins Ziel');
    await expect.poll(() => coversCourse(app)).toBe(false);
    expect(await violationsOn(app)).toEqual([]);

    await app.press('t');
    await expect.poll(() => secondsLeft(app)).toBeLessThan(599);

    await app.press('Space');
    await expect.poll(() => app.text(by('run-clock'))).not.toBe('0:00.0');
    await until(app, `${by('projector-result')}[data-state=passed]`);
    const word = await app.evaluate((css) => {
      const found = document.querySelector<HTMLElement>(css);
      const box = found?.getBoundingClientRect();
      const isInSight = box !== undefined && box.left >= 0 && box.right <= innerWidth && box.bottom <= innerHeight;
      return {
        text: found?.innerText.trim(),
        isInSight,
        px: parseFloat(found ? getComputedStyle(found).fontSize : '0'),
      };
    }, by('projector-word'));
    expect(word).toMatchObject({ text: 'Geschafft!', isInSight: true });
    expect(word.px).toBeGreaterThanOrEqual(40);
    expect(await app.text(`${by('projector')} .goals .ok:last-child`)).toContain('Fahr dann ins Ziel');
    expect(await coversCourse(app)).toBe(false);
    expect(await violationsOn(app)).toEqual([]);

    await app.press('Escape');
    await gone(app, by('projector'));
    expect(await app.evaluate(() => document.documentElement.classList.contains('arena-alone'))).toBe(false);

    const before = await app.evaluate(() => Date.now());
    await openProjector(keys);
    await until(app, by('timer'));
    // It has gone on while nobody saw it.
    expect(await secondsLeft(app)).toBeLessThan(599);
    await app.reload();
    await until(app, by('menu'));
    await openProjector(keys);
    await until(app, by('timer'));
    const passed = ((await app.evaluate(() => Date.now())) - before) / 1000;
    expect(await secondsLeft(app)).toBeLessThanOrEqual(Math.ceil(600 - passed));
  },
);

test.describe(() => {
  test.use({ viewport: { width: 820, height: 1180 } });

  test(
    'on a tablet held upright task, verdict and goals are shown whole above the course',
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { welcomed: true, language: 'de', speed: 'max' });
      await openProjector(app);
      await until(app, by('projector-text'));
      /** Elements that are cut off: they could be scrolled, which does not happen at a projector. */
      const cut = (): Promise<readonly string[]> =>
        app.evaluate(
          (css) =>
            [...document.querySelectorAll(`${css} header, ${css} .says, ${css} .goals-place`)].flatMap((part) =>
              part.scrollHeight > part.clientHeight + 1 ? [part.className || part.tagName] : [],
            ),
          by('projector'),
        );
      await expect.poll(cut).toEqual([]);
      await app.press('Space');
      await until(app, `${by('projector-result')}[data-state=passed]`);
      await expect.poll(cut).toEqual([]);
    },
  );
});
