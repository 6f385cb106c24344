import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { LANGUAGES, type Language } from '../src/core/languages';
import { localeOf } from '../src/web/kit/i18n/locale';
import { expect, test } from './app';
import { driveFirst, passFirstCourse, shareIt, takeTour, writeFirstProgram, type Beginner } from './first-hour';
import { programIn } from './page';
import { until } from './parts';
import { tablet, withFingers } from './touch';
import { wordsOfOthers } from './words-in-sight';

/** The steps of docs/first-hour.md. */
const SHOWN: readonly string[] = ['tour', 'board', 'drive', 'course', 'share'];

/** `npm run screenshots` keeps pictures, in this folder; `PARCOURS_PICTURES_OF=all` those of every look. */
const FOLDER = process.env['PARCOURS_PICTURES'];
const isKept = (name: string): boolean =>
  FOLDER !== undefined && (process.env['PARCOURS_PICTURES_OF'] === 'all' || SHOWN.includes(name));

/** The verdict's words in a language when a course is passed. */
function passedIn(language: Language): string {
  const words = new URL(`../src/web/kit/words/${language}.json`, import.meta.url);
  return (JSON.parse(readFileSync(words, 'utf8')) as { readonly verdict: { readonly passed: string } }).verdict.passed;
}

async function beginnerAt(page: Page, language: Language): Promise<Beginner> {
  const { app } = await withFingers(page);
  return {
    app,
    language,
    keyboard: { write: (text) => page.keyboard.insertText(text), strike: (key) => page.keyboard.press(key) },
    async look(name) {
      if (isKept(name)) {
        await page.waitForTimeout(700); // what slides and fades has come to rest
        const path = `${FOLDER ?? ''}/first-hour-${language}-${name}.jpg`;
        await page.screenshot({ path, type: 'jpeg', quality: 70, animations: 'disabled' });
      }
      expect.soft(await wordsOfOthers(app, language), `other languages at “${name}”`).toEqual([]);
      expect(await app.evaluate(() => document.documentElement.lang)).toBe(localeOf(language));
    },
  };
}

for (const language of LANGUAGES)
  test.describe(`with a tablet whose browser speaks ${localeOf(language)}`, () => {
    const locale = localeOf(language);
    test.use({ ...tablet, locale });
    test(`the first hour: tour, first program, first drive, first course, a link, ${language}`, async ({
      page,
      browser,
      baseURL,
    }) => {
      test.slow();
      const beginner = await beginnerAt(page, language);
      await takeTour(beginner);
      await writeFirstProgram(beginner);
      await driveFirst(beginner);
      const words = new URL(`../courses/square/words/${language}.json`, import.meta.url);
      const { name, task } = JSON.parse(readFileSync(words, 'utf8')) as Record<'name' | 'task', string>;
      await passFirstCourse(beginner, { task, passed: passedIn(language) });
      const link = await shareIt(beginner);
      const program = await programIn(beginner.app);

      const context = await browser.newContext({ ...tablet, locale, baseURL: baseURL ?? '' });
      const friend = await beginnerAt(await context.newPage(), language);
      await friend.app.goto(link);
      await until(friend.app, '[data-testid=course]');
      await expect.poll(() => programIn(friend.app)).toBe(program);
      expect(await friend.app.text('header')).toContain(name);
      await friend.look('link');
      await context.close();
    });
  });
