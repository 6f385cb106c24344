// npm start: sets up what is missing, builds the app and serves it.
import { putFirmwareBesideApp } from './firmware.mjs';
import { main } from './progress.mjs';
import { atWords, serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

await main(import.meta.url, async () => {
  await setUpApp();
  await putFirmwareBesideApp();
  process.stdout.write(`\nParcours runs at ${atWords(await serve())}\n(Ctrl-C ends it)\n`);
});
