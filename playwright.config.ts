import { defineConfig } from '@playwright/test';

/** Tag of long tests that are the same in every engine, within a file that runs in all of them. */
const TESTS_IN_CHROMIUM_ALONE = /@chromium/;

/** Tests that need Playwright's own `page` (the network, the console), and long ones that are the same in every engine. */
const IN_CHROMIUM_ALONE = '**/*.chromium.test.ts';

/**
 * The browser tests. `npm run e2e` starts them: it builds the app, serves it with the headers of a real host and tells
 * by environment variables where the app and the browsers are.
 */
export default defineConfig({
  testDir: 'e2e',
  outputDir: 'test-results',
  timeout: 90_000, // Firefox alone takes up to 5 s to start on a busy machine
  expect: { timeout: 20_000, toPass: { intervals: [50] } }, // left alone it soon tries once a second only
  workers: 3, // of two cores: nearly half of a test is waiting for what goes on in real time
  retries: 0,
  forbidOnly: process.env['CI'] === 'true',
  reporter: [['list'], ['json']],
  use: {
    baseURL: process.env['PARCOURS_APP'] ?? 'http://localhost:8080/',
    viewport: { width: 1280, height: 800 },
    serviceWorkers: 'block', // it fetches all files of the app, which most tests have no use for
    trace: 'off', // it makes every step several times as long; `npm run e2e -- help --trace on` has one to look at
  },
  projects: [
    {
      name: 'chromium',
      use: {
        browserName: 'chromium',
        launchOptions: {
          executablePath: process.env['PARCOURS_CHROMIUM'] ?? '/usr/bin/chromium',
          args: ['--disable-audio-output'], // with a silent sound card its AudioContext stands still, without any it runs
        },
      },
    },
    {
      name: 'firefox',
      testIgnore: IN_CHROMIUM_ALONE,
      grepInvert: TESTS_IN_CHROMIUM_ALONE,
      use: {
        browserName: 'firefox',
        channel: 'moz-firefox', // drives an unpatched Firefox over WebDriver BiDi
        headless: false, // headless Firefox has no WebGL
        launchOptions: { executablePath: process.env['PARCOURS_FIREFOX'] ?? '/usr/bin/firefox-esr' },
      },
    },
    {
      name: 'webkit',
      testIgnore: IN_CHROMIUM_ALONE,
      grepInvert: TESTS_IN_CHROMIUM_ALONE,
      use: { browserName: 'webkit' }, // e2e/webkit.ts drives WebKitGTK; Playwright never starts it
    },
  ],
});
