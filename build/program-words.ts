/** Finds what the words beside programs lack, have too many, or break. */
import { existsSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { LANGUAGES, type Language } from '../src/core/languages.ts';
import { isText, piecesOf, translate, wordsFile, wordsFor, type Translation, type Words } from './programs.ts';

/** Strings with a word in them that a program knows and nobody reads: gestures, columns of a table, an order of bytes, a colour. */
const CODE = new Set(['shake', 'light', 'temperature', 'little', 'red']);
const WORD = /\p{L}{3}/u;

/**
 * The faults of the translations of the programs in a folder, a line each.
 *
 * @param folder one with Python files and `words/<language>.json`
 */
export async function wordProblems(folder: string): Promise<string[]> {
  const files = (await readdir(folder)).filter((name) => name.endsWith('.py')).map((name) => join(folder, name));
  const sources = await Promise.all(files.map((file) => readFile(file, 'utf8')));
  const programs = files.map((file, at) => ({ file, source: sources[at] ?? '' }));
  const problems = await Promise.all(LANGUAGES.map((language) => problemsIn(folder, programs, language)));
  return problems.flat();
}

interface Program {
  readonly file: string;
  readonly source: string;
}

async function problemsIn(folder: string, programs: readonly Program[], language: Language): Promise<string[]> {
  const place = wordsFile(join(folder, 'any.py'), language);
  if (!existsSync(place)) return [`${place} is missing`];
  const all = JSON.parse(await readFile(place, 'utf8')) as Words;
  const said = await Promise.all(programs.map(async ({ file }) => (await wordsFor(file, language)).program ?? {}));
  if (language === 'en') return said.some((own) => Object.keys(own).length > 0) ? [`${place} translates English`] : [];
  const used = new Set(programs.flatMap(({ source }) => piecesOf(source).map(({ text }) => text)));
  const names = new Set(programs.map(({ file }) => basename(file, '.py')));
  const strangers = Object.entries(all).flatMap(([name, own]) =>
    typeof own === 'object' && !isText(own) && name !== 'program' && !names.has(name) ? [`there is no ${name}.py`] : [],
  );
  const unused = said.flatMap((own) => Object.keys(own).filter((text) => !used.has(text)));
  const problems = [
    ...strangers,
    ...new Set(unused.map((text) => `no program says “${text}”`)),
    ...programs.flatMap(({ source }, at) => problemsOf(source, said[at] ?? {})),
  ];
  return [...new Set(problems)].map((problem) => `${place}: ${problem}`);
}

function problemsOf(source: string, said: Translation): string[] {
  const pieces = piecesOf(source);
  const missing = pieces.filter(({ kind, text }) => {
    const isShown = kind === 'comment' || (WORD.test(text) && !CODE.has(text));
    return isShown && !Object.hasOwn(said, text);
  });
  const untranslated = pieces.filter(({ text }) => text.includes(' ') && said[text] === text);
  const expected = pieces.flatMap(({ text }) => (said[text] ?? text).split('\n# '));
  const found = piecesOf(translate(source, said)).map(({ text }) => text);
  const broken = expected.filter((text, at) => text !== found[at]).slice(0, 1);
  return [
    ...missing.map(({ text }) => `no translation of “${text}”`),
    ...untranslated.map(({ text }) => `“${text}” is the same as English`),
    ...broken.map((text) => `the program is broken by “${text}”`),
  ];
}
