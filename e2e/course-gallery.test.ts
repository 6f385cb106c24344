import { expect, test, type App } from './app';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { attribute, isThere, on, openApp, pasteProgram, programIn } from './page';
import { by, gone, until } from './parts';

const courseOf = (app: App): Promise<string | null> => attribute(app, 'header .course', 'aria-label');

const isAt = (app: App, css: string): Promise<boolean> =>
  app.evaluate((selector) => document.activeElement?.matches(selector) === true, css);

/** Goes on with Tab until the keyboard is at an element. */
async function tabTo(app: App, css: string): Promise<void> {
  for (let press = 0; press < 60 && !(await isAt(app, css)); press += 1) await app.press('Tab');
  expect(await isAt(app, css), css).toBe(true);
}

const cards = (app: App): Promise<number> => app.evaluate(() => document.querySelectorAll('.gallery li').length);

async function openGallery(app: App): Promise<void> {
  await app.click('header .course');
  await until(app, by('all-courses'));
  await app.click(by('all-courses'));
  await until(app, by('course-slalom'));
}

test(
  'the gallery by keyboard: a filter, a course’s page, its beginning in the editor; the work before is kept',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app, { language: 'en' });
    await pasteProgram(app, 'print("mine")');
    await openGallery(app);
    await expect.poll(() => isAt(app, '.gallery h2')).toBe(true); // a screen reader begins with the heading
    const all = await cards(app);
    expect(all).toBeGreaterThanOrEqual(19);
    await tabTo(app, by('filter-all'));
    for (let press = 0; press < 4; press += 1) await app.press('ArrowRight');
    await expect.poll(() => isAt(app, by('filter-obstacles'))).toBe(true);
    expect(await cards(app)).toBeLessThan(all);
    await tabTo(app, `${by('course-slalom')} a`);
    await app.press('Enter');
    await expect.poll(() => app.text('.gallery h2')).toBe('Slalom');
    await expect.poll(() => app.text('.gallery .sheet')).toContain('without touching any of them');
    await expect.poll(() => isAt(app, '.gallery h2')).toBe(true);
    await tabTo(app, by('open-slalom'));
    await app.press('Enter');
    await until(app, '.page-overlay .ctl--run');
    await app.click('.page-overlay .ctl--run'); // course and program
    await expect.poll(() => programIn(app)).toContain('Task: drive around the posts');
    await expect.poll(() => app.text('.notice')).toContain('Your work has been kept');
    await expect.poll(() => courseOf(app)).toContain('Slalom');

    await app.click('header .course');
    await until(app, by('previous'));
    await app.click(by('previous'));
    await expect.poll(() => programIn(app)).toBe('print("mine")');
  },
);

test('the solution shows on demand, and passes', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'en', speed: 'max' });
  await app.goto('./#courses/push');
  await until(app, by('show-solution'));
  expect(await app.evaluate(() => document.querySelector('details')?.open)).toBe(false);
  await app.click(by('show-solution'));
  expect(await app.text('details pre')).toContain('irLeft.read_digital()');
  await app.click(by('open-solved'));
  await gone(app, '.gallery');
  await expect.poll(() => programIn(app)).toContain('the block stays where it is');
  await app.click(on('run'));
  await expect.poll(() => app.text(by('verdict')), { timeout: 30_000 }).toContain('Well done!');
});

test('a number makes the same maze for everyone: typed, changed and opened', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app, { language: 'en' });
  await app.click('header .course');
  await until(app, by('all-courses'));
  await app.click(by('all-courses'));
  await until(app, by('random-maze'));
  await app.click(`${by('random-maze')} h3 a`);
  await until(app, by('random-seed'));
  await app.click(by('random-new'));
  await app.fill(by('random-seed'), '4711');
  await expect.poll(() => app.evaluate(() => location.hash)).toBe('#courses/maze-m-4711');
  await app.fill(by('random-seed'), 'x'); // no number: the last one stays, and nothing can be opened
  await expect.poll(() => attribute(app, by('random-seed'), 'aria-invalid')).toBe('true');
  expect(await app.evaluate(() => location.hash)).toBe('#courses/maze-m-4711');
  expect(await attribute(app, by('open-maze-m-4711'), 'disabled')).not.toBeNull();
  await app.fill(by('random-seed'), '4711');
  await expect.poll(() => attribute(app, by('open-maze-m-4711'), 'disabled')).toBeNull();
  await app.click(by('open-maze-m-4711'));
  await gone(app, '.gallery');
  await expect.poll(() => courseOf(app)).toContain('Maze 4711, medium');
  await expect.poll(() => programIn(app)).toContain('Maze with the left hand');
  expect(await isThere(app, by('misplugged'))).toBe(false);
});

for (const theme of ['light', 'dark'] as const)
  test(
    `axe finds nothing that shuts people out of the gallery of courses, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { theme });
      await app.goto('./#courses');
      await until(app, by('course-slalom'));
      expect(await violationsOn(app), 'with all courses').toEqual([]);
      await app.goto('./#courses/track-m-4711');
      await until(app, by('show-solution'));
      await app.click(by('show-solution'));
      expect(await violationsOn(app), 'with a random one').toEqual([]);
    },
  );
