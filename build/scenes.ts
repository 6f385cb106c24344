/**
 * Courses that come with the app, read while it is built: the page needs no reader before somebody opens a file, and a
 * course that is wrong stops the build with its place. `import scene from './scene.json?scene'` gives it with every default.
 */
import { readFile } from 'node:fs/promises';
import type { Plugin } from 'vite';
import { parseScene } from '#scene/parse';

const QUERY = '?scene';

/** Makes a module of each `….json?scene`. */
export function scenes(): Plugin {
  return {
    name: 'scenes',
    async load(id) {
      if (!id.endsWith(`.json${QUERY}`)) return null;
      const path = id.slice(0, -QUERY.length);
      this.addWatchFile(path);
      const read = parseScene(await readFile(path, 'utf8'));
      if (!('scene' in read)) return this.error(`${path}: ${read.problem}`);
      return { code: `export default ${JSON.stringify(read.scene)};`, map: null, moduleType: 'js' };
    },
  };
}
