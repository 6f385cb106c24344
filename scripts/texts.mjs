// Checks the words of the app: all languages, the same places for values, nothing left untranslated, nothing unused.
import { readdir, readFile } from 'node:fs/promises';
import { join, posix } from 'node:path';
import { Failure, main, note, root } from './progress.mjs';
import { sameWords } from './texts-same.mjs';
import { refusedIn } from './texts-terms.mjs';

/** The list of languages. */
const LIST = 'src/core/languages.ts';
const languagesOf = (list) => Array.from(list.matchAll(/^ {2}(\w+): \{ name: /gm), ([, language]) => language);
/** The words of a part: a file per language, such as `src/attachments/words/fr.json` or, of a piece that comes late, `words/about/fr.json`. */
const WORDS = /^(.*\/words\/(?:[a-z-]+\/)?)([a-z]+)\.json$/;
/** The handbook and its data protection sheet, a file per language. */
const BOOK = /^(src\/web\/help\/handbook\/\w+)\/([a-z]+)\.md$/;
/** Words of programs: their member `program` stands under the English texts, and a test of its own looks after it. */
const OF_PROGRAMS = /^courses\/|\/(examples|programs)\/words\/$/;
/** Parts whose texts are told by `t` under their names: folder → what stands before the names. */
const KEYED = { 'src/web/kit/words/': '', 'src/advice/words/': 'error.' };

/**
 * @typedef {{ where: string, texts: Record<string, string> }} Entry a text in its languages, and where it stands
 * @typedef {{ folder: string, keys: string[], entries: Entry[] }} Part the words in a folder, by their path in the files
 */

/**
 * The faults of the texts in these files, a line each.
 *
 * @param {ReadonlyMap<string, string>} files path in the repository → its text: the list of languages, sources, words
 * @param {Readonly<Record<'fr' | 'it', ReadonlySet<string>>>} [same] words that may be the same in English
 * @returns {string[]}
 */
export function problemsOf(files, same = { fr: new Set(), it: new Set() }) {
  const languages = languagesOf(files.get(LIST) ?? '');
  const parts = partsIn(files);
  const entries = parts.flatMap((part) => part.entries);
  const readers = readersIn(files);
  const unusedOf = (part) =>
    part.folder in KEYED ? unusedKeys(part, files) : unusedTexts(part, readers.get(part.folder) ?? []);
  return [
    ...entries.flatMap((entry) => wrongIn(entry, languages, same)),
    ...parts.flatMap(unusedOf),
    ...wrongInBooks(files),
    ...textsInSources(files),
  ];
}

/**
 * Every text of the app and of the courses, in its languages.
 *
 * @returns {Promise<Entry[]>}
 */
export const allTexts = async () => partsIn(await filesWithTexts()).flatMap(({ entries }) => entries);

/**
 * The parts of the app that have words.
 *
 * @param {ReadonlyMap<string, string>} files
 * @returns {Part[]}
 */
function partsIn(files) {
  /** @type {Map<string, Map<string, Map<string, string>>>} */
  const folders = new Map();
  for (const [path, text] of files) {
    const [, folder, language] = WORDS.exec(path) ?? [];
    if (folder === undefined) continue;
    const texts = new Map(textsOf(JSON.parse(text), OF_PROGRAMS.test(folder) ? ['program'] : []));
    folders.set(folder, (folders.get(folder) ?? new Map()).set(language, texts));
  }
  return [...folders].map(([folder, languages]) => {
    const keys = [...new Set([...languages.values()].flatMap((texts) => [...texts.keys()]))];
    const inAll = (key) =>
      [...languages].flatMap(([language, texts]) => (texts.has(key) ? [[language, texts.get(key)]] : []));
    const entries = keys.map((key) => ({ where: `${folder}*.json ${key}`, texts: Object.fromEntries(inAll(key)) }));
    return { folder, keys, entries };
  });
}

/** Every text in a file of words by its path, but those under some names. */
function textsOf(value, without, path = '') {
  if (typeof value === 'string') return [[path, value]];
  return Object.entries(value)
    .filter(([name]) => !without.includes(name))
    .flatMap(([name, inner]) => textsOf(inner, without, path === '' ? name : `${path}.${name}`));
}

/** Places for values: `{name}`. Python in a text has none, as its braces hold more than a word. */
const placesIn = (text) => (text.match(/\{\w+\}/g) ?? []).sort().join(' ');
/** Words that a text says; its places, figures, units and what is in `backticks` are the same in every language. */
const wordsIn = (text) =>
  text
    .replace(/\{\w+\}|`[^`]*`/g, ' ')
    .toLowerCase()
    .split(/[^\p{L}]+/u)
    .filter((word) => word.length > 2);

/** @param {Entry} entry */
function wrongIn({ where, texts }, languages, same) {
  const missing = languages.filter((language) => texts[language] === undefined);
  const wrong = missing.length > 0 ? [`no text in ${missing.join(', ')}`] : [];
  const unknown = Object.keys(texts).filter((language) => !languages.includes(language));
  if (unknown.length > 0) wrong.push(`${unknown.join(', ')} is no language of ${LIST}`);
  for (const [language, text] of Object.entries(texts)) {
    if (text.trim() === '') wrong.push(`the text in ${language} is empty`);
    if (placesIn(text) !== placesIn(texts.de ?? text))
      wrong.push(`${language} has the places ${placesIn(text) || '(none)'}, German ${placesIn(texts.de) || '(none)'}`);
    const forgotten = same[language] && text === texts.en && wordsIn(text).some((word) => !same[language].has(word));
    if (forgotten) wrong.push(`${language} is the same as English: ${text}`);
  }
  if (texts.de?.includes('ß')) wrong.push(`ß in German: ${texts.de}`);
  if (/ [:;?!»]|« /.test(texts.fr ?? ''))
    wrong.push(`a wide space before a sign in French (it is U+202F): ${texts.fr}`);
  for (const [language, text] of Object.entries(texts)) wrong.push(...refusedIn(where, language, text));
  return wrong.map((problem) => `${where}: ${problem}`);
}

/** Lines of the handbook that say a refused word; what is a chapter there is the name of a text elsewhere. */
function wrongInBooks(files) {
  return [...files].flatMap(([path, text]) => {
    const [, folder, language] = BOOK.exec(path) ?? [];
    if (folder === undefined) return [];
    let chapter = '';
    // Notes for translators keep their lines, and with them the numbers of those below.
    const lines = text.replace(/<!--[^]*?-->/g, (note) => note.replace(/[^\n]/g, '')).split('\n');
    return lines.flatMap((line, index) => {
      chapter = /^# ([\w-]+):/.exec(line)?.[1] ?? chapter;
      const wrong = refusedIn(`${folder}/ ${chapter}`, language, line.replace(/^(##?) [\w-]+: /, '$1 '));
      if (language === 'de' && line.includes('ß')) wrong.push(`ß in German: ${line}`);
      if (language === 'fr' && / [:;?!»]|« /.test(line)) wrong.push(`a wide space before a sign in French: ${line}`);
      return wrong.map((problem) => `${path}:${index + 1}: ${problem}`);
    });
  });
}

/** Texts that stand in a source instead of a file of words. */
function textsInSources(files) {
  return [...files].flatMap(([path, text]) => {
    if (/\.(json|md)$/.test(path)) return [];
    const found = Array.from(text.matchAll(/\bde: *["'`]/g), ({ index }) => text.slice(0, index).split('\n').length);
    return found.map((line) => `${path}:${line}: texts stand in words/<language>.json`);
  });
}

/** Names of texts that no source says. `help.${kind}` says all that fit. */
function unusedKeys({ folder, keys }, files) {
  const before = KEYED[folder];
  const sources = [...files].filter(([path]) => !/\.(json|md)$/.test(path));
  const named = new Set();
  const patterns = new Set();
  for (const [, text] of sources) {
    for (const [, key] of text.matchAll(/['"]([a-zA-Z]+\.\w+)['"]/g)) named.add(key);
    for (const [, key] of text.matchAll(/`([a-zA-Z]*\.?(?:\$\{[^}`]*\}|[\w.])+)`/g))
      if (key.includes('${')) patterns.add(key.replace(/\$\{[^}]*\}/g, '[\\w-]+'));
  }
  const fits = [...patterns].filter((it) => /^[a-zA-Z]+\./.test(it)).map((it) => new RegExp(`^${it}$`));
  const isUsed = (key) => named.has(key) || fits.some((pattern) => pattern.test(key) && !pattern.test('error.any'));
  // What goes wrong in a program is named without `error.` as well.
  const isNamed = (word) => sources.some(([, text]) => new RegExp(`['"]${word}['"]|\\b${word}:`).test(text));
  return keys
    .filter((key) => !isUsed(before + key) && !(before !== '' && isNamed(key)))
    .map((key) => `${folder}*.json ${key}: used nowhere`);
}

/** Texts of a part that no source names; a part that no source reads at all. */
function unusedTexts({ folder, keys }, readers) {
  // Those of programs and of the template for robots are read all together, by what belongs to none of them.
  const isAlone = folder.startsWith('src/') && !OF_PROGRAMS.test(folder);
  if (readers.length === 0) return isAlone ? [`${folder}*.json: no source reads it`] : [];
  if (readers.some(({ name }) => name === null)) return []; // found by names that are no code: of Python, of rules
  const used = readers.flatMap(({ name, text }) => membersOf(name, text));
  const isUsed = (key) => used.some((it) => it === '' || `${key}.`.startsWith(`${it}.`) || it.startsWith(`${key}.`));
  return keys.filter((key) => !isUsed(key)).map((key) => `${folder}*.json ${key}: used nowhere`);
}

/**
 * The sources that read words, by the folder of these, and how they call them; `null`: they are found by language.
 *
 * @returns {Map<string, { name: string | null, text: string }[]>}
 */
function readersIn(files) {
  const readers = new Map();
  for (const [path, text] of files) {
    for (const [, name, from] of text.matchAll(/^import (?:type )?(\w+) from '(\.[^']*)';$/gm)) {
      const target = posix.join(posix.dirname(path), from);
      const isOneLanguage = target.endsWith('/de.json');
      const folder = isOneLanguage ? target.slice(0, -'de.json'.length) : `${target.replace(/\/$/, '')}/`;
      const before = readers.get(folder) ?? [];
      readers.set(folder, [...before, { name: isOneLanguage ? null : name, text }]);
    }
  }
  return readers;
}

/** The members that a source names, followed through names of its own for some of them: `kinds.block`; '' for all of them. */
function membersOf(alias, text) {
  const code = text.replace(/\/\*[^]*?\*\/|(?<=^|\s)\/\/.*$/gm, '').replace(/^import [^;]*;$/gm, '');
  // Alone, the name means all of them where it is passed on, and nothing as a word in a text or the name of a style.
  const member = `(?<![\\w'-]|(?<!\\.\\.)\\.)${alias}\\b(?=[.?[]|\\)|,|;| [}i])((?:\\??\\.\\w+|\\['[^']+'\\])*)`;
  const pathOf = (chain) => chain.replace(/\??\.(\w+)|\['([^']+)'\]/g, '.$1$2').slice(1);
  const own = Array.from(code.matchAll(new RegExp(`const (\\w+) = ${member};`, 'g')));
  const rest = own.reduce((before, [line]) => before.replace(line, ''), code);
  return [
    ...Array.from(rest.matchAll(new RegExp(member, 'g')), ([, chain]) => pathOf(chain)),
    ...own.flatMap(([, name, chain]) =>
      membersOf(name, rest).map((it) => (it === '' ? pathOf(chain) : `${pathOf(chain)}.${it}`)),
    ),
  ];
}

/** Path → text of everything that holds texts or names them. @returns {Promise<Map<string, string>>} */
export async function filesWithTexts() {
  const inside = async (folder) =>
    (await readdir(join(root, folder), { recursive: true })).map((path) => `${folder}/${path}`.replaceAll('\\', '/'));
  const paths = (await Promise.all(['src', 'courses', 'scripts/robot-template'].map(inside))).flat();
  const isSource = (path) => /\.(ts|vue)$/.test(path) && !/\.test\.ts$|\.d\.ts$|\/testing\//.test(path);
  /** @type {Map<string, string>} */
  const files = new Map();
  for (const path of paths)
    if (isSource(path) || WORDS.test(path) || BOOK.test(path))
      files.set(path, await readFile(join(root, path), 'utf8'));
  return files;
}

await main(import.meta.url, async () => {
  const files = await filesWithTexts();
  const problems = problemsOf(files, sameWords);
  if (problems.length > 0) throw new Failure(`${problems.length} problems with texts:\n${problems.join('\n')}`);
  note(`Texts of ${partsIn(files).length} parts: complete in ${languagesOf(files.get(LIST)).join(', ')}, all used.`);
});
