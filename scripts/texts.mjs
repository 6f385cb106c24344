// Checks the texts of the app: all languages, the same places for values, nothing left untranslated, nothing unused.
import { readFileSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { basename, join, posix } from 'node:path';
import ts from 'typescript';
import { Failure, main, note, root } from './progress.mjs';
import { sameWords } from './texts-same.mjs';

/** The languages of the app, as src/core/texts.ts lists them. */
const LANGUAGES = Array.from(
  readFileSync(join(root, 'src/core/texts.ts'), 'utf8').matchAll(/^ {2}(\w+): \{ name: /gm),
  ([, language]) => language,
);
/** The words of a part: a file per language, such as `src/attachments/words/fr.json` or, of a piece that comes late, `words/about/fr.json`. */
const WORDS = /^(.*\/words\/(?:[a-z-]+\/)?)([a-z]+)\.json$/;
/** A catalogue is a file per language: `i18n/fr.ts`, `i18n/error-fr.ts`. */
const CATALOGUE = /^(src\/.*\/(?:[a-z]+-)?)(de|fr|it|en)\.ts$/;
/** What the pages of the app are told in by `t`; the keys of other catalogues are names of Python. */
const KEYED = { 'src/web/page/i18n/': '', 'src/web/page/i18n/error-': 'error.' };

/** @typedef {{ where: string, texts: Record<string, string> }} Entry a text in its languages, and where it stands */

/**
 * What is wrong with the texts in these files, a line each.
 *
 * @param {ReadonlyMap<string, string>} files path in the repository → its text: sources, and `texts.json` of courses
 * @param {Readonly<Record<'fr' | 'it', ReadonlySet<string>>>} [same] words that may be the same in English
 * @returns {string[]}
 */
export function problemsOf(files, same = { fr: new Set(), it: new Set() }) {
  const trees = treesOf(files);
  const catalogues = cataloguesIn(trees);
  const parts = partsIn(files);
  const entries = entriesIn(files, trees, catalogues);
  return [
    ...entries.flatMap((entry) => wrongIn(entry, same)),
    ...parts.flatMap((part) => wrongInPart(part, files)),
    ...unusedKeys(catalogues, trees, files),
    ...unusedMembers(trees, files),
  ];
}

/**
 * Every text of the app and of the courses, in its languages.
 *
 * @returns {Promise<Entry[]>}
 */
export async function allTexts() {
  const files = await sourceFiles();
  const trees = treesOf(files);
  return entriesIn(files, trees, cataloguesIn(trees));
}

/** Path → syntax tree of every source among the files. */
const treesOf = (files) =>
  new Map([...files].filter(([path]) => /\.(ts|vue)$/.test(path)).map(([path, text]) => [path, treeOf(path, text)]));

/** @returns {Entry[]} */
const entriesIn = (files, trees, catalogues) => [
  ...catalogues.flatMap(({ entries }) => entries),
  ...partsIn(files).flatMap(({ entries }) => entries),
  ...inlineIn(trees),
  ...courseTexts(files),
];

/** The script of a file; of a component what stands in its <script>. */
function treeOf(path, text) {
  const script = path.endsWith('.vue') ? (/<script[^>]*>([\s\S]*?)<\/script>/.exec(text)?.[1] ?? '') : text;
  return ts.createSourceFile(path, script, ts.ScriptTarget.Latest, true);
}

function visit(node, see) {
  see(node);
  ts.forEachChild(node, (child) => visit(child, see));
}

/** The text of a string, also of one that is written in pieces; `undefined`: it is something else. */
function stringOf(node) {
  if (ts.isStringLiteralLike(node)) return node.text;
  if (!ts.isBinaryExpression(node) || node.operatorToken.kind !== ts.SyntaxKind.PlusToken) return undefined;
  const [left, right] = [stringOf(node.left), stringOf(node.right)];
  return left === undefined || right === undefined ? undefined : left + right;
}

/** Name → value of an object's own properties. */
function propertiesOf(node) {
  const own = node.properties.filter((property) => ts.isPropertyAssignment(property));
  return new Map(own.map(({ name, initializer }) => [ts.isComputedPropertyName(name) ? '' : name.text, initializer]));
}

/** Every string in an object literal by its path. */
function leavesOf(node, path = '') {
  if (!ts.isObjectLiteralExpression(node)) {
    const text = stringOf(node);
    return text === undefined ? [] : [[path, text]];
  }
  return [...propertiesOf(node)].flatMap(([name, value]) => leavesOf(value, path === '' ? name : `${path}.${name}`));
}

/** Without `as const` and `satisfies`. */
function bare(node) {
  return ts.isAsExpression(node) || ts.isSatisfiesExpression(node) ? bare(node.expression) : node;
}

/** The catalogues: their stem, such as `src/web/page/i18n/error-`, and their texts by key. */
function cataloguesIn(trees) {
  /** @type {Map<string, Map<string, Map<string, string>>>} */
  const stems = new Map();
  for (const [path, tree] of trees) {
    const [, stem, language] = CATALOGUE.exec(path) ?? [];
    if (stem === undefined) continue;
    const texts = new Map();
    for (const statement of tree.statements.filter((it) => ts.isVariableStatement(it)))
      for (const { initializer } of statement.declarationList.declarations)
        if (initializer && ts.isObjectLiteralExpression(bare(initializer)))
          for (const [key, text] of leavesOf(bare(initializer))) texts.set(key, text);
    stems.set(stem, (stems.get(stem) ?? new Map()).set(language, texts));
  }
  return [...stems].map(([stem, languages]) => {
    const keys = new Set([...languages.values()].flatMap((texts) => [...texts.keys()]));
    const textsOf = (key) =>
      Object.fromEntries(
        LANGUAGES.flatMap((language) => {
          const text = languages.get(language)?.get(key);
          return text === undefined ? [] : [[language, text]];
        }),
      );
    return { stem, keys, entries: [...keys].map((key) => ({ where: `${stem}*.ts ${key}`, texts: textsOf(key) })) };
  });
}

/**
 * The parts of the app that have words: where these stand, such as `src/attachments/words/`, and its texts by their path
 * in the file, such as `kinds.block`.
 *
 * @param {ReadonlyMap<string, string>} files
 */
function partsIn(files) {
  /** @type {Map<string, Map<string, Map<string, string>>>} */
  const folders = new Map();
  for (const [path, text] of files) {
    const [, folder, language] = WORDS.exec(path) ?? [];
    if (folder === undefined) continue;
    const texts = new Map(textsOfWords(JSON.parse(text)));
    folders.set(folder, (folders.get(folder) ?? new Map()).set(language, texts));
  }
  return [...folders].map(([folder, languages]) => {
    const keys = [...new Set([...languages.values()].flatMap((texts) => [...texts.keys()]))];
    const textsOf = (key) =>
      Object.fromEntries(
        [...languages].flatMap(([language, texts]) => (texts.has(key) ? [[language, texts.get(key)]] : [])),
      );
    return { folder, keys, entries: keys.map((key) => ({ where: `${folder}*.json ${key}`, texts: textsOf(key) })) };
  });
}

/** Every text in a file of words by its path. The texts of a program stand under the English ones: its own test looks after them. */
function textsOfWords(value, path = '') {
  if (typeof value === 'string') return [[path, value]];
  return Object.entries(value)
    .filter(([name]) => name !== 'program')
    .flatMap(([name, inner]) => textsOfWords(inner, path === '' ? name : `${path}.${name}`));
}

/** What is wrong with who reads a part's words: nobody does, or nobody names a text. */
function wrongInPart({ folder, keys }, files) {
  const readers = readersOf(folder, files);
  // Those of courses, examples and the template for robots are read all together, by what belongs to none of them.
  const isAlone = folder.startsWith('src/') && !folder.endsWith('/examples/words/');
  if (readers.length === 0) return isAlone ? [`${folder}*.json: no source reads it`] : [];
  if (readers.some(({ name }) => name === null)) return []; // a record by names that are no code: those of Python, of rules
  const used = readers.flatMap(({ path, name }) => usersOf(name, path, files).flatMap((user) => membersNamed(user)));
  return keys
    .filter(
      (key) =>
        !used.some((member) => member === '' || `${key}.`.startsWith(`${member}.`) || member.startsWith(`${key}.`)),
    )
    .map((key) => `${folder}*.json ${key}: used nowhere`);
}

/** The sources that read a part's words, and how they call them; `null`: they are looked up by language. */
function readersOf(folder, files) {
  return [...files].flatMap(([path, text]) => {
    const types = Array.from(text.matchAll(/^import type (\w+) from '(\.[^']*\/)de\.json';$/gm));
    const type = types.find(([, , from]) => posix.join(posix.dirname(path), from) === folder)?.[1];
    if (type === undefined) return [];
    const name =
      new RegExp(`const (\\w+) = wordsOf\\(\\s*import\\.meta\\.glob<typeof ${type}>`).exec(text)?.[1] ?? null;
    return [{ path, name }];
  });
}

/** The members of an object that a source names: `kinds.block`; '' for the object as a whole. */
function membersNamed({ alias, text }) {
  const code = text.replace(/^import [^;]*;$/gm, '').replace(new RegExp(`const ${alias} =`), '');
  return Array.from(
    code.matchAll(new RegExp(`(?<![\\w.'-])${alias}\\b((?:\\??\\.\\w+|\\['[^']+'\\])*)`, 'g')),
    ([, path]) =>
      path
        .replaceAll('?', '')
        .replace(/\['([^']+)'\]/g, '.$1')
        .replace(/^\./, ''),
  );
}

/** The texts that bring their languages along: `{ de: '…', fr: '…', it: '…', en: '…' }`. */
function inlineIn(trees) {
  /** @type {Entry[]} */
  const entries = [];
  for (const [path, tree] of trees)
    visit(tree, (node) => {
      const texts = textsIn(node);
      if (texts !== null) entries.push({ where: `${path}:${lineOf(tree, node)}`, texts });
    });
  return entries;
}

/** A text in its languages; `null` if it is none, as where each language has a program or a function. */
function textsIn(node) {
  if (!ts.isObjectLiteralExpression(node)) return null;
  const own = propertiesOf(node);
  if (!own.has('de') || [...own.keys()].some((name) => !LANGUAGES.includes(name))) return null;
  const texts = [...own].map(([language, value]) => [language, stringOf(value)]);
  return texts.every(([, text]) => text !== undefined) ? Object.fromEntries(texts) : null;
}

const lineOf = (tree, node) => tree.getLineAndCharacterOfPosition(node.getStart(tree)).line + 1;

/** What the courses say about themselves, in their `texts.json`. */
function courseTexts(files) {
  return [...files].flatMap(([path, text]) => {
    if (!path.endsWith('texts.json')) return [];
    const all = JSON.parse(text);
    return ['name', 'text', 'task'].map((part) => ({
      where: `${path} ${part}`,
      texts: Object.fromEntries(
        LANGUAGES.flatMap((it) => (all[it]?.[part] === undefined ? [] : [[it, all[it][part]]])),
      ),
    }));
  });
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
function wrongIn({ where, texts }, same) {
  const missing = LANGUAGES.filter((language) => texts[language] === undefined);
  const wrong = missing.length > 0 ? [`no text in ${missing.join(', ')}`] : [];
  const unknown = Object.keys(texts).filter((language) => !LANGUAGES.includes(language));
  if (unknown.length > 0) wrong.push(`${unknown.join(', ')} is no language of src/core/texts.ts`);
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
  return wrong.map((problem) => `${where}: ${problem}`);
}

/** Keys of catalogues that are named nowhere. `help.${kind}` names all that fit. */
function unusedKeys(catalogues, trees, files) {
  const named = new Set();
  const patterns = new Set();
  const keyed = catalogues.filter(({ stem }) => KEYED[stem] !== undefined);
  const sources = [...trees].filter(([path]) => !CATALOGUE.test(path));
  for (const [path] of sources) {
    // Components name keys in their templates too: what stands in quotes is looked for in the whole file.
    const text = files.get(path);
    for (const [, key] of text.matchAll(/['"]([a-zA-Z]+\.\w+)['"]/g)) named.add(key);
    for (const [, key] of text.matchAll(/`([a-zA-Z]*\.?(?:\$\{[^}`]*\}|[\w.])+)`/g))
      if (key.includes('${')) patterns.add(key.replace(/\$\{[^}]*\}/g, '\\w+'));
  }
  const fits = [...patterns].filter((it) => /^[a-zA-Z]+\./.test(it)).map((it) => new RegExp(`^${it}$`));
  // In a module of its own, the one of the errors: what goes wrong is named without `error.` as well.
  const isUsed = (key) => named.has(key) || fits.some((pattern) => pattern.test(key) && !pattern.test('error.any'));
  return keyed.flatMap(({ stem, keys }) =>
    [...keys]
      .filter((key) => !isUsed(KEYED[stem] + key) && !(stem.endsWith('error-') && namesWord(sources, files, key)))
      .map((key) => `${stem}*.ts ${key}: used nowhere`),
  );
}

const namesWord = (sources, files, word) =>
  sources.some(([path]) => new RegExp(`['"]${word}['"]|\\b${word}:`).test(files.get(path)));

/** Members of `const words = { title: { de: …, … }, … }` that nobody names. Records over a type are complete by it. */
function unusedMembers(trees, files) {
  return [...trees].flatMap(([path, tree]) =>
    tree.statements
      .filter((it) => ts.isVariableStatement(it))
      .flatMap((statement) => [...statement.declarationList.declarations])
      .flatMap((declaration) => {
        const members = freeMembers(declaration);
        if (members.length === 0) return [];
        const name = declaration.name.getText(tree);
        const users = usersOf(name, path, files);
        return members
          .filter((member) => !users.some(({ alias, text }) => names(alias, member, text)))
          .map((member) => `${path} ${name}.${member}: used nowhere`);
      }),
  );
}

/** Names of an object's texts, where no type says which there must be. */
function freeMembers({ type, initializer }) {
  if (type !== undefined || initializer === undefined) return [];
  const object = bare(initializer);
  if (!ts.isObjectLiteralExpression(object)) return [];
  const own = [...propertiesOf(object)];
  return own.length > 0 && own.every(([, value]) => textsIn(value) !== null) ? own.map(([name]) => name) : [];
}

/** Where an object may be named: its own file, and those that import it, at once or late, by the name it has there. */
function usersOf(name, home, files) {
  const stem = basename(home, '.ts');
  const imported = new RegExp(`import \\{[^}]*\\b${name}\\b(?: as (\\w+))?[^}]*\\}`);
  return [...files].flatMap(([path, text]) => {
    if (path === home || text.includes(`/${stem}')`)) return [{ alias: name, text }];
    const found = imported.exec(text);
    return found === null ? [] : [{ alias: found[1] ?? name, text }];
  });
}

/** `words.title`, or `words[rule]` in a file that can mean it: dynamic names count for all. */
const names = (alias, member, text) =>
  new RegExp(`\\b${alias}(?:\\??\\.${member}\\b|\\[|\\)| in\\b|['"]\\])`).test(text.replace(/^import .*$/gm, ''));

/** Path → text of everything that can hold texts or name them. */
async function sourceFiles() {
  const paths = [
    ...(await readdir(join(root, 'src'), { recursive: true })).map((path) => `src/${path}`),
    ...(await readdir(join(root, 'courses'), { recursive: true })).map((path) => `courses/${path}`),
    ...(await readdir(join(root, 'scripts/robot-template'), { recursive: true })).map(
      (path) => `scripts/robot-template/${path}`,
    ),
  ].map((path) => path.replaceAll('\\', '/'));
  const wanted = paths.filter(
    (path) =>
      (/^(src|scripts)\/.*\.(ts|vue)$/.test(path) && !/\.test\.ts$|\.d\.ts$|\/testing\//.test(path)) ||
      WORDS.test(path) ||
      path.endsWith('texts.json'),
  );
  /** @type {Map<string, string>} */
  const files = new Map();
  for (const path of wanted) files.set(path, await readFile(join(root, path), 'utf8'));
  return files;
}

await main(import.meta.url, async () => {
  const files = await sourceFiles();
  const problems = problemsOf(files, sameWords);
  if (problems.length > 0) throw new Failure(`${problems.length} problems with texts:\n${problems.join('\n')}`);
  note(`Texts of ${files.size} files: complete in ${LANGUAGES.length} languages, all used.`);
});
