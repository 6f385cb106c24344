/**
 * Programs that come with the app: those of courses, of robots' examples, of the microcomputer's samples. Each is kept once,
 * in English. `words/<language>.json` beside it holds what a language says about it (`title` and the like) and, under
 * `program`, each of its comments and strings → its translation, both without `# ` and quotes. Where a folder has several
 * programs, each has a member named after it (`line` for `line.py`), unless they share all words, as those of a course do.
 *
 * `import line from './line.py?languages'` gives the program in every language. The code cannot differ between them.
 */
import { readFile } from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import type { Plugin } from 'vite';
import { LANGUAGES, type Language, type Texts } from '../src/core/languages.ts';

/** A program's comments and strings: English → translation. */
export type Translation = Readonly<Record<string, string>>;

/** The content of a file of words; each member belongs to one program. */
export interface Words {
  readonly program?: Translation;
  readonly [name: string]: Text | Translation | Words | undefined;
}

/** A text about a program, or several of a kind. */
export type Text = string | readonly string[];

/** A program in every language, and the texts about it by their names. */
export interface ReadyProgram {
  /** Name of its file. */
  readonly file: string;
  readonly source: Texts;
  readonly texts: Readonly<Record<string, Readonly<Record<Language, Text>>>>;
}

/** A comment (its mark, its text) or a string (its quotes, its text), whichever begins first. */
const PIECES = /(# ?)(.*)|("""|["'])((?:\\[^]|(?!\3)[^\\])*)\3/g;

/** A comment or a string of a program. */
export interface Piece {
  readonly kind: 'comment' | 'string';
  readonly text: string;
}

/** The comments and strings of a program, in their order. */
export const piecesOf = (source: string): Piece[] =>
  [...source.matchAll(PIECES)].map(([, mark, comment = '', , text = '']) =>
    mark === undefined ? { kind: 'string', text } : { kind: 'comment', text: comment },
  );

/**
 * A program with its comments and strings in another language. What has no translation stays as it is.
 *
 * @param translation that of a comment may run over several lines, each of which but the first begins with `# `
 */
export function translate(source: string, translation: Translation): string {
  const words = new Map(Object.entries(translation));
  const say = (text: string): string => words.get(text) ?? text;
  return source.replace(PIECES, (_, ...[mark, comment = '', quotes = '', text = '']: (string | undefined)[]) =>
    mark === undefined ? quotes + say(text) + quotes : mark + say(comment),
  );
}

/** The file of words in a language that lies beside a program. */
export const wordsFile = (path: string, language: Language): string => join(dirname(path), 'words', `${language}.json`);

/** The texts of a program in one language; empty if the file of words is missing. */
export async function wordsFor(path: string, language: Language): Promise<Words> {
  const all = JSON.parse(await readFile(wordsFile(path, language), 'utf8').catch(() => '{}')) as Words;
  const own = all[basename(path, '.py')];
  return typeof own === 'object' && !isText(own) ? own : all;
}

/** Reads a program and the words beside it. What a language lacks is in English. */
export async function readProgram(path: string, languages = LANGUAGES): Promise<ReadyProgram> {
  const english = await readFile(path, 'utf8');
  const words = new Map<Language, Words>();
  for (const language of languages) words.set(language, await wordsFor(path, language));
  const inEvery = <T extends Text>(make: (words: Words | undefined) => T) =>
    Object.fromEntries(languages.map((language) => [language, make(words.get(language))])) as Record<Language, T>;
  const about = Object.entries(words.get('en') ?? {}).flatMap(([name, text]) =>
    isText(text) ? [[name, inEvery((own) => textOf(own?.[name]) ?? text)] as const] : [],
  );
  return {
    file: basename(path),
    source: inEvery((own) => translate(english, own?.program ?? {})),
    texts: Object.fromEntries(about),
  };
}

/** Not further members of words. */
export const isText = (value: unknown): value is Text => typeof value === 'string' || Array.isArray(value);
const textOf = (value: unknown): Text | undefined => (isText(value) ? value : undefined);

const QUERY = '?languages';

/** Makes a module of each `….py?languages`: `source`, `file` and the texts about it, each also by its name. */
export function programs(): Plugin {
  return {
    name: 'programs',
    async load(id) {
      if (!id.endsWith(`.py${QUERY}`)) return null;
      const path = id.slice(0, -QUERY.length);
      for (const file of [path, ...LANGUAGES.map((language) => wordsFile(path, language))]) this.addWatchFile(file);
      const { texts, ...program } = await readProgram(path);
      const members = Object.entries({ ...program, ...texts });
      const lines = members.map(([name, value]) => `export const ${name} = ${JSON.stringify(value)};`);
      const code = [...lines, `export default { ${members.map(([name]) => name).join(', ')} };`].join('\n');
      return { code, map: null, moduleType: 'js' };
    },
  };
}
