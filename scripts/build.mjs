// npm run build: sets up what is missing and builds the app into dist/app.
import { putFirmwareBesideApp } from './firmware.mjs';
import { main, note } from './progress.mjs';
import { setUpApp } from './setup.mjs';

await main(import.meta.url, async () => {
  await setUpApp();
  await putFirmwareBesideApp();
  note('Built: dist/app, static files for any web server.');
});
