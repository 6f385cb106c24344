// npm run build: sets up what is missing and builds the app into dist/app.
import { main, note } from './progress.mjs';
import { buildApp, setUp } from './setup.mjs';

await main(import.meta.url, async () => {
  await setUp();
  await buildApp();
  note('Built: dist/app, static files for any web server.');
});
