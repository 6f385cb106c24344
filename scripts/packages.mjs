// npm run packages: builds what other pages install (packages/*) and packs each into dist/packages/<name>-<version>.tgz.
import { cp, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { build } from 'vite';
import { bundleTypes } from './bundle-types.mjs';
import { exists } from './fingerprint.mjs';
import { OLDEST } from './oldest.mjs';
import { Failure, main, mustRun, root, step } from './progress.mjs';
import { setUpApp } from './setup.mjs';

/** Each folder of `packages/` and the module that it is made of. `hasApp`: the built app lies beside it. */
export const packages = [
  { folder: 'client', entry: 'src/embed/client/connect.ts', hasApp: false },
  { folder: 'element', entry: 'src/embed/element/define.ts', hasApp: true },
  { folder: 'webtigerpython', entry: 'src/embed/client/webtigerpython-device.ts', hasApp: false },
];

/** Folder of the tarballs. */
const TARBALLS = join(root, 'dist/packages');

/**
 * Builds and packs them. The same sources give the same tarballs, byte for byte.
 *
 * @param {string} [out] an absolute path: the folder for the tarballs; it is emptied first
 * @param {{ only?: readonly string[], app?: string }} [choice] only: folders of `packages/`; app: the folder of the built app
 * @returns {Promise<Readonly<Record<string, string>>>} name of the package → path of its tarball
 */
export async function packAll(out = TARBALLS, { only, app = 'dist/app' } = {}) {
  await rm(out, { recursive: true, force: true });
  await mkdir(out, { recursive: true });
  /** @type {Record<string, string>} */
  const made = {};
  for (const one of packages.filter(({ folder }) => only?.includes(folder) ?? true)) {
    const { name, tarball } = await pack(one, out, resolve(root, app));
    made[name] = tarball;
  }
  return made;
}

/** Packs one of them from a copy that has everything. */
async function pack({ folder, entry, hasApp }, out, app) {
  const copy = join(out, folder);
  await cp(join(root, 'packages', folder), copy, { recursive: true });
  const about = { ...(await readJson(join(copy, 'package.json'))), version: await versionOfApp() };
  await writeFile(join(copy, 'package.json'), `${JSON.stringify(about, null, 2)}\n`);
  await buildModule(join(root, entry), join(copy, 'dist'));
  await writeFile(join(copy, 'dist/index.d.ts'), bundleTypes(join(root, entry)));
  if (hasApp) await copyApp(app, join(copy, 'app'));
  await mustRun('npm', ['pack', copy, '--pack-destination', out, '--silent'], { quiet: true });
  await rm(copy, { recursive: true });
  return { name: about.name, tarball: join(out, `${about.name}-${about.version}.tgz`) };
}

/** One module with everything in it. */
export async function buildModule(entry, folder) {
  await build({
    root,
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    build: {
      lib: { entry, formats: ['es'], fileName: () => 'index.js' },
      outDir: folder,
      emptyOutDir: true,
      target: OLDEST,
      minify: false, // hosts minify it with the rest
    },
  });
}

/** The app; the licences of all its parts are in it. */
async function copyApp(app, folder) {
  for (const file of ['parcours.single.html', 'LICENSES.txt'])
    if (!(await exists(join(app, file)))) throw new Failure(`There is no built app in ${app}: ${file} is missing.`);
  await cp(app, folder, { recursive: true });
}

const readJson = async (path) => JSON.parse(await readFile(path, 'utf8'));

const versionOfApp = async () => (await readJson(join(root, 'package.json'))).version;

await main(import.meta.url, async () => {
  await setUpApp();
  const made = await step('Packages', () => packAll());
  for (const path of Object.values(made)) process.stdout.write(`${path}\n`);
});
