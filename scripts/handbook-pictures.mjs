// The pictures of the handbook: where they lie, and how they are taken of the real page (npm run handbook -- --pictures).
import { mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { note, root } from './progress.mjs';

const FOLDER = join(root, 'src/web/help/handbook');

/** The folder of the pictures. */
export const PICTURES = join(FOLDER, 'pictures');

/**
 * The name of the picture of a place in a language.
 *
 * @param {string} place a page's address without `#`, or `@` and a mode of the arena
 * @param {string} language
 */
export const pictureName = (place, language) => `${language}-${place.replace(/^@/, '').replaceAll('/', '-')}.webp`;

/** The course that is open in the pictures: it has a line, a goal, and a task. */
const OPEN = '?task=closed-line';
/** Long enough for a page to come and for its pictures to be drawn. */
const DRAWN_MS = 2_500;

/**
 * In the page: a screenshot as WebP, which browsers write and the screenshot command does not.
 *
 * @param {string} png base64
 */
const packed = (png) => `(async () => {
  const picture = Object.assign(new Image(), { src: 'data:image/png;base64,${png}' });
  await picture.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
  canvas.getContext('2d').drawImage(picture, 0, 0);
  return canvas.toDataURL('image/webp', 0.72).split(',')[1];
})()`;

/**
 * Fills the pages for a class, which say little without one: three hand-ins of the open course, and the class of a kept file.
 *
 * @type {Record<string, (page: import('@playwright/test').Page) => Promise<void>>}
 */
const FILLED = {
  class: async (page) => {
    await page.selectOption('[data-testid="class-task"]', 'closed-line');
    const solution = await readFile(join(root, 'courses/closed-line/main.py'));
    const programs = {
      'Ada Meier': solution,
      'Elif Kaya': Buffer.from('from mbrobot import *\nsetSpeed(40)\nforward()\ndelay(3000)\nstop()\n'),
      'Noah Frei': Buffer.from('from mbrobot import *\n'),
    };
    const files = Object.entries(programs).map(([name, buffer]) => ({
      name: `${name}.py`,
      mimeType: 'text/x-python',
      buffer,
    }));
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('[data-testid="class-files"]')]);
    await chooser.setFiles(files);
    await page.waitForSelector('text="Noah Frei"');
    await page.waitForTimeout(CHECKED_MS);
    await page.click('text="Elif Kaya"');
  },
  classes: async (page) => {
    await page.setInputFiles('[data-testid="classes-file"]', join(root, 'src/school-class/kept/v1.json'));
  },
};
/** Long enough for three hand-ins to be checked. */
const CHECKED_MS = 10_000;

/** The places that the handbook shows; they are the same in every language. */
async function places() {
  const text = await readFile(join(FOLDER, 'texts/de.md'), 'utf8');
  return [...new Set(Array.from(text.matchAll(/^show: (\S+)$/gm), ([, place]) => place))];
}

/**
 * Takes all pictures in one language anew.
 *
 * @param {import('@playwright/test').BrowserContext} context with the language and size of the pictures
 * @param {string} url
 * @param {string} language
 */
async function takeIn(context, url, language) {
  const blank = await context.newPage();
  let bytes = 0;
  for (const place of await places()) {
    const page = await context.newPage();
    await page.goto(place.startsWith('@') ? `${url}${OPEN}` : `${url}${OPEN}#${place}`);
    await page.waitForLoadState('networkidle');
    if (place.startsWith('@')) await page.click(`[data-testid="mode-${place.slice(1)}"]`);
    await FILLED[place]?.(page);
    await page.waitForTimeout(DRAWN_MS);
    const picture = await blank.evaluate(packed((await page.screenshot()).toString('base64')));
    await page.close();
    const content = Buffer.from(/** @type {string} */ (picture), 'base64');
    await writeFile(join(PICTURES, pictureName(place, language)), content);
    bytes += content.length;
  }
  note(`pictures in ${language}: ${Math.round(bytes / 1000)} kB`);
}

/**
 * Takes all pictures anew.
 *
 * @param {(language: string) => Promise<import('@playwright/test').BrowserContext>} open
 * @param {string} url
 * @param {readonly string[]} languages
 */
export async function takePictures(open, url, languages) {
  await rm(PICTURES, { recursive: true, force: true });
  await mkdir(PICTURES, { recursive: true });
  for (const language of languages) {
    const context = await open(language);
    await takeIn(context, url, language);
    await context.close();
  }
}
