// npm run bench: prints the figures of the budgets (docs/architecture.md, "Budgets").
import { main, mustRun, step } from './progress.mjs';
import { setUp } from './setup.mjs';

await main(import.meta.url, async (args) => {
  await setUp();
  await step('Benchmarks: bundle', () =>
    mustRun('node', [
      'node_modules/vite/bin/vite.js',
      ...['build', '--config', 'vite.cli.config.ts', '--mode', 'bench', '--logLevel', 'warn'],
    ]),
  );
  await mustRun('node', ['dist/bench/bench.mjs', ...args]);
});
