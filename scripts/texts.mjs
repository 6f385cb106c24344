// Checks the texts of the app: all languages, the same places for values, nothing left untranslated, nothing unused.
import { readdir, readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import ts from 'typescript';
import { Failure, main, note, root } from './progress.mjs';
import { sameWords } from './texts-same.mjs';

const LANGUAGES = ['de', 'fr', 'it', 'en'];
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
  const entries = entriesIn(files, trees, catalogues);
  return [
    ...entries.flatMap((entry) => wrongIn(entry, same)),
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
  new Map([...files].filter(([path]) => !path.endsWith('.json')).map(([path, text]) => [path, treeOf(path, text)]));

/** @returns {Entry[]} */
const entriesIn = (files, trees, catalogues) => [
  ...catalogues.flatMap(({ entries }) => entries),
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
  ].map((path) => path.replaceAll('\\', '/'));
  const wanted = paths.filter(
    (path) =>
      (/^src\/.*\.(ts|vue)$/.test(path) && !/\.test\.ts$|\.d\.ts$|\/testing\//.test(path)) ||
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
