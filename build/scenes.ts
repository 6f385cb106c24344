/**
 * Courses that come with the app, read while it is built: the page needs no reader before somebody opens a file, and a
 * course that is wrong stops the build with its place. `import scene from './scene.json?scene'` gives it with every default.
 */
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { runnerImport, type Plugin } from 'vite';
import type { parseScene as ParseScene } from '#scene/parse';

const QUERY = '?scene';

/** The reader, which is source of the app and not of its build: Vite runs it. */
async function loadReader(): Promise<typeof ParseScene> {
  const file = fileURLToPath(new URL('../src/scene/parse.ts', import.meta.url));
  const { module } = await runnerImport<{ readonly parseScene: typeof ParseScene }>(file, { configFile: false });
  return module.parseScene;
}

/** Makes a module of each `….json?scene`. */
export function scenes(): Plugin {
  let reader: Promise<typeof ParseScene> | undefined;
  return {
    name: 'scenes',
    async load(id) {
      if (!id.endsWith(`.json${QUERY}`)) return null;
      const path = id.slice(0, -QUERY.length);
      this.addWatchFile(path);
      const parseScene = await (reader ??= loadReader());
      const read = parseScene(await readFile(path, 'utf8'));
      if (!('scene' in read)) return this.error(`${path}: ${read.problem}`);
      return { code: `export default ${JSON.stringify(read.scene)};`, map: null, moduleType: 'js' };
    },
  };
}
