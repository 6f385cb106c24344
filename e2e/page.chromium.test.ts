import { expect, test } from '@playwright/test';
import { on } from './page';

const PROGRAM_MS = 1_000;

test('a visit with a run asks nobody but the own host, and the page has nothing to complain about', async ({
  page,
  baseURL,
}) => {
  const complaints: string[] = [];
  const strangers: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!request.url().startsWith(baseURL ?? '')) strangers.push(request.url());
  });
  await page.goto('./');
  await page.click(on('run'));
  await page.waitForTimeout(PROGRAM_MS);
  await page.click(on('stop'));
  await expect(page.locator(on('stop'))).toBeDisabled();
  expect(complaints).toEqual([]);
  expect(strangers).toEqual([]);
});
