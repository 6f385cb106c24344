import type { AddressInfo } from 'node:net';

import { expect, test } from '@playwright/test';
import { createServer, type ViteDevServer } from 'vite';
import { violationsBy } from './axe';

/** The gallery of the kit, as `npm run gallery` shows it. */
let server: ViteDevServer;
let gallery: string;
test.beforeAll(async () => {
  server = await createServer({ configFile: 'vite.config.ts', logLevel: 'error', server: { port: 0, hmr: false } });
  await server.listen();
  const { port } = server.httpServer?.address() as AddressInfo;
  gallery = `http://localhost:${port}/kit/gallery/`;
});
test.afterAll(() => server.close());

const SHARE = { de: 'Teilen', fr: 'Partager', it: 'Condividi', en: 'Share' } as const;
const WIDTHS = [390, 820, 1366] as const;

for (const [language, share] of Object.entries(SHARE))
  test(`every part of the kit has room and can be told apart, in both themes and at three widths (${language})`, async ({
    page,
  }, info) => {
    await page.goto(`${gallery}?language=${language}`);
    await expect(page.getByRole('button', { name: share, exact: true })).toHaveCount(2 * 16);
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 900 });
      await info.attach(`kit-${language}-${width}`, { body: await page.screenshot(), contentType: 'image/png' });
      // What is wider than its box would be cut off, but for lines that end in an ellipsis.
      const tooWide = await page.evaluate(() =>
        Array.from(
          document.querySelectorAll<HTMLElement>(
            '.gallery, .part, .part :not(svg, svg *, option, .vh, .one-line, input)',
          ),
        )
          .filter(({ scrollWidth, clientWidth }) => clientWidth > 0 && scrollWidth > clientWidth + 1)
          .map(({ className, tagName }) => `${tagName} ${className}`),
      );
      expect(tooWide, `at ${width} px`).toEqual([]);
    }
    expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
  });

test('a field of the kit takes what is typed, and says what it cannot take', async ({ page }) => {
  await page.goto(gallery);
  const light = page.locator('[data-theme=light]');
  const [typed, lazy] = [light.locator('.form-field input').nth(0), light.getByRole('spinbutton').nth(0)];
  await typed.fill('13');
  await expect(lazy).toHaveValue('13');
  await typed.fill('500');
  await expect(light.getByRole('alert')).toHaveText('Von 0 bis 400 cm.');
  await lazy.fill('500');
  await expect(typed).toHaveValue('500'); // nothing yet
  await lazy.press('Enter');
  await expect(typed).toHaveValue('400');
});
