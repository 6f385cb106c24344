import type { Page } from '@playwright/test';

import { microbitPage } from '../src/device-log/testing/microbit-page';
import { expect, playwrightApp, test as coldTest, warmTest as test } from './app';
import { violationsBy } from './axe';
import { on, openApp } from './page';
import { by } from './parts';
import { mainMenu } from './pupil';

const csv = 'Time (seconds),cm\n0.10,12.5\n0.20,11\n0.30,9\n';
const NAME = 'MY_DATA.HTM';
const WINDOW = by('device-log');

/** A file by the browser's own window for files, opened by this button. */
async function choose(page: Page, button: string, name: string, content: Uint8Array | string): Promise<void> {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click(button)]);
  await chooser.setFiles({ name, mimeType: 'text/html', buffer: Buffer.from(content) });
}

const open = (page: Page): Promise<void> => openApp(playwrightApp('chromium', page), { language: 'en' });

async function drop(page: Page, name: string, bytes: Uint8Array): Promise<void> {
  await page.evaluate(
    ({ file, base64 }) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (sign) => sign.charCodeAt(0))], file));
      for (const type of ['dragenter', 'dragover', 'drop'])
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
    },
    { file: name, base64: Buffer.from(bytes).toString('base64') },
  );
}

const charts = (page: Page) => page.locator(`${WINDOW} figure svg`);

async function logInSimulation(page: Page): Promise<void> {
  await page.click(on('editor'));
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('import log\nfor i in range(20): log.add(cm=i)\nprint("done")\n');
  await page.click(on('run'));
  await expect(page.locator(on('console'))).toContainText('done');
}

test('MY_DATA.HTM from the window for opening is drawn beside the simulation, and taken away by one button', async ({
  page,
}) => {
  await open(page);
  await logInSimulation(page);
  await mainMenu(playwrightApp('chromium', page), 'open');
  await choose(page, by('open-files'), NAME, microbitPage({ csv: csv.replaceAll(/^[^,]*,/gm, ''), isFull: true }));
  await expect(charts(page)).toHaveCount(1);
  await expect(charts(page)).toHaveAttribute('aria-label', /Device: 3 values from 9 to 12\.5\. Simulation: 20 values/);
  await expect(page.locator(WINDOW)).toContainText('The memory of the device was full');
  for (const kind of ['device', 'simulation'])
    expect((await page.locator(`${WINDOW} figure .${kind}`).boundingBox())?.width).toBeGreaterThan(40);
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  await page.click(by('remove-readings'));
  await expect(page.locator(WINDOW)).toHaveCount(0);
  await expect(page.locator(by('open-device-log'))).toBeVisible();
  await expect(page.locator('.panel-open .tag')).toContainText('20');
});

test('a dropped MY_DATA.HTM opens, stays through a run and comes back from the data log', async ({ page }) => {
  await open(page);
  await expect(page.locator(on('editor'))).toBeVisible();
  await drop(page, NAME, microbitPage({ csv }));
  await expect(charts(page)).toHaveAttribute('aria-label', /^cm\. Device: 3 values from 9 to 12\.5$/);
  await page.keyboard.press('Escape');
  await expect(page.locator(WINDOW)).toHaveCount(0);
  await logInSimulation(page);
  await page.click(by('compare-device-log'));
  await expect(charts(page)).toHaveAttribute('aria-label', /Simulation: 20 values from 0 to 19/);
});

test('a table from the data log’s own button opens; a broken file gives a message and the page goes on', async ({
  page,
}) => {
  await open(page);
  await page.click('[data-testid=panel-log]');
  await choose(page, by('open-device-log'), 'walk.csv', 'Zeit (s);cm\r\n0,5;12,5\r\n1;11\r\n');
  await expect(charts(page)).toHaveAttribute('aria-label', 'cm. Device: 2 values from 11 to 12.5');
  await page.keyboard.press('Escape');
  await drop(page, NAME, microbitPage({ csv }).slice(0, 5000));
  await expect(page.locator('.notice')).toContainText('MY_DATA.HTM breaks off after 4.9 kB');
  await expect(page.locator(by('compare-device-log'))).toContainText('walk.csv');
  expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  await logInSimulation(page);
});

coldTest('nothing of it is fetched before it is opened', async ({ page }) => {
  const fetched: string[] = [];
  page.on('request', (request) => fetched.push(request.url()));
  await open(page);
  await logInSimulation(page);
  const isPart = (url: string): boolean => /device-log/i.test(url);
  expect(fetched.filter(isPart)).toEqual([]);
  await drop(page, NAME, microbitPage({ csv }));
  await expect(charts(page)).toHaveCount(1);
  expect(fetched.filter(isPart)).not.toEqual([]);
});
