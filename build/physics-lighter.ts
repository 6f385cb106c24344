/** Leaves the parts of the physics engine out that no course needs: joints, edges and chains, and its own files. */
import type { Plugin } from 'vite';

/** Pieces of the engine that run as it is loaded, their replacements, and how often each has to be found. */
const REPLACED: readonly (readonly [RegExp, string, number])[] = [
  // TypeScript's mark of a class that it made a function, which no bundler reads.
  [/\/\*\* @class \*\//g, '/* @__PURE__ */', 68],
  [/= new Serializer\(/g, '= /* @__PURE__ */ new Serializer(', 1],
  [/^Serializer\.(from|to)Json = .*;$/gm, '', 2],
  // Without this table of all joints and shapes those go that nobody makes.
  [/^(var DESERIALIZE_BY_TYPE_FIELD = )\(_a = [^;]*;/gm, '$1{};', 1],
  [/^Contact\.addType\((Edge|Chain)Shape\.TYPE, .*;$/gm, '', 4],
];

/**
 * The engine as a bundler can lighten it: what is not imported goes.
 *
 * @throws {Error} if the engine is another one than this was written for
 */
export function lightened(engine: string): string {
  let code = engine;
  for (const [pattern, by, wanted] of REPLACED) {
    const found = code.match(pattern)?.length ?? 0;
    if (found !== wanted)
      throw new Error(`The physics engine has ${String(found)} of ${pattern.source}, not ${String(wanted)}.`);
    code = code.replace(pattern, by);
  }
  return code;
}

/** Lightens the physics engine in a bundle. */
export const physicsLighter = (): Plugin => ({
  name: 'physics-lighter',
  enforce: 'pre',
  transform: (code, id) => {
    if (/\/planck\/dist\/planck\.mjs$/.test(id)) return { code: lightened(code), map: null };
    if (/\/planck\/.*\.m?js/.test(id)) throw new Error(`The physics engine lies in another file: ${id}.`);
    return null;
  },
});
