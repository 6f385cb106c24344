import type { Page } from '@playwright/test';

import { linkOf } from '../src/project/link/link';
import { defaultScene, type Scene } from '../src/scene/scene';
import type { Language } from '../src/core/languages';
import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { on } from './page';
import { by } from './parts';

const zone = { size: [100, 100], angle: 0, round: false, blocks: 0 } as const;

/** Straight ahead of the robot: a line across its way, a checkpoint and a wall. A target lies aside. */
const course: Scene = {
  ...defaultScene(),
  robot: { ...defaultScene().robot, at: [150, 450] },
  objects: [
    {
      type: 'stroke',
      id: 'line',
      width: 20,
      color: 'black',
      points: [
        [330, 200],
        [330, 700],
      ],
    },
    { type: 'wall', id: 'wall', from: [1000, 100], to: [1000, 800], thickness: 10 },
    { type: 'checkpoint', id: 'two', at: [620, 450], number: 2, ...zone },
    { type: 'checkpoint', id: 'one', at: [440, 450], number: 1, ...zone },
    { type: 'target', id: 'target', at: [150, 800], number: 0, ...zone },
  ],
};

const PROGRAM = `from mbrobot import *
delay(2500)
setSpeed(20)
forward()
while getDistance() > 8:
    delay(20)
stop()
`;

/** Opens the course as somebody who has settings. */
async function open(page: Page, settings: object): Promise<void> {
  const files = [{ name: 'main.py', text: PROGRAM }];
  const made = linkOf({ files, scene: course, course: null }, { courses: () => null, program: true });
  await page.goto('./logo.svg');
  await page.evaluate((text) => localStorage.setItem('parcours.settings', text), JSON.stringify(settings));
  await page.goto(`./#${made?.fragment ?? ''}`);
  await expect(page.locator('.cm-content')).toContainText('delay(2500)'); // the link's, not that of the page before it
}

/** Notes when each sentence comes into a region. */
async function listen(page: Page, region: string): Promise<() => Promise<readonly { atMs: number; words: string }[]>> {
  await page.waitForSelector(by(region), { state: 'attached' });
  await page.evaluate((css) => {
    const heard: { atMs: number; words: string }[] = [];
    const region = document.querySelector(css);
    const note = (): void => void heard.push({ atMs: performance.now(), words: region?.textContent?.trim() ?? '' });
    if (region !== null) new MutationObserver(note).observe(region, { childList: true, subtree: true });
    Object.assign(window, { heard });
  }, by(region));
  return () => page.evaluate(() => (window as unknown as { heard: { atMs: number; words: string }[] }).heard);
}

/** In German; that the words are in the page's language is shown by `narrator.test.ts` and `explore.test.ts`. */
const DRIVE: readonly RegExp[] = [
  /^Start bei x 15, y 45 cm, Richtung 0 Grad\./,
  /^(Linker Sensor|Rechter Sensor|Beide Sensoren) auf der Linie\.$/,
  /^Kontrollpunkt 1 erreicht\.$/,
  /^Kontrollpunkt 2 erreicht\.$/,
  /^Wand \d+ cm voraus\.$/,
  /^Der Roboter steht: x \d+, y 45 cm, Richtung 0 Grad\. Wand \d cm voraus\.$/,
];

test('a drive is told one thing after the other', async ({ page }) => {
  await open(page, { language: 'de', welcomed: true, tell: true });
  const heard = await listen(page, 'narration');
  await page.click(on('run'));
  const last = DRIVE.at(-1) ?? /./;
  await expect.poll(async () => (await heard()).at(-1)?.words, { timeout: 40_000 }).toMatch(last);
  const all = await heard();
  let from = 0;
  for (const words of DRIVE) {
    const at = all.findIndex((one, i) => i >= from && words.test(one.words));
    expect(at, `${String(words)} in ${all.map((one) => one.words).join(' ')}`).toBeGreaterThanOrEqual(from);
    from = at + 1;
  }
  const told = all.filter(({ words }) => words !== '').slice(1); // the first one says that it is on
  const gaps = told.slice(1).map(({ atMs }, i) => atMs - (told[i]?.atMs ?? 0));
  expect(Math.min(...gaps)).toBeGreaterThan(1900);

  expect(await page.locator('body').ariaSnapshot()).toContain(`- status: "${all.at(-1)?.words ?? ''}"`);
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
});

const WALK = [
  'Der Roboter ist bei x 15, y 45 cm, Richtung 0 Grad. Im Parcours liegen 5 Dinge.',
  'Kontrollpunkt 1, 10 mal 10 cm: 29 cm weiter vorn.',
  'Kontrollpunkt 2, 10 mal 10 cm: 47 cm weiter vorn.',
  'Ziel 1, 10 mal 10 cm: 35 cm links.',
] as const;

test('the course is explored by keyboard and words', async ({ page }) => {
  await open(page, { language: 'de', welcomed: true });
  await page.focus(on('arena'));
  await expect(page.locator(on('arena'))).toHaveAccessibleDescription(/N nennt, was im Parcours liegt/);
  for (const words of WALK) {
    await page.keyboard.press('n');
    await expect(page.locator(by('explored'))).toHaveText(words);
  }
  await page.keyboard.press('Shift+N');
  await expect(page.locator(by('explored'))).toHaveText(WALK[2]);
  await page.keyboard.press('o');
  const around = page.getByRole('status').filter({ hasText: /Vorn Wand 1, 79 cm\. Links Rand/ });
  await expect(around).toHaveCount(1);
});

test('the telling is switched on by keyboard, says so and is remembered', async ({ page }) => {
  await open(page, { language: 'de' satisfies Language, welcomed: true });
  await page.focus(by('menu'));
  await page.keyboard.press('Enter');
  const item = page.getByRole('menuitemcheckbox', { name: /^Fahrt beschreiben/ });
  await expect(item).not.toBeChecked();
  for (let i = 0; i < 40 && !(await item.evaluate((it) => it === document.activeElement)); i += 1)
    await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter'); // which closes the menu
  await expect(item).toHaveCount(0);
  await expect(page.getByRole('status').filter({ hasText: 'Die Fahrt wird beschrieben.' })).toHaveCount(1);
  await page.focus(by('menu'));
  await page.keyboard.press('Enter');
  await expect(item).toBeChecked();
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  await page.reload();
  await expect(page.getByRole('status').filter({ hasText: 'Die Fahrt wird beschrieben.' })).toHaveCount(1);
});
