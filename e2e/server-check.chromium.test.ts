import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { gzipSync } from 'node:zlib';

import { schoolFiles } from '../scripts/school-zip.mjs';
import { headersFor } from '../scripts/serve.mjs';
import { expect, warmTest as test } from './app';
import { violationsBy } from './axe';
import { by } from './parts';

test.use({ locale: 'de-CH', serviceWorkers: 'allow' });

/** A web server on which the zip for a school was unpacked; `isGood`: set up as the documentation says. */
async function server(isGood: () => boolean): Promise<Server> {
  const files = await schoolFiles();
  const made = createServer((request, response) => {
    const name = (request.url ?? '').slice(1).replace(/\?.*/, '') || 'index.html';
    const bytes = files.get(`parcours/${name}`);
    if (bytes === undefined) {
      response.writeHead(404).end();
      return;
    }
    const isWrong = !isGood() && name.endsWith('.wasm');
    response.writeHead(200, {
      ...headersFor(`/${name}`),
      'Content-Encoding': 'gzip',
      ...(isWrong && { 'Content-Type': 'text/plain' }),
    });
    response.end(gzipSync(bytes, { level: 1 }));
  });
  await new Promise<void>((done) => made.listen(0, '127.0.0.1', () => done()));
  return made;
}

test('the page of the zip for schools finds nothing on a right server, and says what to mend on a wrong one', async ({
  page,
}) => {
  test.slow();
  let isGood = true;
  const made = await server(() => isGood);
  const address = `http://127.0.0.1:${String((made.address() as AddressInfo).port)}/check.html`;
  try {
    await page.goto(address);
    const sum = page.locator(by('check-sum'));
    await expect(sum).toHaveText('Alles in Ordnung. Die Klasse kann kommen.', { timeout: 60_000 });
    await expect(page.locator('li.ok')).toHaveCount(12);
    expect(await violationsBy((code) => page.evaluate(code))).toEqual([]);
    isGood = false;
    await page.reload();
    await expect(sum).toHaveAttribute('data-state', 'bad', { timeout: 60_000 });
    await expect(page.locator('li').first()).toContainText('Dateien kommen mit einem falschen Typ.');
    await expect(page.locator(by('check-types'))).toContainText('.wasm als application/wasm');
  } finally {
    made.closeAllConnections();
    made.close();
  }
});
