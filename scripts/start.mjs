// npm start: sets up what is missing, builds the app and serves it.
import { main } from './progress.mjs';
import { serve } from './serve.mjs';
import { buildApp, setUp } from './setup.mjs';

await main(import.meta.url, async () => {
  await setUp();
  await buildApp();
  const { url } = await serve();
  process.stdout.write(`\nParcours runs at ${url}  (Ctrl-C ends it)\n`);
});
