// The service worker, with the list of all files that it keeps: the last step of the app's build (decision 0017).
import { createHash } from 'node:crypto';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { build } from 'vite';
import { isNamedByContent } from './named-by-content.mjs';
import { OLDEST } from './oldest.mjs';
import { root } from './progress.mjs';

const SOURCE = 'src/web/exchange/offline/sw.ts';
/** Placeholder for the list of files in the built script. */
const PLACE = 'self.__WB_MANIFEST';
/**
 * Not kept: the service worker itself, pages for frames that have no storage, the boards' MicroPython, which hosts change
 * and the page keeps itself, and the pictures of the handbook: no pupil needs a megabyte of them.
 */
const LEFT_OUT = /^sw\.js$|\.single\.html$|^firmware\/|^handbook\//;

/**
 * Writes `sw.js` into a folder that holds the built app.
 *
 * @param {string} folder
 * @param {(url: string) => boolean} [isKept] which of the files it keeps, by their addresses below the page
 */
export async function buildServiceWorker(folder, isKept = () => true) {
  const app = resolve(root, folder);
  const all = await readdir(app, { recursive: true, withFileTypes: true });
  const paths = all.filter((it) => it.isFile()).map((it) => join(it.parentPath, it.name));
  const urls = paths
    .map((path) => path.slice(app.length + 1).replaceAll('\\', '/'))
    .filter((url) => !LEFT_OUT.test(url) && isKept(url));
  const entries = await Promise.all(urls.sort().map((url) => listed(app, url)));
  const { code } = await bareServiceWorker();
  if (code.split(PLACE).length !== 2) throw new Error(`${PLACE} must stand in the service worker once.`);
  await writeFile(
    join(app, 'sw.js'),
    code.replace(PLACE, () => JSON.stringify(entries)),
  );
}

/** A host may be in the middle of changing its files: one that is not the listed one is refused by its hash. */
async function listed(folder, url) {
  const content = await readFile(join(folder, url));
  const hash = createHash('sha256').update(content).digest('base64');
  const revision = isNamedByContent(url) ? null : hash;
  return { url, revision, integrity: `sha256-${hash}` };
}

let bare;

/** The service worker as one classic script, without its list of files: not every browser takes modules for it. */
export const bareServiceWorker = () => (bare ??= bundleServiceWorker());

async function bundleServiceWorker() {
  const made = await build({
    configFile: false,
    root,
    logLevel: 'warn',
    publicDir: false,
    define: { 'process.env.NODE_ENV': '"production"' },
    build: {
      write: false,
      target: OLDEST,
      lib: { entry: join(root, SOURCE), formats: ['iife'], name: 'parcours' },
    },
  });
  const [first] = Array.isArray(made) ? made : [made];
  if (!('output' in first)) throw new Error('The service worker was not built.');
  return first.output[0];
}
