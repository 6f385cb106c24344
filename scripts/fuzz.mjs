// npm run fuzz: the tests with random cases (*.fuzz.test.ts, 1,000 cases each in npm test) with a million cases each, and how
// many they were in a second. `npm run fuzz -- 50000 src/scene` tries so many, in that folder alone. A case that fails names
// its seed; with FUZZ_SEED=that and one run it is tried alone.
import { readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { elapsed, Failure, main, note, root, run } from './progress.mjs';

const REPORT = '.cache/test/fuzz.json';
const STANDARD_RUNS = 1_000_000;
const ANY_TIME_MS = 24 * 60 * 60 * 1000;

/**
 * The wishes of the command line.
 *
 * @param {readonly string[]} args a number of cases and parts of file names, in any order, each may be missing
 */
export function fuzzPlan(args) {
  const isNumber = (arg) => /^[\d_]+$/.test(arg);
  const runs = Number((args.find(isNumber) ?? String(STANDARD_RUNS)).replaceAll('_', ''));
  if (!(runs >= 1)) throw new Failure('npm run fuzz: at least one case is wanted, as in: npm run fuzz -- 50000');
  return { runs, folders: args.filter((arg) => !isNumber(arg)) };
}

await main(import.meta.url, async (args) => {
  const { runs, folders } = fuzzPlan(args);
  await rm(join(root, REPORT), { force: true });
  const vitest = ['node_modules/vitest/vitest.mjs', 'run', ...(folders.length > 0 ? folders : ['.fuzz.test.ts'])];
  const { code } = await run(
    'node',
    [
      ...vitest,
      ...['--exclude', '**/!(*.fuzz).test.ts', '--testTimeout', String(ANY_TIME_MS)],
      ...['--reporter=default', '--reporter=json', `--outputFile.json=${REPORT}`],
    ],
    { env: { FUZZ_RUNS: String(runs) } },
  );
  const report = await readFile(join(root, REPORT), 'utf8').then(JSON.parse, () => null);
  for (const { title, duration } of (report?.testResults ?? []).flatMap(({ assertionResults }) => assertionResults)) {
    if (!title.includes(String(runs)) || !(duration > 0)) continue; // one with its own number of cases, or not run to its end
    const perSecond = Math.round((runs / duration) * 1000);
    note(`${perSecond.toLocaleString('en')} a second (${elapsed(duration)}): ${title}`);
  }
  if (code !== 0) throw new Failure('A random case failed; its seed stands above.');
});
