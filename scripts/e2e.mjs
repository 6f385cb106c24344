// npm run e2e [-- playwright's arguments]: the browser tests in every engine that is there, against the built app.
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { engines, installBrowsers, usableEngines } from './browsers.mjs';
import { buildWhenChanged } from './fingerprint.mjs';
import { installOldBrowsers, oldBrowsersEnv } from './old-browsers.mjs';
import { Failure, main, mustRun, note, root, run, step } from './progress.mjs';
import { serve } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const REPORT = '.cache/test/e2e.json';

/** Folder for what tests make once for all engines (e2e/once-a-run.ts). */
const ONCE_A_RUN = '.cache/once-a-run';

/**
 * Runs the browser tests; the app must be built.
 *
 * @param {readonly string[]} args passed on to Playwright
 * @returns {Promise<{ name: string, passed: number, failed: number, skipped: number, again?: number, ms: number }[]>}
 *   one row per engine; `again`: how many of those passed did so at the second try, where `args` allow one
 */
export async function browserTests(args = []) {
  const usable = usableEngines();
  if (usable.length === 0) return [];
  await buildProbe();
  const app = await serve({ folder: 'dist/app', port: 0, lacks: isWorkerForWebKit });
  const probe = await serve({ folder: 'dist/e2e', port: 0 });
  try {
    const projects = usable.map(({ engine }) => `--project=${engine}`);
    const env = {
      ...Object.assign({}, ...usable.map((it) => it.env)),
      ...(await oldBrowsersEnv()),
      PARCOURS_APP: app.url,
      PARCOURS_PROBE: probe.url,
      PLAYWRIGHT_JSON_OUTPUT_NAME: REPORT,
    };
    await rm(join(root, REPORT), { force: true });
    await rm(join(root, ONCE_A_RUN), { recursive: true, force: true });
    const chosen = args.some((arg) => arg.startsWith('--project')) ? [] : projects;
    const { code } = await onDesktop(['node_modules/@playwright/test/cli.js', 'test', ...args, ...chosen], env);
    return await results(code);
  } finally {
    await Promise.all([app.close(), probe.close()]);
  }
}

/**
 * The service worker of the app, asked for by WebKitGTK: it fetches all files of the app in every session, and WebDriver,
 * unlike Playwright, cannot block it. The tests of it bring a server of their own.
 */
const isWorkerForWebKit = ({ url = '', headers }) =>
  new URL(url, 'http://localhost').pathname.endsWith('/sw.js') &&
  /AppleWebKit/.test(headers['user-agent'] ?? '') &&
  !/Chrome/.test(headers['user-agent'] ?? '');

/** The page that runs the simulation bare in the engine's worker, for the golden trajectories, and listens to sounds. */
async function buildProbe() {
  const inputs = {
    sources: ['src', 'e2e/probe', 'package-lock.json', '.cache/vm'],
    product: 'dist/e2e/index.html',
    counts: (path) => path.startsWith('src/web/session/run/sound/') || !/^src\/(web|cli)\//.test(path),
  };
  await buildWhenChanged('probe', inputs, () =>
    step('Probe page', () =>
      mustRun('node', [
        'node_modules/vite/bin/vite.js',
        'build',
        '--config',
        'e2e/probe/vite.config.ts',
        '--logLevel',
        'warn',
      ]),
    ),
  );
}

/**
 * Firefox and WebKit need a screen, one for every test worker (e2e/screen.ts), and a sound card without which their
 * AudioContext never starts.
 */
async function onDesktop(args, env) {
  if (process.platform !== 'linux' || process.env.DISPLAY) return run('node', args, { env });
  const sound = await startSound();
  try {
    return await run('node', args, { env: { ...env, ...sound.env, PARCOURS_OWN_SCREENS: 'yes' } });
  } finally {
    await sound.stop();
  }
}

/** A sound server of our own with a silent card, ended with the tests. */
async function startSound() {
  const folder = await mkdtemp(join(tmpdir(), 'parcours-sound-'));
  const env = { PULSE_RUNTIME_PATH: folder, PULSE_SERVER: `unix:${folder}/native` };
  const { code } = await run(
    'pulseaudio',
    ['-D', '-n', '--exit-idle-time=-1', '-L', 'module-native-protocol-unix', '-L', 'module-null-sink sink_name=silent'],
    { env: { ...env, PULSE_SERVER: undefined }, quiet: true },
  );
  if (code !== 0) note('No PulseAudio: sound stays off in Firefox and WebKit.');
  return {
    env: code === 0 ? env : {},
    stop: async () => {
      if (code === 0) await run('pulseaudio', ['--kill'], { env: { ...env, PULSE_SERVER: undefined }, quiet: true });
      await rm(folder, { recursive: true, force: true });
    },
  };
}

/** One row per engine, from Playwright's report; without a report the run itself counts as failed. */
async function results(code) {
  const report = await readFile(join(root, REPORT), 'utf8').then(JSON.parse, () => null);
  const tests = report ? [...testsOf(report)] : [];
  if (tests.length === 0) return [{ name: 'browsers', passed: 0, failed: code === 0 ? 0 : 1, skipped: 0, ms: 0 }];
  const rows = engines().map(({ engine }) => {
    const own = tests.filter(({ projectName }) => projectName === engine);
    const count = (...statuses) => own.filter(({ status }) => statuses.includes(status)).length;
    const ms = own.flatMap(({ results: runs }) => runs).reduce((sum, { duration }) => sum + duration, 0);
    return {
      name: engine,
      passed: count('expected', 'flaky'),
      failed: count('unexpected'),
      skipped: count('skipped'),
      again: count('flaky'),
      ms,
    };
  });
  const outside = code !== 0 && rows.every(({ failed }) => failed === 0) ? 1 : 0; // failed before or after the tests
  return [...rows, ...(outside ? [{ name: 'browsers', passed: 0, failed: 1, skipped: 0, ms: 0 }] : [])];
}

function* testsOf(suite) {
  for (const spec of suite.specs ?? []) yield* spec.tests;
  for (const inner of suite.suites ?? []) yield* testsOf(inner);
}

await main(import.meta.url, async (args) => {
  await setUpApp();
  await installBrowsers();
  await installOldBrowsers();
  const rows = await browserTests(args);
  if (rows.some(({ failed }) => failed > 0)) throw new Failure('The browser tests failed.');
});
