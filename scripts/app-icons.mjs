// node scripts/app-icons.mjs: draws the icons of the installed app from src/web/logo.svg, with Chromium. They lie in src/web/exchange/offline/icons.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { main, note, root } from './progress.mjs';

const FOLDER = 'src/web/exchange/offline/icons';
/** The ground of the logo; a maskable icon is all of it, the drawing inside the middle 80 % that no mask cuts. */
const GROUND = '#F57C00';
const ICONS = [
  { name: 'icon-192.png', sizePx: 192, isMaskable: false },
  { name: 'icon-512.png', sizePx: 512, isMaskable: false },
  { name: 'icon-maskable-512.png', sizePx: 512, isMaskable: true },
];

await main(import.meta.url, async () => {
  const logo = await readFile(join(root, 'src/web/logo.svg'), 'utf8');
  await mkdir(join(root, FOLDER), { recursive: true });
  const browser = await chromium.launch({
    executablePath: process.env.PARCOURS_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox'],
  });
  try {
    const page = await browser.newPage();
    for (const { name, sizePx, isMaskable } of ICONS) {
      const drawnPx = Math.round(sizePx * (isMaskable ? 0.8 : 1));
      await page.setViewportSize({ width: sizePx, height: sizePx });
      await page.setContent(
        `<body style="margin:0;display:grid;place-items:center;height:100vh;background:${isMaskable ? GROUND : 'none'}">` +
          logo.replace('<svg ', `<svg width="${drawnPx}" height="${drawnPx}" `),
      );
      await writeFile(join(root, FOLDER, name), await page.screenshot({ omitBackground: true }));
      note(`${FOLDER}/${name}`);
    }
  } finally {
    await browser.close();
  }
});
