/** Which words the page needs at once, and which come with its late parts: read from the imports of its sources. */
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { wordsFolder } from './words.ts';

const STATIC = /^(?:import|export)\s+(?!type\b)(?:[^'";]*?\sfrom\s+)?'([^']+)';/gm;
// All files of a name: import.meta.glob with ../**/pages.ts and eager.
const BY_NAME = /\bimport\.meta\.glob[^(]*\('([^'*]*)\*\*\/([^'*]+)',\s*\{\s*eager: true/g;
const LATE = /\bimport\('([^']+)'\)/g;
const SUFFIXES = ['', '.ts', '.vue', '/index.ts'];

/** The words that sources reach. */
export interface ReachedWords {
  /** Folders of words that come with the first sources themselves. */
  readonly first: readonly string[];
  /** Those that come with what they fetch later. */
  readonly late: readonly string[];
}

/**
 * Follows the imports from some sources.
 *
 * @param first the sources that are loaded at once
 * @param src the folder that `#room/file` begins at
 */
export function reachedWords(first: readonly string[], src: string): ReachedWords {
  const sources = new Map<string, Imports>();
  const look = (file: string): Imports => {
    const known = sources.get(file) ?? importsOf(file, src);
    sources.set(file, known);
    return known;
  };
  const atOnce = closure(first, (file) => look(file).files);
  const all = closure(first, (file) => [...look(file).files, ...look(file).late]);
  const wordsOf = (files: ReadonlySet<string>): string[] => [...files].flatMap((file) => look(file).words);
  const firstWords = new Set(wordsOf(atOnce));
  const late = new Set(wordsOf(all).filter((folder) => !firstWords.has(folder)));
  return { first: [...firstWords].sort(), late: [...late].sort() };
}

/** The imports of a source: sources at once and on demand, and folders of words. */
interface Imports {
  readonly files: readonly string[];
  readonly late: readonly string[];
  readonly words: readonly string[];
}

function importsOf(file: string, src: string): Imports {
  if (!/\.(ts|vue)$/.test(file)) return { files: [], late: [], words: [] };
  const code = readFileSync(file, 'utf8');
  const named = (pattern: RegExp): string[] => [...code.matchAll(pattern)].map(([, name = '']) => name);
  const found = (names: readonly string[]): string[] => names.flatMap((name) => fileOf(name, file, src));
  const atOnce = named(STATIC);
  const words = atOnce.flatMap((name) => wordsFolder(name, file) ?? []);
  const byName = [...code.matchAll(BY_NAME)].flatMap(([, below = '', name = '']) =>
    filesNamed(join(dirname(file), below), name),
  );
  return { files: [...found(atOnce), ...byName], late: found(named(LATE)), words };
}

function filesNamed(folder: string, name: string): string[] {
  const paths = readdirSync(folder, { recursive: true, encoding: 'utf8' });
  return paths.filter((path) => basename(path) === name).map((path) => join(folder, path));
}

/** The source that an import means; none for packages, words and what is no code. */
function fileOf(name: string, importer: string, src: string): string[] {
  const path = name.startsWith('#') ? join(src, name.slice(1)) : join(dirname(importer), name);
  if (!/^[#.]/.test(name) || wordsFolder(name, importer) !== null) return [];
  const found = SUFFIXES.map((suffix) => path + suffix).find((it) => existsSync(it) && statSync(it).isFile());
  return found === undefined ? [] : [found];
}

function closure(from: readonly string[], next: (file: string) => readonly string[]): ReadonlySet<string> {
  const reached = new Set(from);
  for (const file of reached) for (const it of next(file)) reached.add(it);
  return reached;
}
