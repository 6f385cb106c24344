import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

import { LANGUAGES, type Language } from '../src/core/languages.ts';
import type { FeaturePage } from '../src/web/kit/features/feature-page.ts';
import type { Book } from '../src/web/help/handbook/book.ts';
import { readBook, referencesIn, wordOf } from './handbook.ts';

const FOLDERS = ['texts', 'sheet'] as const;
const pathOf = (folder: string, language: Language): string =>
  fileURLToPath(new URL(`../src/web/help/handbook/${folder}/${language}.md`, import.meta.url));
const sourceOf = (folder: string, language: Language): string =>
  readFileSync(pathOf(folder, language), 'utf8').replace(/<!--[^]*?-->/g, '');
const bookOf = (folder: string, language: Language): Book => readBook(sourceOf(folder, language), language);
/** Chapters and sections by their ids, with the places that they lead to. */
const shapeOf = (book: Book): readonly string[] =>
  book.flatMap((chapter) => chapter.sections.map(({ id, show }) => `${chapter.id}.${id} → ${show}`));
/** The pages of the app, by the names in their addresses. */
const pages = Object.values(
  import.meta.glob<readonly FeaturePage[]>('../src/web/**/pages.ts', { import: 'pages', eager: true }),
).flatMap((all) => all.map(({ name }) => name));

describe('a book of the help', () => {
  it('has chapters, sections with text and advice, and words of the page in bold', () => {
    const source =
      '# one: Erstes\n\n## a: Anfang\nshow: task\n\nDrück {kit:bar.run}.\n\n> Zu zweit.\n> Oder zu dritt.\n';
    expect(readBook(source, 'de')).toEqual([
      {
        ...{ id: 'one', title: 'Erstes' },
        sections: [
          ...[
            {
              id: 'a',
              title: 'Anfang',
              show: 'task',
              text: 'Drück **Simulieren**.',
              tip: 'Zu zweit. Oder zu dritt.',
              picture: 'handbook/de-task.webp',
            },
          ],
        ],
      },
    ]);
  });

  it('shows a picture of a place in the first section of a chapter about it, in its language, if there is one', () => {
    const section = (id: string, show: string): string => `## ${id}: S\nshow: ${show}\n\nText\n\n`;
    const source = `# one: A\n\n${section('a', '@build')}${section('b', '@build')}# two: B\n\n${section('c', '@build')}${section('d', 'nowhere')}`;
    const pictures = readBook(source, 'fr').flatMap(({ sections }) => sections.map(({ picture }) => picture));
    expect(pictures).toEqual(['handbook/fr-build.webp', '', 'handbook/fr-build.webp', '']);
  });

  it('leaves away the dots of a button that opens something', () =>
    expect(wordOf('kit', 'menu.toDevice', 'de')).toBe('Auf den Roboter'));

  it('refuses a word that the page does not have, and one with places for values', () => {
    expect(() => wordOf('kit', 'bar.nothing', 'de')).toThrow('The page has no word {kit:bar.nothing} in de.');
    expect(() => wordOf('nowhere', 'title', 'de')).toThrow('{nowhere:title}');
    expect(() => wordOf('kit', 'bar.achieved', 'de')).toThrow('places for values');
  });

  it('refuses a line outside of a section', () =>
    expect(() => readBook('# one: Erstes\n\nText', 'de')).toThrow('Outside of a section: Text'));
});

describe.each(FOLDERS)('the book %s', (folder) => {
  it('has the same chapters and sections in every language, and leads to the same places', () => {
    const german = shapeOf(bookOf(folder, 'de'));
    expect(new Set(german).size).toBe(german.length);
    for (const language of LANGUAGES) expect(shapeOf(bookOf(folder, language)), language).toEqual(german);
  });

  it('names the same words of the page in every language', () => {
    const namesIn = (language: Language): readonly string[] => [
      ...new Set(referencesIn(sourceOf(folder, language)).map((reference) => reference.join(':'))),
    ];
    const german = namesIn('de').toSorted();
    for (const language of LANGUAGES) expect(namesIn(language).toSorted(), language).toEqual(german);
  });

  it('writes no name of a button by hand: bold and quotes are for the words of the page', () => {
    for (const language of LANGUAGES) expect(sourceOf(folder, language).match(/\*\*|[«»„“”"]/g), language).toBeNull();
  });

  it('says nothing in two languages alike', () => {
    for (const language of LANGUAGES) {
      const texts = bookOf(folder, language).flatMap(({ sections }) => sections.map(({ text }) => text));
      const others = LANGUAGES.filter((other) => other !== language).flatMap((other) =>
        bookOf(folder, other).flatMap(({ sections }) => sections.map(({ text }) => text)),
      );
      expect(
        texts.filter((text) => text === '' || others.includes(text)),
        language,
      ).toEqual([]);
    }
  });

  it('spells German the Swiss way, and puts narrow spaces where French has them', () => {
    expect(sourceOf(folder, 'de')).not.toContain('ß');
    const french = bookOf(folder, 'fr').flatMap(({ sections }) => sections.flatMap(({ title, text }) => [title, text]));
    expect(french.join('\n').match(/.{10}(?: [;:?!]|[\p{L})*][;?!]).{0,10}|exercice/giu)).toBeNull();
  });
});

describe('the handbook', () => {
  it('leads to pages that there are, and to modes of the arena', () => {
    const wished = bookOf('texts', 'de').flatMap(({ sections }) => sections.map(({ show }) => show));
    const known = new Set(['', '@drive', '@build', ...pages]);
    expect(wished.filter((show) => !known.has(show.replace(/\/.*/, '')))).toEqual([]);
    expect(pages).toContain('handbook');
  });

  it('names files of the repository that there are', () => {
    const files = Array.from(sourceOf('texts', 'de').matchAll(/`(docs\/[^`]+)`/g), ([, file = '']) => file);
    expect(files.length).toBeGreaterThan(0);
    for (const file of files)
      expect(existsSync(fileURLToPath(new URL(`../${file}`, import.meta.url))), file).toBe(true);
  });
});
