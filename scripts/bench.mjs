// npm run bench: prints every budget with its figure (docs/architecture.md, "Budgets"). A missed budget is marked and fails nothing.
// With `-- --long` the page drives its ten minutes as people see them, not as fast as it can. With `-- --calls` it only
// tells how fast a loop with each API call runs, the slowest first. With `-- --hints` it asks for a hint to a hundred faulty
// programs, or to those of a course or kind (`-- --hints square`). With `-- --only WORDS` it measures what has these words
// in its name, as in `-- --only memory`.
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { engines } from './browsers.mjs';
import { elapsed, main, mustRun, note, root, step } from './progress.mjs';
import { serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const load = () =>
  loadavg()
    .map((mean) => mean.toFixed(1))
    .join(', ');

function print({ what, figure, budget, met }) {
  process.stdout.write(`${what.padEnd(58)} | ${figure} | ${budget}${met === false ? ' | ✗ over budget' : ''}\n`);
}

async function buildBench() {
  await step('Benchmarks: bundle', () =>
    mustRun('node', [
      'node_modules/vite/bin/vite.js',
      ...['build', '--config', 'vite.cli.config.ts', '--mode', 'bench', '--logLevel', 'warn'],
    ]),
  );
  return import(pathToFileURL(join(root, 'dist/bench/bench.mjs')).href);
}

async function printCalls(bench) {
  const calls = [];
  for await (const call of bench.apiCalls()) calls.push(call);
  calls.sort((a, b) => a.factor - b.factor);
  for (const { call, factor } of calls) process.stdout.write(`${call.padEnd(50)} ${factor.toFixed(1)} x\n`);
}

async function printHints(bench, words) {
  const rows = [];
  for await (const row of bench.hintRows(words)) {
    rows.push(row);
    process.stdout.write(`${bench.hintLine(row)}\n`);
  }
  for (const line of bench.hintSums(rows)) process.stdout.write(`${line}\n`);
}

/** The lines about the page, from the built app in headless Chromium. */
async function printPage(bench, { long, words }) {
  const [{ env, missing }] = engines();
  if (missing) {
    bench.skippedPageRows(missing, words).forEach(print);
    return;
  }
  const { chromium } = await import('@playwright/test'); // not before set-up: a fresh clone has it only then
  const options = { executablePath: env.PARCOURS_CHROMIUM, args: ['--disable-audio-output'] };
  const server = await serve({ port: 0 });
  try {
    const stage = { launch: () => chromium.launch(options), url: server.url, long };
    for await (const row of bench.pageRows(stage, words)) print(row);
  } finally {
    await server.close();
  }
}

await main(import.meta.url, async (args) => {
  await setUpApp();
  const bench = await buildBench();
  const started = Date.now();
  const processors = cpus();
  note(
    `Machine: ${processors.length} × ${processors[0]?.model.trim() ?? 'unknown processor'}, Node ${process.versions.node}`,
  );
  note(
    `Load (means of 1, 5 and 15 min): ${load()}. Headless: the best of 3; page: the median of 3, Chromium on the same machine.`,
  );
  if (args.includes('--calls')) return printCalls(bench);
  if (args.includes('--hints')) return printHints(bench, args[args.indexOf('--hints') + 1] ?? '');
  const words = args.includes('--only') ? (args[args.indexOf('--only') + 1] ?? '') : '';
  print({ what: 'what', figure: 'figure', budget: 'budget', met: null });
  for await (const row of bench.headlessRows(words)) print(row);
  await printPage(bench, { long: args.includes('--long'), words });
  note(`Load at the end: ${load()}. Measured in ${elapsed(Date.now() - started)}.`);
});
