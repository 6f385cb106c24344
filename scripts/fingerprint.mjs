// Whether something must be built again: a hash over the contents of everything it is made from.
import { createHash } from 'node:crypto';
import { mkdir, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { root } from './progress.mjs';

/**
 * Hashes files and whole folders by name and content.
 *
 * @param {readonly string[]} sources paths in the repository; missing ones count as absent
 * @param {(path: string) => boolean} [counts] which files of the folders count
 */
export async function fingerprint(sources, counts = () => true) {
  const hash = createHash('sha256').update(process.version);
  for (const source of sources) {
    for (const path of await filesOf(source)) {
      if (counts(path)) hash.update(`\0${path}\0`).update(await readFile(resolve(root, path)));
    }
  }
  return hash.digest('hex');
}

/**
 * Builds only when the sources changed since the last time, or the product is gone.
 *
 * @param {string} name what the fingerprint is kept under
 * @param {{ sources: readonly string[], product: string, counts?: (path: string) => boolean }} what
 * @param {() => Promise<void>} build
 * @returns {Promise<boolean>} whether it was built
 */
export async function buildWhenChanged(name, { sources, product, counts }, build) {
  const place = join(root, '.cache', 'built', name);
  const print = await fingerprint(sources, counts);
  const before = await readFile(place, 'utf8').catch(() => '');
  if (before === print && (await exists(join(root, product)))) return false;
  await rm(place, { force: true }); // an interrupted build must not pass for a finished one
  await build();
  await mkdir(dirname(place), { recursive: true });
  await writeFile(place, print);
  return true;
}

export const exists = (path) =>
  stat(path).then(
    () => true,
    () => false,
  );

async function filesOf(source) {
  const found = await stat(resolve(root, source)).catch(() => null);
  if (!found) return [];
  if (found.isFile()) return [source];
  const entries = await readdir(resolve(root, source), { withFileTypes: true });
  const names = entries.sort((a, b) => (a.name < b.name ? -1 : 1));
  return (await Promise.all(names.map((entry) => filesOf(`${source}/${entry.name}`)))).flat();
}
