import { availableParallelism } from 'node:os';

import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vitest/config';

import { handbook } from './build/handbook.ts';
import { programs } from './build/programs.ts';
import { scenes } from './build/scenes.ts';
import { words } from './build/words.ts';

/** The page's tests share a document and a language, so each file has its own. */
const PAGE = 'src/web/**/*.test.ts';

/** These need what a document of its own within a thread lacks: the thread's MessageChannel, and one ArrayBuffer for all. */
const WHOLE_THREAD = [
  'src/web/teacher/print/PrintDialog.test.ts',
  'src/web/pupil/real-device/{RealDeviceDialog,transfer,usb/usb-transfer}.test.ts',
];

/**
 * Unit tests and headless runs; the browsers are driven by playwright.config.ts. A test that mounts components begins with
 * `// @vitest-environment happy-dom`.
 */
export default defineConfig({
  plugins: [programs(), scenes(), handbook(), words(), vue()],
  test: {
    projects: [
      {
        extends: true,
        test: {
          name: 'rooms',
          include: [
            'src/**/*.test.ts',
            'scripts/**/*.test.mjs',
            'build/**/*.test.ts',
            'examples/dev/*.test.ts',
            'examples/{scale,autograders,container,school}/*.test.mjs',
          ],
          exclude: [PAGE],
          isolate: false, // they leave nothing behind, and loading each module once saves a third of the time
        },
      },
      // The packages stay loaded from file to file, which saves a third of the processor's time.
      { extends: true, test: { name: 'page', include: [PAGE], exclude: WHOLE_THREAD, pool: 'vmThreads' } },
      { extends: true, test: { name: 'page in threads', include: WHOLE_THREAD } },
    ],
    vmMemoryLimit: '1GB', // a thread that has grown larger makes room for a new one
    environment: 'node',
    pool: 'threads',
    maxWorkers: availableParallelism(), // else one processor waits, which on two is half of the time
    hookTimeout: 60_000,
    testTimeout: 60_000, // a busy machine with two processors must not fail a test that only counts simulated time
  },
});
