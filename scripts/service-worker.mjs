// The service worker, with the list of all files that it keeps: the last step of the app's build (decision 0017).
import { createHash } from 'node:crypto';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { build } from 'vite';
import { injectManifest } from 'workbox-build';
import { main, note, root } from './progress.mjs';

const SOURCE = 'src/web/offline/sw.ts';
/** The largest file that is kept, in bytes. Chosen: far above the VM's 0.9 MB. */
const LARGEST_BYTES = 20_000_000;

/**
 * Writes `sw.js` into a folder that holds the built app.
 *
 * @param {string} [folder]
 * @returns {Promise<{ count: number, bytes: number }>} what it keeps
 * @throws Error where a file cannot be listed
 */
export async function buildServiceWorker(folder = 'dist/app') {
  const app = resolve(root, folder);
  const place = await mkdtemp(join(tmpdir(), 'parcours-sw-'));
  const bare = join(place, 'sw.js');
  try {
    await writeFile(bare, await bareServiceWorker());
    const { count, size, warnings } = await injectManifest({
      swSrc: bare,
      swDest: join(app, 'sw.js'),
      globDirectory: app,
      globPatterns: ['**/*'],
      globIgnores: ['sw.js', '*.single.html'],
      dontCacheBustURLsMatching: /^assets\/.*-[\w-]{8}\.\w+$/,
      maximumFileSizeToCacheInBytes: LARGEST_BYTES,
      manifestTransforms: [async (entries) => ({ manifest: await Promise.all(entries.map((it) => sealed(app, it))) })],
    });
    if (warnings.length > 0) throw new Error(warnings.join('\n'));
    return { count, bytes: size };
  } finally {
    await rm(place, { recursive: true });
  }
}

/** A host may be in the middle of changing its files: one that is not the listed one is refused. */
async function sealed(folder, entry) {
  const hash = createHash('sha256').update(await readFile(join(folder, entry.url)));
  return { ...entry, integrity: `sha256-${hash.digest('base64')}` };
}

/** The service worker as one classic script: not every browser takes modules for it. */
async function bareServiceWorker() {
  const made = await build({
    configFile: false,
    root,
    logLevel: 'warn',
    publicDir: false,
    define: { 'process.env.NODE_ENV': '"production"' },
    build: {
      write: false,
      target: 'es2022',
      lib: { entry: join(root, SOURCE), formats: ['iife'], name: 'parcours' },
    },
  });
  const [first] = Array.isArray(made) ? made : [made];
  if (!('output' in first)) throw new Error('The service worker was not built.');
  return first.output[0].code;
}

await main(import.meta.url, async ([folder]) => {
  const { count, bytes } = await buildServiceWorker(folder);
  note(`sw.js keeps ${count} files, ${Math.round(bytes / 1000)} kB.`);
});
