// npm run setup: installs what is missing, makes the VM and the command line. Everything is cached; a second run is quick.
import { readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { buildWhenChanged } from './fingerprint.mjs';
import { BESIDE_APP } from './firmware.mjs';
import { Failure, main, mustRun, note, root, step } from './progress.mjs';
import { writeWordTypes } from './word-types.mjs';

const OLDEST_NODE = [20, 19];
const isTest = (path) => /\.test\.ts$|\/testing\//.test(path);
const vite = 'node_modules/vite/bin/vite.js';

/** Brings a fresh clone to where `npx parcours`, the app's build and the tests can run. */
export async function setUp() {
  await prepare();
  const vm = makeVm();
  await Promise.all([vm, buildCli(vm)]);
}

/** Sets up and builds the app, which begins while the VM is still being made. */
export async function setUpApp() {
  await prepare();
  const vm = makeVm();
  await Promise.all([vm, buildCli(vm), buildApp(vm)]);
}

/** Packages, and what all builds read. */
async function prepare() {
  refuseOldNode();
  if (await dependenciesMissing()) {
    await step('Installing packages (npm ci)', () =>
      mustRun('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']),
    );
  } else {
    note('Packages: installed as the lock file says.');
  }
  await writeWordTypes(join(root, 'src'));
  await mustRun('node', ['scripts/build-library.mjs']);
}

/** The firmware, which takes one processor the longest of all. */
const makeVm = () => step('MicroPython VM', () => mustRun('node', ['scripts/build-vm.mjs']));

/** Everything that `.cache/vm` is made of, so that it is known before that is made (`setup.test.mjs` holds it to that). */
export const VM_SOURCES = ['src/vm', 'package-lock.json', 'scripts/build-vm.mjs', 'scripts/build-library.mjs'];

/** Starts Vite; the build waits by itself where it needs the VM (`build/firmware-awaited.ts`). */
const bundle = (vm, ...args) =>
  mustRun('node', [vite, 'build', ...args, '--logLevel', 'warn'], {
    env: { PARCOURS_VM: 'coming' },
    input: vm.then(() => 'made'),
  });

/** The bundle behind `npx parcours`. */
async function buildCli(vm) {
  const inputs = {
    sources: ['src', 'courses', 'build', 'docs/hardware/probe', 'vite.cli.config.ts', 'package.json', ...VM_SOURCES],
    product: 'dist/cli/main.mjs',
    counts: (path) => !isTest(path) && !path.startsWith('src/web/'),
  };
  const built = await buildWhenChanged('cli', inputs, () =>
    step('Command line', () => bundle(vm, '--config', 'vite.cli.config.ts')),
  );
  if (!built) note('Command line: up to date.');
}

/** Everything that the app is made of: its sources, and what `vite.config.ts` reads (`setup.test.mjs` holds it to that). */
export const APP_SOURCES = [
  ...['src', 'courses', 'build', ...VM_SOURCES],
  ...['vite.config.ts', 'package.json', 'LICENSE'],
  ...['frame-check', 'licences', 'oldest', 'single-file', 'service-worker'].map((name) => `scripts/${name}.mjs`),
  ...['fingerprint', 'handbook-pictures', 'named-by-content', 'progress'].map((name) => `scripts/${name}.mjs`),
];

/**
 * The page and its single-file form, in dist/app.
 *
 * @param {Promise<void>} [vm] ends when the VM is made
 */
export async function buildApp(vm = Promise.resolve()) {
  const inputs = {
    sources: APP_SOURCES,
    product: 'dist/app/sw.js',
    counts: (path) => !isTest(path) && !path.startsWith('src/cli/'),
  };
  const built = await buildWhenChanged('app', inputs, () =>
    step('App', async () => {
      await rm(join(root, 'dist/app'), { recursive: true, force: true });
      await Promise.all([bundle(vm), bundle(vm, '--mode', 'single')]);
    }),
  );
  if (!built) note('App: up to date.');
  // Tests and packages are without it; `npm start` and `npm run build` put it there.
  await rm(BESIDE_APP, { recursive: true, force: true });
}

function refuseOldNode() {
  const [major = 0, minor = 0] = process.versions.node.split('.').map(Number);
  if (major > OLDEST_NODE[0] || (major === OLDEST_NODE[0] && minor >= OLDEST_NODE[1])) return;
  throw new Failure(`Parcours needs Node ${OLDEST_NODE.join('.')} or newer; this is ${process.version}.`);
}

/** npm writes what it installed beside the packages, last of all: it is missing after an interrupted installation. */
async function dependenciesMissing() {
  const wanted = JSON.parse(await readFile(join(root, 'package-lock.json'), 'utf8')).packages;
  const installed = await readFile(join(root, 'node_modules/.package-lock.json'), 'utf8').then(
    (text) => JSON.parse(text).packages,
    () => ({}),
  );
  return Object.entries(wanted).some(
    ([path, { version, optional }]) => path !== '' && !optional && installed[path]?.version !== version,
  );
}

await main(import.meta.url, async () => {
  await setUp();
  note('Ready: npx parcours --help');
});
