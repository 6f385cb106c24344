/**
 * The words of the app's parts: `words/<language>.json` beside a part, or `words/<piece>/<language>.json`. A part says
 * `import words from './words'` and gets each text in every language, named as in the files. Types: `scripts/word-types.mjs`.
 *
 * The page fetches one language at a time: there, the texts come in files of their own, and are put into place by
 * `src/web/kit/i18n/word-files.ts`.
 */
import { existsSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { LANGUAGES, type Language } from '../src/core/languages.ts';

/** The texts of a part in one language. */
export type Catalogue = string | { readonly [name: string]: Catalogue };

const PART = '\0words:';
const FILES = 'virtual:word-files';
const FILE = '\0word-file:';
const REGISTRY = fileURLToPath(new URL('../src/web/kit/i18n/word-files.ts', import.meta.url)).replaceAll('\\', '/');

/** The folder of words that an import means; `null`: it means something else. */
export function wordsFolder(specifier: string, importer: string | undefined): string | null {
  if (importer === undefined || !/^\.\.?(\/|$)/.test(specifier) || /\.\w+$/.test(specifier)) return null;
  const folder = join(dirname(importer), specifier).replaceAll('\\', '/');
  return !existsSync(`${folder}.ts`) && existsSync(`${folder}/de.json`) ? folder : null;
}

async function readCatalogue(folder: string, language: string): Promise<Catalogue> {
  return JSON.parse(await readFile(join(folder, `${language}.json`), 'utf8')) as Catalogue;
}

/** The shape of a part's words: the catalogue with another value in place of each text. */
type Tree<T> = T | { readonly [name: string]: Tree<T> };

/** The catalogue's shape, with a value in place of each text. */
const mapTexts = <T>(
  catalogue: Catalogue,
  make: (path: readonly string[]) => T,
  path: readonly string[] = [],
): Tree<T> =>
  typeof catalogue === 'string'
    ? make(path)
    : Object.fromEntries(Object.entries(catalogue).map(([name, it]) => [name, mapTexts(it, make, [...path, name])]));

/** The text at a path; empty where a language lacks it, which `npm run check` finds. */
function textAt(catalogue: Catalogue, path: readonly string[]): string {
  const found = path.reduce<Catalogue>((it, name) => (typeof it === 'string' ? '' : (it[name] ?? '')), catalogue);
  return typeof found === 'string' ? found : '';
}

/** A part's words with all languages in each text. */
export async function wordsIn(folder: string): Promise<Tree<Readonly<Record<string, string>>>> {
  const files = (await readdir(folder)).filter((name) => name.endsWith('.json')).map((name) => basename(name, '.json'));
  const listed = [...LANGUAGES, ...files.filter((name) => !(LANGUAGES as readonly string[]).includes(name))];
  const catalogues = await Promise.all(
    listed.map(async (language) => [language, await readCatalogue(folder, language)] as const),
  );
  return mapTexts(await readCatalogue(folder, 'de'), (path) =>
    Object.fromEntries(catalogues.map(([language, catalogue]) => [language, textAt(catalogue, path)])),
  );
}

/** A part's texts in one language, in the order of its German file. */
export async function textsIn(folder: string, language: Language): Promise<readonly string[]> {
  const [order, catalogue] = await Promise.all([readCatalogue(folder, 'de'), readCatalogue(folder, language)]);
  const texts: string[] = [];
  mapTexts(order, (path) => texts.push(textAt(catalogue, path)));
  return texts;
}

const watched = (folder: string): readonly string[] => LANGUAGES.map((language) => join(folder, `${language}.json`));
const asModule = (code: string) => ({ code, map: null, moduleType: 'js' as const });

/** The module that an import means; `null`: it means no words. */
function resolved(specifier: string, importer: string | undefined): string | null {
  if (specifier === FILES) return `\0${FILES}`;
  const folder = wordsFolder(specifier, importer);
  return folder === null ? null : PART + folder;
}

/**
 * Makes a module of each folder of words, with all languages in it.
 *
 * @param isUntold whether nobody tells the texts of a folder here: they are there, and empty
 */
export function words(isUntold: (folder: string) => boolean = () => false): Plugin {
  return {
    name: 'words',
    enforce: 'pre',
    resolveId: resolved,
    async load(id) {
      if (id === `\0${FILES}`) return asModule('export default {};');
      if (!id.startsWith(PART)) return null;
      const folder = id.slice(PART.length);
      for (const file of watched(folder)) this.addWatchFile(file);
      if (isUntold(folder)) return asModule(untoldCode(await readCatalogue(folder, 'de')));
      return asModule(`export default ${JSON.stringify(await wordsIn(folder))};`);
    },
  };
}

/** The module of words that nobody tells: one empty text in all places. */
function untoldCode(catalogue: Catalogue): string {
  const none = JSON.stringify(Object.fromEntries(LANGUAGES.map((language) => [language, ''])));
  const shape = JSON.stringify(mapTexts(catalogue, () => 0)).replace(/:0(?=[,}])/g, ':none');
  return `const none = ${none};\nexport default ${shape};`;
}

/** Folders of words by the name of the file that they share, such as `first`. */
export type WordGroups = Readonly<Record<string, readonly string[]>>;

/**
 * Makes a module of each folder of words that names its texts, and a file for each group and language that has them. What an
 * `import()` gives is there once its words are.
 *
 * @param groupsOf tells which folders share a file; asked once, as the build begins
 */
export function wordsByLanguage(groupsOf: () => WordGroups): Plugin {
  let groups: WordGroups = {};
  return {
    name: 'words-by-language',
    enforce: 'pre',
    buildStart() {
      groups = groupsOf();
    },
    resolveId: (specifier, importer) => (specifier.startsWith(FILE) ? specifier : resolved(specifier, importer)),
    async load(id) {
      if (id === `\0${FILES}`) return asModule(filesCode(Object.keys(groups)));
      if (id.startsWith(FILE)) {
        const [group = '', language = ''] = id.slice(FILE.length).split('/');
        const texts = (groups[group] ?? []).map((folder) => textsIn(folder, language as Language));
        return asModule(`export const wordTexts = ${JSON.stringify(await Promise.all(texts))};`);
      }
      if (!id.startsWith(PART)) return null;
      const folder = id.slice(PART.length);
      const group = Object.keys(groups).find((name) => groups[name]?.includes(folder));
      if (group === undefined) this.error(`The words in ${folder} are in no group.`);
      const shape = JSON.stringify(mapTexts(await readCatalogue(folder, 'de'), () => 0));
      const place = `${JSON.stringify(group)}, ${String(groups[group]?.indexOf(folder))}`;
      return asModule(`import { wordsOfPart } from ${JSON.stringify(REGISTRY)};
export default wordsOfPart(${place}, ${shape});`);
    },
    transform(code, id) {
      // The loader that Vite puts around each import() waits for styles; this makes it wait for words as well.
      if (id !== '\0vite/preload-helper.js') return null;
      const wrapped = code.replace('export const __vitePreload =', 'const preload =');
      if (wrapped === code) this.error('The loader of late parts does not look as expected.');
      const wait = `import { withWords } from ${JSON.stringify(REGISTRY)};
export const __vitePreload = (load, files, from) => withWords(preload(load, files, from));`;
      return { code: `${wrapped};\n${wait}`, map: null };
    },
  };
}

/** The loaders of all files: group → language → loader. */
function filesCode(groups: readonly string[]): string {
  const loaders = (group: string): string =>
    LANGUAGES.map((language) => `${language}: () => import(${JSON.stringify(`${FILE}${group}/${language}`)})`).join(
      ', ',
    );
  return `export default { ${groups.map((group) => `${group}: { ${loaders(group)} }`).join(',\n')} };`;
}
