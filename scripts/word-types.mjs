// Writes the types of `import words from './words'`: an index.d.ts into each folder of words. They are the same for all, as
// the names come from de.json, and are kept out of git: set-up and the check write those that are missing.
import { readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { main, root } from './progress.mjs';

const NAME = 'index.d.ts';
const TYPES = `import type { Words } from '#core/words';
import type de from './de.json';

declare const words: Words<typeof de>;
export default words;
`;

/**
 * Writes the types of all words below a folder, and takes away those of words that are gone.
 *
 * @param {string} folder
 */
export async function writeWordTypes(folder) {
  const paths = await readdir(folder, { recursive: true });
  // Those of robots' programs are read by the build alone.
  const inWords = (path) => /(^|[\\/])(?<!examples[\\/])words([\\/][a-z-]+)?$/.test(dirname(path));
  const homes = new Set(paths.filter((path) => inWords(path) && path.endsWith('de.json')).map((path) => dirname(path)));
  for (const home of homes) {
    const file = join(folder, home, NAME);
    if ((await readFile(file, 'utf8').catch(() => '')) !== TYPES) await writeFile(file, TYPES);
  }
  for (const path of paths)
    if (inWords(path) && path.endsWith(NAME) && !homes.has(dirname(path))) await rm(join(folder, path));
}

await main(import.meta.url, () => writeWordTypes(join(root, 'src')));
