import { readFileSync } from 'node:fs';
import { linkOf } from '../src/project/link/link';
import { defaultScene } from '../src/scene/scene';
import { expect, test, type App } from './app';
import { by, gone, until } from './parts';

const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');
const CREEP = `from mbrobot import *\nsetSpeed(20)\nforward()\nwhile True:\n    delay(100)\n`;

/** A line of an e-mail: who, and the link of a program. */
function line(name: string, text: string): string {
  const made = linkOf(
    { files: [{ name: 'main.py', text }], scene: defaultScene(), course: null },
    { courses: () => null, program: true },
  );
  return `${name}: https://example.org/#${made?.fragment ?? ''}`;
}

/** Pastes somewhere on the page, into no field. */
const paste = (app: App, text: string): Promise<void> =>
  app.evaluate((pasted) => {
    const event = new Event('paste', { bubbles: true, cancelable: true });
    const getData = (type: string) => (type === 'text/plain' ? pasted : '');
    Object.defineProperty(event, 'clipboardData', { value: { getData, files: [] } });
    document.body.dispatchEvent(event);
  }, text);

const select = (app: App, id: string, value: string): Promise<void> =>
  app.evaluate(
    (wish) => {
      const field = document.querySelector<HTMLSelectElement>(`[data-testid=${wish.id}]`)!;
      field.value = wish.value;
      field.dispatchEvent(new Event('change', { bubbles: true }));
    },
    { id, value },
  );

test('a wall fills with what is pasted while it is up, names only who has passed, and lets all drive once more', async ({
  app,
}) => {
  test.setTimeout(120_000);
  await app.goto('./logo.svg');
  await app.evaluate(() =>
    localStorage.setItem('parcours.settings', JSON.stringify({ language: 'de', welcomed: true })),
  );
  await app.goto('./#class');
  await until(app, by('class-task'));
  await select(app, 'class-task', 'closed-line');
  await app.click(by('class-open-wall'));
  await until(app, by('class-wall'));
  await paste(app, 'Guten Tag');
  await expect.poll(() => app.text(by('class-wall'))).toContain('In diesem Text ist kein Link zu einem Programm.');
  await paste(app, [line('Ada', RIGHT), line('Ben', CREEP)].join('\n'));
  await expect.poll(() => app.text(by('wall-sum')), { timeout: 60_000 }).toBe('1 von 2 bestanden');
  await paste(app, line('Cem', RIGHT));
  await expect.poll(() => app.text(by('wall-sum')), { timeout: 60_000 }).toBe('2 von 3 bestanden');
  const cards = async (): Promise<string> => (await app.text(by('wall-cards'))).replace(/\s+/g, ' ');
  await expect.poll(cards).toMatch(/^Ada bestanden 19\.5 s Cem bestanden 19\.5 s Nr\. [123] noch unterwegs$/);
  await select(app, 'wall-naming', 'all');
  await expect.poll(cards).toMatch(/^Ada .* Ben noch unterwegs Cem /);
  await select(app, 'wall-naming', 'none');
  await expect.poll(cards).not.toMatch(/Ada|Ben|Cem/);
  await select(app, 'wall-naming', 'passed');
  await app.click(by('wall-as-ways'));
  await expect.poll(() => app.text(by('wall-arrived'))).toMatch(/Ada\s*19\.5 s\s*Cem\s*19\.5 s/);
  const inked = (): Promise<number> =>
    app.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('canvas[data-testid=wall-ways]')!;
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, place) => place % 4 === 3 && value > 0).length;
    });
  const whole = await inked();
  await select(app, 'wall-speed', '0.5');
  await app.click(by('wall-play'));
  await expect.poll(inked).toBeLessThan(whole / 2);
  const early = await inked();
  await expect.poll(inked, { timeout: 20_000 }).toBeGreaterThan(early);
  await app.press('Escape');
  await gone(app, by('class-wall'));
  expect(await app.text(by('class-table'))).toContain('Ben');
});
