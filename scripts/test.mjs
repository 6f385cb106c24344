// npm test: everything, as on a fresh clone. The last line counts: "N passed, N failed".
import { readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { installBrowsers, usableEngines } from './browsers.mjs';
import { check } from './check.mjs';
import { browserTests } from './e2e.mjs';
import { installOldBrowsers } from './old-browsers.mjs';
import { elapsed, Failure, main, root, run } from './progress.mjs';
import { buildApp, setUp, setUpApp } from './setup.mjs';

const REPORT = '.cache/test/unit.json';

/** Unit tests and headless runs. */
async function unitTests() {
  const started = Date.now();
  await rm(join(root, REPORT), { force: true });
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${REPORT}`];
  const { code } = await run('node', ['node_modules/vitest/vitest.mjs', 'run', ...reporters]);
  const report = await readFile(join(root, REPORT), 'utf8').then(JSON.parse, () => null);
  const passed = report?.numPassedTests ?? 0;
  const failed = (report?.numFailedTests ?? 0) || (code === 0 ? 0 : 1); // a file that does not load counts as one
  return { name: 'unit and headless', passed, failed, skipped: report?.numPendingTests ?? 0, ms: Date.now() - started };
}

/** Runs one part; what it throws is shown and counts as one failure, and the other parts still run. */
async function part(title, work) {
  const started = Date.now();
  process.stdout.write(`\n▸ ${title}\n`);
  try {
    const rows = [await work()].flat();
    return rows.map((row) => ({ ...row, part: title }));
  } catch (error) {
    process.stdout.write(`${error instanceof Failure ? error.message : error.stack}\n`);
    return [{ part: title, name: 'could not run', passed: 0, failed: 1, skipped: 0, ms: Date.now() - started }];
  }
}

function summarise(rows, ms) {
  process.stdout.write(`\nSummary, ${elapsed(ms)} in all\n`);
  for (const { part: title, name, passed, failed, skipped, again, ms: took } of rows) {
    const counts = `${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}${again ? `, ${again} at the second try` : ''}`;
    process.stdout.write(`  ${failed ? '✗' : '✓'} ${`${title}: ${name}`.padEnd(36)} ${counts}  (${elapsed(took)})\n`);
  }
  const sum = (key) => rows.reduce((total, row) => total + row[key], 0);
  process.stdout.write(`\n${sum('passed')} passed, ${sum('failed')} failed\n`);
  return sum('failed');
}

await main(import.meta.url, async () => {
  const started = Date.now();
  await setUpApp().catch(setUp); // an app that cannot be built counts in its own part
  await installBrowsers();
  await installOldBrowsers();
  usableEngines(); // says what will be skipped, and with CI=true refuses, before the long part
  const checks = part('Checks', () => check({ beside: true })); // in the time that the tests wait
  const tests = [
    ...(await part('Tests', unitTests)),
    ...(await part('Browsers', async () => {
      await buildApp();
      return browserTests(['--retries=1']); // a browser of a busy machine may miss a moment once, not twice
    })),
  ];
  const rows = [...(await checks), ...tests];
  if (summarise(rows, Date.now() - started) > 0) process.exitCode = 1;
});
