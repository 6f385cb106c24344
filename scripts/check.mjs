// npm run check: format, lint, layers and types. What `npm test` runs first; quick enough to run before every push.
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { elapsed, Failure, main, root, run } from './progress.mjs';
import { writeWordTypes } from './word-types.mjs';

const bin = { prettier: 'prettier/bin/prettier.cjs', eslint: 'eslint/bin/eslint.js', tsc: 'vue-tsc/bin/vue-tsc.js' };
const tool = (name, ...args) => [`node_modules/${bin[name]}`, ...args];

const CHECKS = [
  { name: 'lint', args: tool('eslint', '.', '--max-warnings', '0') },
  { name: 'types of the web app', args: tool('tsc', '-p', 'tsconfig.web.json') },
  { name: 'types of the rooms', args: tool('tsc', '-p', 'tsconfig.rooms.json') },
  { name: 'types of cli and tests', args: tool('tsc', '-p', 'tsconfig.node.json') },
  { name: 'types of the scripts', args: tool('tsc', '-p', 'tsconfig.scripts.json') },
  { name: 'layers and graph', args: ['scripts/layers.mjs'] },
  { name: 'lists of robots', args: ['scripts/robots.mjs', '--check'] },
  { name: 'manual for hosts', args: ['scripts/manual.mjs', '--check'] },
  { name: 'texts', args: ['scripts/texts.mjs'] },
  {
    name: 'format',
    args: tool('prettier', '--check', '--log-level', 'warn', '--cache', '--cache-location', '.cache/prettier', '.'),
  },
];

/**
 * Runs all checks, as many at a time as there are processors.
 *
 * @param {{ beside?: boolean }} [options] beside: other things run meanwhile, after `setUp`; the checks give way to
 *   them, one at a time
 * @returns {Promise<{ name: string, passed: number, failed: number, skipped: number, ms: number }[]>}
 */
export async function check({ beside = false } = {}) {
  if (!beside) await writeWordTypes(join(root, 'src'));
  const waiting = [...CHECKS];
  const results = [];
  const worker = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) results.push(await checkOne(next, beside));
  };
  await Promise.all(Array.from({ length: beside ? 1 : Math.min(availableParallelism(), 4) }, worker));
  return results;
}

async function checkOne({ name, args }, givesWay) {
  const started = Date.now();
  const { code, output } = await run('node', args, {
    quiet: true,
    givesWay,
    env: process.stdout.isTTY ? { FORCE_COLOR: '1' } : {},
  });
  const ms = Date.now() - started;
  process.stdout.write(
    `${code === 0 ? '  ✓' : '  ✗'} ${name}: ${elapsed(ms)}\n${code === 0 ? '' : `${output.trimEnd()}\n`}`,
  );
  return { name, passed: code === 0 ? 1 : 0, failed: code === 0 ? 0 : 1, skipped: 0, ms };
}

await main(import.meta.url, async () => {
  const bad = (await check()).filter(({ failed }) => failed > 0);
  if (bad.length > 0) throw new Failure(`Failed: ${bad.map(({ name }) => name).join(', ')}.`);
});
