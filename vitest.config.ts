import { defineConfig } from 'vitest/config';

/** Unit tests and headless runs; the browsers are driven by playwright.config.ts. */
export default defineConfig({
  test: {
    include: ['src/**/*.test.ts', 'scripts/**/*.test.mjs', 'courses/**/*.test.ts'],
    environment: 'node',
    testTimeout: 60_000, // a busy machine with two processors must not fail a test that only counts simulated time
  },
});
