/**
 * The books of the help: `<language>.md` in a folder of `src/web/help/handbook`, which a translator reads and writes as it is.
 *
 * - `# id: Title` begins a chapter, `## id: Title` a section of it; ids are the same in every language.
 * - `show: address` below a section's title names the page it is about; `show: @build` a mode of the arena.
 * - The first section of a chapter that shows a place has its picture, taken of the real page by `npm run handbook -- --pictures` into
 *   `src/web/help/handbook/pictures`.
 * - `> ` begins a piece of advice. All else is text in the small markup of tasks.
 * - `{room:name}` is a word of the page by its place in the words of a room, such as `{kit:bar.run}`: no name of a button is
 *   written by hand. Words that lie in a piece are named with their folder: `{pupil/works/words/notice:title}`.
 *
 * `import book from './texts/de.md'` gives a book with all words in their places.
 */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { PICTURES, pictureName } from '../scripts/handbook-pictures.mjs';
import type { Language } from '../src/core/languages.ts';
import type { Book, Chapter, Section } from '../src/web/help/handbook/book.ts';
import type { Catalogue } from './words.ts';

const BOOK = /\/help\/handbook\/\w+\/(\w+)\.md$/;
const WEB = fileURLToPath(new URL('../src/web', import.meta.url));
const WORD = /\{([\w/-]+):([\w.-]+)\}/g;
const HEAD = /^(##?) ([\w-]+): (.+)$/;
const SHOW = /^show: (\S+)$/;

/** A section while it is read. */
interface Open {
  readonly id: string;
  readonly title: string;
  show: string;
  readonly lines: string[];
  readonly tips: string[];
}

/** The file with the words of a room, or of a piece of them. */
export function wordsPath(room: string, language: Language): string {
  const folder = room.includes('/words/') ? room : `${room}/words`;
  return join(WEB, folder, `${language}.json`);
}

/** A book without its notes for translators. */
const withoutNotes = (text: string): string => text.replace(/<!--[^]*?-->/g, '');

/** All references to words of the page in a text, as room and name. */
export const referencesIn = (text: string): readonly (readonly [room: string, name: string])[] =>
  Array.from(withoutNotes(text).matchAll(WORD), ([, room = '', name = '']) => [room, name] as const);

/**
 * A word of the page, without the dots of a button that opens something.
 *
 * @throws if the page has no such word, or one with places for values
 */
export function wordOf(room: string, name: string, language: Language): string {
  const path = wordsPath(room, language);
  const all: Catalogue = existsSync(path) ? (JSON.parse(readFileSync(path, 'utf8')) as Catalogue) : {};
  const found = name
    .split('.')
    .reduce<Catalogue | undefined>((at, step) => (typeof at === 'object' ? at[step] : undefined), all);
  if (typeof found !== 'string') throw new Error(`The page has no word {${room}:${name}} in ${language}.`);
  if (/[{*]/.test(found)) throw new Error(`The word {${room}:${name}} has places for values: ${found}`);
  return found.replace(/\s*…$/, '');
}

/** The addresses of the pictures that the sections of a chapter have: of each place where it is shown first. */
function createPictures(language: Language, folder: string): (show: string) => string {
  const shown = new Set<string>();
  return (show) => {
    const name = pictureName(show, language);
    if (show === '' || shown.has(show) || !existsSync(join(folder, name))) return '';
    shown.add(show);
    return `handbook/${name}`;
  };
}

/** Reads a book. @throws where a line stands outside of a section, or a word is none of the page's */
export function readBook(source: string, language: Language, pictures = PICTURES): Book {
  const chapters: { id: string; title: string; sections: Open[] }[] = [];
  for (const line of withoutNotes(source).split(/\r?\n/)) {
    const [, marks, id = '', title = ''] = HEAD.exec(line) ?? [];
    const section = chapters.at(-1)?.sections.at(-1);
    if (marks === '#') chapters.push({ id, title, sections: [] });
    else if (marks === '##') chapters.at(-1)?.sections.push({ id, title, show: '', lines: [], tips: [] });
    else if (section !== undefined) readLine(line, section);
    else if (line.trim() !== '') throw new Error(`Outside of a section: ${line}`);
  }
  const told = (text: string): string =>
    text.replace(WORD, (_, room: string, name: string) => `**${wordOf(room, name, language)}**`);
  return chapters.map(({ id, title, sections }): Chapter => {
    const picture = createPictures(language, pictures);
    return {
      ...{ id, title: told(title).replaceAll('**', '') },
      sections: sections.map((one): Section => ({
        ...{ id: one.id, title: told(one.title).replaceAll('**', ''), show: one.show },
        ...{ text: told(one.lines.join('\n').trim()), tip: told(one.tips.join(' ').trim()) },
        picture: picture(one.show),
      })),
    };
  });
}

function readLine(line: string, section: Open): void {
  const [, show] = SHOW.exec(line) ?? [];
  if (show !== undefined) section.show = show;
  else if (line.startsWith('> ')) section.tips.push(line.slice(2));
  else section.lines.push(line);
}

/** Puts the pictures beside the page. They are fetched by who reads the section; the single file has none. */
export function handbookPictures(): Plugin {
  return {
    name: 'handbook-pictures',
    apply: 'build',
    generateBundle() {
      for (const name of existsSync(PICTURES) ? readdirSync(PICTURES) : [])
        this.emitFile({ type: 'asset', fileName: `handbook/${name}`, source: readFileSync(join(PICTURES, name)) });
    },
  };
}

/** Makes a module of each book. */
export function handbook(): Plugin {
  return {
    name: 'handbook',
    enforce: 'pre',
    load(id) {
      const language = BOOK.exec(id.replaceAll('\\', '/'))?.[1];
      if (language === undefined) return null;
      const source = readFileSync(id, 'utf8');
      for (const [room] of referencesIn(source)) this.addWatchFile(wordsPath(room, language as Language));
      try {
        const book = readBook(source, language as Language);
        return { code: `export default ${JSON.stringify(book)};`, map: null, moduleType: 'js' };
      } catch (error) {
        return this.error(`${basename(id)}: ${error instanceof Error ? error.message : String(error)}`);
      }
    },
  };
}
