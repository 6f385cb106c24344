import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { openApp, programIn, typeProgram } from './page';

const seen = (app: App, css: string): Promise<string | null> =>
  app.evaluate((selector) => document.querySelector(selector)?.textContent ?? null, css);
const labels = (app: App): Promise<string[]> =>
  app.evaluate(() =>
    Array.from(document.querySelectorAll('[role=listbox] .cm-completionLabel'), (label) => label.textContent),
  );

test('suggestions: the dot opens them, Enter takes one with its brackets, a hint names the arguments', async ({
  app,
}) => {
  await openApp(app);
  await typeProgram(app, 'from microbit import *');
  await app.press('Enter');
  await app.type('display.');
  await expect.poll(() => labels(app)).toContain('set_pixel');
  await app.type('sc');
  await expect.poll(() => labels(app)).toEqual(['scroll']);
  await expect.poll(() => seen(app, '.cm-completionInfo')).toContain('150');
  await app.press('Enter');
  await expect.poll(() => programIn(app)).toBe('from microbit import *\ndisplay.scroll()');
  await expect.poll(() => seen(app, '.cm-helpHint mark')).toContain('text');
  // Brackets typed out of habit are there only once.
  await app.type('("Hi", ');
  await expect.poll(() => seen(app, '.cm-helpHint mark')).toContain('delay');
  await app.press('Escape');
  await expect.poll(() => seen(app, '.cm-helpHint')).toBeNull();
  await app.type('80)');
  await expect.poll(() => programIn(app)).toBe('from microbit import *\ndisplay.scroll("Hi", 80)');
});

test('the word at the cursor is explained by a key, and Escape closes the card', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await typeProgram(app, 'import music\nmusic.pitch(440)');
  await app.press('Home');
  for (let step = 0; step < 8; step += 1) await app.press('ArrowRight');
  await app.press('Control', 'Shift', 'Space');
  await expect.poll(() => seen(app, '.cm-helpCard')).toMatch(/^pitch\(frequency: int.*music/);
  await app.press('Escape');
  await expect.poll(() => seen(app, '.cm-helpCard')).toBeNull();
});

test(
  'suggestions still on their way do not open over the page once the pupil has left the program',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await openApp(app);
    await app.click('.code-editor .cm-scroller');
    // From the letter on 15 ms, which is shorter than the editor waits for the next one.
    await app.evaluate(() => {
      addEventListener('input', () => setTimeout(() => (document.activeElement as HTMLElement).blur(), 15), {
        once: true,
      });
    });
    await app.type('d');
    await app.evaluate(() => new Promise((resolve) => setTimeout(resolve, 800)));
    expect(await labels(app)).toEqual([]);
  },
);
