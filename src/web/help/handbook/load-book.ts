import type { Language } from '../../kit/i18n';
import type { Book, Chapter, Section } from './book';

/** The books by their files: a language is loaded when it is read. */
const handbooks = import.meta.glob<Book>('./texts/*.md', { import: 'default' });
const sheets = import.meta.glob<Book>('./sheet/*.md', { import: 'default' });

/** The handbook in a language. Rejects without a connection. */
export const loadHandbook = (language: Language): Promise<Book> =>
  handbooks[`./texts/${language}.md`]?.() ?? Promise.resolve([]);

/** The sheet on data protection in a language. Rejects without a connection. */
export const loadSheet = (language: Language): Promise<Book> =>
  sheets[`./sheet/${language}.md`]?.() ?? Promise.resolve([]);

/** A section with its chapter, and the number of that chapter. */
export interface Place {
  readonly chapter: Chapter;
  readonly section: Section;
  readonly number: number;
}

/** All sections of a book in the order in which they are read. */
export const placesIn = (book: Book): readonly Place[] =>
  book.flatMap((chapter, at) => chapter.sections.map((section) => ({ chapter, section, number: at + 1 })));

/** The id of a section in the page's address. The first one of a chapter is the chapter's. */
export const addressOf = ({ chapter, section }: Place): string =>
  chapter.sections[0] === section ? chapter.id : `${chapter.id}.${section.id}`;
