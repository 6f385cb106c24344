import { readFileSync } from 'node:fs';

import { handInCode } from '../src/check/hand-in/hand-in-code';
import { expect, warmTest as test } from './app';
import { classLink } from './class-link';
import { on } from './page';
import { by } from './parts';

test.use({ locale: 'de-CH' });

test('an exam begins by its button and ends by its clock: nothing is shared, and what is handed in has the code that was shown', async ({
  page,
}) => {
  const program = page.locator(on('editor'));
  await page.clock.install();
  await page.goto(classLink({ exam: { minutes: 10 } }));
  await page.click(by('exam-begin'));
  await expect(page.locator(by('exam-left'))).toContainText('Noch 9:');
  await expect(page.getByRole('button', { name: 'Teilen' })).toHaveCount(0);
  await page.goto('./#missions');
  await expect(page.locator(by('exam-left'))).toBeInViewport();
  await expect(page.getByRole('heading', { name: 'Missionen' })).toHaveCount(0);
  await program.click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('forward()');
  await expect(program).toContainText('forward()');

  await page.clock.fastForward(600_000);
  const code = page.locator(by('hand-in-code'));
  await expect(code).toHaveText(/^[A-Z2-9]{6}$/);
  await page.fill(by('hand-in-name'), 'Ada');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(by('hand-in-file'))]);
  const given = JSON.parse(readFileSync(await download.path(), 'utf8')) as Parameters<typeof handInCode>[0];
  expect(JSON.stringify(given)).toContain('forward()');
  await expect(code).toHaveText(handInCode(given));
  await page.keyboard.press('Escape');
  await program.click();
  await page.keyboard.type('# late');
  await expect(program).not.toContainText('late');
});
