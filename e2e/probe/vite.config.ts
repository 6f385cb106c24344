import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

import { words } from '../../build/words.ts';

/** Builds the probe page to dist/e2e, with the same rules as the app. */
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  publicDir: false,
  plugins: [words()],
  worker: { format: 'es', plugins: () => [words()] },
  build: {
    outDir: fileURLToPath(new URL('../../dist/e2e', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
  },
});
